import { Vector2, type Vector3 } from "three";
import { show } from "../dom";
import type { Session } from "../session";
import { Drag, pick, toClip, toPixels } from "./drag";
import type { Handle, Handles } from "./handles";
import type { PolePopup } from "./popup";
import { decimalStep, roundStep } from "./space";
import type { Stage } from "./stage";

/** The snapping grid is about this many pixels wide. */
const SNAP_PIXELS = 22;

interface Gesture {
  handle: Handle;
  drag: Drag;
  last: Vector3;
  step: number;
  /** Where the canvas lies on the page, asked for once. */
  box: DOMRect;
  begun: Promise<void> | null;
}

/** Lets the pointer drag poles: one gesture is one step of the history. */
export class PoleDrag {
  snap = false;
  private gesture: Gesture | null = null;
  private readonly label: HTMLElement;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly stage: Stage,
    private readonly handles: Handles,
    private readonly session: Session,
    private readonly popup: PolePopup,
    label: HTMLElement,
  ) {
    this.label = label;
    // Before the orbit controls see the pointer: a pole under it takes precedence.
    canvas.addEventListener("pointerdown", (event) => this.down(event), { capture: true });
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.up(event));
    canvas.addEventListener("pointercancel", (event) => this.up(event));
    canvas.addEventListener("dblclick", (event) => this.type(this.under(event)));
    session.store.on("poles", () => this.showLabel());
  }

  get active(): boolean {
    return this.gesture !== null;
  }

  /** Opens the popup for a pole. */
  type(handle: Handle | null): void {
    if (!handle) return;
    const at = this.pixels(handle.at);
    this.popup.show({
      address: handle.address,
      pole: handle.pole,
      x: at.x,
      y: at.y,
      apply: (texts) => this.session.change("typePole", handle.address, handle.pole.index, texts),
    });
  }

  private under(event: PointerEvent | MouseEvent): Handle | null {
    if (!this.handles.group.visible) return null;
    return pick(this.handles.all, this.pointer(event), (at) => this.pixels(at));
  }

  private pixels(at: Vector3): Vector2 {
    return toPixels(at, this.stage.cameras, this.stage.width, this.stage.height);
  }

  private pointer(event: MouseEvent, box = this.canvas.getBoundingClientRect()): Vector2 {
    return new Vector2(event.clientX - box.left, event.clientY - box.top);
  }

  private clip(event: MouseEvent, box: DOMRect): Vector2 {
    const { x, y } = this.pointer(event, box);
    return toClip(x, y, this.stage.width, this.stage.height);
  }

  private down(event: PointerEvent): void {
    const handle = event.button === 0 ? this.under(event) : null;
    if (!handle) return;
    event.stopImmediatePropagation();
    this.popup.close();
    this.canvas.setPointerCapture(event.pointerId);
    const pixel = this.stage.cameras.pixel(handle.at, this.stage.height);
    const step = this.snap ? roundStep(pixel * SNAP_PIXELS) : decimalStep(pixel);
    const start = handle.at.clone();
    const box = this.canvas.getBoundingClientRect();
    const drag = new Drag(start, this.stage.cameras, this.clip(event, box));
    this.gesture = { handle, drag, last: start, step, box, begun: null };
    this.canvas.dataset["dragging"] = "";
  }

  private move(event: PointerEvent): void {
    const { gesture } = this;
    if (!gesture) {
      this.canvas.style.cursor = event.buttons === 0 && this.under(event) ? "grab" : "";
      return;
    }
    gesture.last = gesture.drag.to(this.clip(event, gesture.box), event.shiftKey);
    gesture.begun ??= this.session.beginDrag(this.request(gesture, gesture.drag.start));
    this.session.drag(this.request(gesture, gesture.last));
  }

  private up(event: PointerEvent): void {
    const { gesture } = this;
    if (!gesture) return;
    this.gesture = null;
    delete this.canvas.dataset["dragging"];
    this.canvas.releasePointerCapture(event.pointerId);
    show(this.label, false);
    if (gesture.begun) void this.session.endDrag(this.request(gesture, gesture.last));
  }

  private request(gesture: Gesture, to: Vector3): Parameters<Session["drag"]>[0] {
    const { address, pole } = gesture.handle;
    return { address, index: pole.index, to: this.stage.cameras.space.toSheet(to), step: gesture.step };
  }

  /** Shows the coordinates of the dragged pole beside it, as the kernel has written them. */
  private showLabel(): void {
    const { gesture } = this;
    if (!gesture) return;
    const { address, pole } = gesture.handle;
    const now = this.session.store.poles
      .get(address)
      ?.poles.find((other) => other.index.join() === pole.index.join());
    if (!now) return;
    const at = this.pixels(gesture.last);
    const text = now.coordinates.join("   ");
    if (this.label.textContent !== text) this.label.textContent = text;
    this.label.style.transform = `translate(${at.x + 14}px, ${at.y - 30}px)`;
    show(this.label, true);
  }
}
