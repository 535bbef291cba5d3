import { EngineFailure, type EngineClient } from "./engine/client";
import { LatestWins } from "./engine/latest";
import type { Address, Answer, Arguments, Camera, ExportFormat, Method, Style, Update } from "./engine/protocol";
import { type Phrase, t } from "./i18n";
import { keep, renewId } from "./keep";
import type { Store } from "./store";

/** What the session tells the person. */
export interface Notices {
  error(title: string, message: string, hint?: string | null): void;
  info(message: string): void;
  kept(phrase: Phrase): void;
}

type Changing = { [M in Method]: Answer<M> extends Update ? M : never }[Method];

export interface Move {
  address: Address;
  index: number[];
  to: number[];
  step: number;
}

/** One open sheet: sends what the person does to the kernel, and takes in the answers. */
export class Session {
  /** The sheet as it was after the last change that succeeded. */
  private lastGood = "";
  private readonly keeper = new LatestWins<void>(() => this.keepNow());
  private readonly mover = new LatestWins<Move>((move) => this.moveNow(move));

  constructor(
    readonly store: Store,
    readonly client: EngineClient,
    private readonly notices: Notices,
  ) {}

  /** Any call that changes the sheet. Answers whether it succeeded. */
  async change<M extends Changing>(method: M, ...args: Arguments<M>): Promise<boolean> {
    const update = await this.ask(method, ...args);
    if (!update) return false;
    this.store.apply(update as Update);
    this.keeper.push();
    return true;
  }

  /** Any call; null when it failed, and then the person has been told. */
  async ask<M extends Method>(method: M, ...args: Arguments<M>): Promise<Answer<M> | null> {
    try {
      return await this.client.call(method, ...args);
    } catch (error) {
      await this.failed(error);
      return null;
    }
  }

  /** Replaces the sheet; the present one stays in the gallery. */
  async open(text: string, own = false): Promise<boolean> {
    await this.keeper.idle();
    const update = await this.ask("open", text);
    if (!update) return false;
    if (!own) renewId();
    this.lastGood = text;
    this.store.apply(update);
    this.store.select({ column: 0, row: 0 });
    return true;
  }

  async importFile(name: string, bytes: Uint8Array): Promise<boolean> {
    await this.keeper.idle();
    const update = await this.ask("importFile", name, bytes);
    if (!update) return false;
    if (update.whole) renewId();
    this.store.apply(update);
    this.keeper.push();
    return true;
  }

  setStyle(address: Address, style: Style | null): Promise<boolean> {
    return this.change("setStyle", address, style);
  }

  /** A drag under way: only the newest place is computed. */
  drag(move: Move): void {
    this.mover.push(move);
  }

  async beginDrag(move: Move): Promise<void> {
    await this.change("movePole", move.address, move.index, move.to, move.step, "begin");
  }

  async endDrag(move: Move): Promise<void> {
    await this.mover.idle();
    await this.change("movePole", move.address, move.index, move.to, move.step, "end");
  }

  /** Ends a computation that takes too long; its change is taken back. */
  stop(): void {
    this.client.restart({ message: t("stopped"), hint: null, fatal: true });
  }

  async setCamera(camera: Camera): Promise<void> {
    await this.ask("setCamera", camera);
    this.keeper.push();
  }

  async export(format: ExportFormat): Promise<Uint8Array | null> {
    return this.ask("exportFile", format);
  }

  /** Resolves when the sheet is safe. */
  settled(): Promise<void> {
    return this.keeper.idle();
  }

  private async moveNow(move: Move): Promise<void> {
    const update = await this.ask("movePole", move.address, move.index, move.to, move.step, "during");
    if (update) this.store.apply(update);
  }

  private async keepNow(): Promise<void> {
    const text = await this.ask("save");
    if (text === null) return;
    this.lastGood = text;
    try {
      await keep(this.store.title || t("untitled"), text);
      this.notices.kept("saved");
    } catch {
      this.notices.kept("notSaved");
    }
  }

  private recovering = false;

  private async failed(error: unknown): Promise<void> {
    if (!(error instanceof EngineFailure)) throw error;
    const { message, hint, fatal } = error.failure;
    if (!fatal) {
      this.notices.error(t("cannotDo"), message, hint);
      return;
    }
    if (this.recovering) return;
    this.recovering = true;
    if (message === t("stopped")) this.notices.info(message);
    else this.notices.error(t("cannotDo"), t("crashed", { message }), hint);
    try {
      this.store.apply(await this.client.call("open", this.lastGood));
    } finally {
      this.recovering = false;
    }
  }
}
