import { el } from "../dom";
import type { EngineClient } from "../engine/client";
import type { Update } from "../engine/protocol";
import { redrawn } from "../engine/redraw";
import { Stage } from "./stage";

const WIDTH = 260;
const HEIGHT = 168;

/** A sheet to be pictured: a `.pfs` text, or a kept one with its history. */
export interface Pictured {
  method: "open" | "resume";
  text: string;
}

/** Small pictures of sheets, computed by a kernel of their own so that the open sheet is not disturbed. */
export class Thumbnails {
  private readonly pictures = new Map<string, string>();
  private client: EngineClient | null = null;
  private stage: Stage | null = null;
  private readonly host = el("div", { class: "thumbnail-host", aria: { hidden: "true" } });

  constructor(private readonly start: () => EngineClient) {}

  /** The address of a picture, made now or earlier; null when there is none to be had. */
  async picture(sheet: Pictured): Promise<string | null> {
    const known = this.pictures.get(sheet.text);
    if (known) return known;
    try {
      this.client ??= this.start();
      const update = await this.client.call(sheet.method, sheet.text);
      const picture = await this.draw(update);
      if (picture) this.pictures.set(sheet.text, picture);
      return picture;
    } catch {
      return null;
    }
  }

  /** Forgets all pictures, as when the colours of the page change. */
  clear(): void {
    for (const address of this.pictures.values()) URL.revokeObjectURL(address);
    this.pictures.clear();
  }

  private async draw(update: Update): Promise<string | null> {
    const stage = this.ready();
    for (const address of [...stage.drawn]) stage.put(address, undefined);
    for (const drawing of update.drawings) stage.put(drawing.address, redrawn(drawing));
    stage.stand(update.camera?.up ?? "y");
    stage.cameras.restore(update.camera ?? {}, stage.bounds());
    stage.setGround(getComputedStyle(this.host).backgroundColor);
    stage.cameraChanged();
    const blob = await stage.picture();
    return blob && URL.createObjectURL(blob);
  }

  private ready(): Stage {
    if (this.stage) return this.stage;
    this.host.style.width = `${WIDTH}px`;
    this.host.style.height = `${HEIGHT}px`;
    const canvas = el("canvas");
    this.host.append(canvas);
    document.body.append(this.host);
    this.stage = new Stage(canvas);
    return this.stage;
  }
}
