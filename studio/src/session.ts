import { EngineFailure, type EngineClient } from "./engine/client";
import { LatestWins } from "./engine/latest";
import type { Address, Answer, Arguments, Camera, Failure, Gesture, Method, Style, Update } from "./engine/protocol";
import { language, type Phrase, t } from "./i18n";
import { keep, renewId } from "./keep";
import type { Store } from "./store";

/** What the session tells the person. */
export interface Notices {
  error(title: string, message: string, hint?: string | null): void;
  info(message: string): void;
  kept(phrase: Phrase): void;
}

/** How long a computation may take to end when asked to, in milliseconds. */
const PATIENCE = 500;

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
  private proceeding: Promise<void> | null = null;
  private halted = false;
  /** A gesture of several changes is under way. */
  private dragging = false;
  private readonly keeper = new LatestWins<void>(() => this.keepNow());
  private readonly styler = new LatestWins<{ address: Address; style: Style }>((one) => this.styleNow(one));
  private readonly mover = new LatestWins<Move>((move) => this.moveNow(move, "during"));

  constructor(
    readonly store: Store,
    readonly client: EngineClient,
    private readonly notices: Notices,
  ) {
    client.onLost = (reason) => void this.recover(reason);
  }

  /** Any call that changes the sheet. Answers whether it succeeded. */
  async change<M extends Changing>(method: M, ...args: Arguments<M>): Promise<boolean> {
    const update = await this.ask(method, ...args);
    if (!update) return false;
    this.take(update as Update);
    this.keeper.push();
    return true;
  }

  /** Takes in an answer; when it left cells to be computed, goes on with them. */
  private take(update: Update, live = false): void {
    this.store.apply(update, live);
    this.halted = false;
    if (update.pending > 0) this.proceeding ??= this.proceed();
  }

  /** Computes in slices, so that newer wishes are heard between them. */
  private async proceed(): Promise<void> {
    const release = this.client.hold();
    for (;;) {
      const update = this.halted ? null : await this.ask("proceed");
      if (update) this.store.apply(update, this.dragging);
      if (!update?.pending) break;
    }
    release();
    this.proceeding = null;
  }

  /** Any call; null when it failed, and then the person has been told. */
  async ask<M extends Method>(method: M, ...args: Arguments<M>): Promise<Answer<M> | null> {
    try {
      return await this.client.call(method, ...args);
    } catch (error) {
      this.failed(error);
      return null;
    }
  }

  /** Replaces the sheet by a `.pfs` text; the present one stays in the gallery. */
  async open(text: string): Promise<boolean> {
    return this.replace("open", text);
  }

  /** Replaces the sheet by a kept one, with its history. `own`: it is this tab's own sheet. */
  async resume(snapshot: string, own: boolean): Promise<boolean> {
    return this.replace("resume", snapshot, own);
  }

  async importFile(name: string, bytes: Uint8Array): Promise<boolean> {
    await this.keeper.idle();
    const update = await this.ask("importFile", name, bytes);
    if (!update) return false;
    if (update.whole) renewId();
    this.take(update);
    this.keeper.push();
    return true;
  }

  private async replace(method: "open" | "resume", text: string, own = false): Promise<boolean> {
    await this.keeper.idle();
    const update = await this.ask(method, text);
    if (!update) return false;
    if (!own) renewId();
    this.take(update);
    this.store.select({ column: 0, row: 0 });
    this.lastGood = (await this.ask("snapshot")) ?? "";
    return true;
  }

  setStyle(address: Address, style: Style | null): Promise<boolean> {
    return this.change("setStyle", address, style);
  }

  /** A style that follows a slider: all until `endStyle` is one step of the history. */
  styleLive(address: Address, style: Style): void {
    if (!this.dragging) {
      this.dragging = true;
      void this.ask("beginGesture");
    }
    this.styler.push({ address, style });
  }

  async endStyle(address: Address, style: Style): Promise<void> {
    await this.styler.idle();
    if (!this.dragging) {
      await this.setStyle(address, style);
      return;
    }
    await this.styleNow({ address, style });
    this.dragging = false;
    await this.change("endGesture");
  }

  /** A drag under way: only the newest place is computed. */
  drag(move: Move): void {
    this.mover.push(move);
  }

  async beginDrag(move: Move): Promise<void> {
    this.dragging = true;
    await this.moveNow(move, "begin");
  }

  async endDrag(move: Move): Promise<void> {
    await this.mover.idle();
    await this.moveNow(move, "end");
    this.dragging = false;
    this.keeper.push();
  }

  /**
   * Ends a computation that takes too long: between two cells, and then the rest stays uncomputed;
   * or, when a single cell does not end, by force, and then the last change is taken back.
   */
  async stop(): Promise<void> {
    this.halted = true;
    const ended = this.proceeding?.then(() => true) ?? Promise.resolve(false);
    const late = new Promise<boolean>((resolve) => setTimeout(() => resolve(false), PATIENCE));
    if (!(await Promise.race([ended, late]))) {
      this.client.restart({ message: t("stopped"), hint: null, fatal: true });
    }
  }

  async setCamera(camera: Camera): Promise<void> {
    await this.ask("setCamera", camera);
    this.keeper.push();
  }

  /** Resolves when the sheet is safe. */
  settled(): Promise<void> {
    return this.keeper.idle();
  }

  private async styleNow({ address, style }: { address: Address; style: Style }): Promise<void> {
    const update = await this.ask("setStyle", address, style);
    if (update) this.take(update, this.dragging);
  }

  private async moveNow(move: Move, gesture: Gesture): Promise<void> {
    const update = await this.ask("movePole", move.address, move.index, move.to, move.step, gesture);
    if (update) this.take(update, gesture !== "end");
  }

  private async keepNow(): Promise<void> {
    // A snapshot would end the gesture; the end of the drag keeps the sheet anyway.
    if (this.dragging) return;
    const snapshot = await this.ask("snapshot");
    if (snapshot === null) return;
    this.lastGood = snapshot;
    try {
      await keep(this.store.title || t("untitled"), snapshot);
      this.notices.kept("saved");
    } catch {
      this.notices.kept("notSaved");
    }
  }

  private failed(error: unknown): void {
    if (!(error instanceof EngineFailure)) throw error;
    const { message, hint, fatal } = error.failure;
    // After a fatal failure the worker is new: `recover` tells what happened.
    if (!fatal) this.notices.error(t("cannotDo"), message, hint);
  }

  /** Gives a fresh worker the sheet as it was after the last change that succeeded. */
  private async recover(reason: Failure): Promise<void> {
    if (reason.message === t("stopped")) this.notices.info(reason.message);
    else this.notices.error(t("cannotDo"), t("crashed", { message: reason.message }), reason.hint);
    await this.ask("setLanguage", language());
    const update = this.lastGood ? await this.ask("resume", this.lastGood) : null;
    if (update) this.store.apply(update);
  }
}
