import { download, el } from "../dom";
import type { ExportFormat } from "../engine/protocol";
import { t } from "../i18n";
import type { Session } from "../session";
import type { Toasts } from "./toasts";

/** Larger files are refused before they are read. */
const LIMIT = 64 * 1024 * 1024;

const TYPES: Record<ExportFormat, string> = {
  glb: "model/gltf-binary",
  obj: "model/obj",
  stl: "model/stl",
  pov: "text/plain",
};

/** Opening, importing, saving and exporting files. */
export class Files {
  private readonly picker = el("input", { type: "file", accept: ".pfs,.bpt,.json", hidden: true });
  readonly root = this.picker;

  constructor(
    private readonly session: Session,
    private readonly toasts: Toasts,
  ) {
    this.picker.addEventListener("change", () => {
      const file = this.picker.files?.[0];
      if (file) void this.take(file);
      this.picker.value = "";
    });
    this.acceptDrops();
  }

  choose(): void {
    this.picker.click();
  }

  /** Opens a sheet, or imports forms, by the ending of the name. */
  async take(file: File): Promise<void> {
    if (file.size > LIMIT) {
      const size = String(Math.ceil(file.size / 1048576));
      this.toasts.error(
        t("cannotOpen", { name: file.name }),
        t("tooLong", { name: file.name, size, limit: String(LIMIT / 1048576) }),
      );
      return;
    }
    if (file.name.toLowerCase().endsWith(".pfs")) await this.session.open(await file.text());
    else await this.session.importFile(file.name, new Uint8Array(await file.arrayBuffer()));
  }

  async save(): Promise<void> {
    const text = await this.session.ask("save");
    if (text !== null) this.give(`${this.stem()}.pfs`, text, "application/toml");
  }

  async export(format: ExportFormat): Promise<void> {
    if (this.session.store.drawings.size === 0) {
      this.toasts.error(t("cannotDo"), t("nothingToExport"));
      return;
    }
    const files = (await this.session.ask("exportFile", format, this.stem())) ?? [];
    for (const { name, bytes } of files) this.give(name, bytes, TYPES[format]);
  }

  private give(name: string, content: BlobPart, type: string): void {
    download(name, content, type);
    this.toasts.info(t("exported", { name }));
  }

  private stem(): string {
    return fileStem(this.session.store.title) || "pforms";
  }

  private acceptDrops(): void {
    const over = (on: boolean): void => {
      document.body.classList.toggle("dropping", on);
      document.body.dataset["drop"] = t("dropHere");
    };
    document.addEventListener("dragover", (event) => {
      event.preventDefault();
      over(true);
    });
    document.addEventListener("dragleave", (event) => {
      if (!event.relatedTarget) over(false);
    });
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      over(false);
      const file = event.dataTransfer?.files[0];
      if (file) void this.take(file);
    });
  }
}

/** A title as a file name: letters and digits, the rest as dashes. */
export function fileStem(title: string): string {
  return title
    .normalize("NFD")
    .replace(/\p{M}/gu, "")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "");
}
