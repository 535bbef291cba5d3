import { Spherical } from "three";
import { el, show } from "../dom";
import type { Camera, ViewName } from "../engine/protocol";
import { localised, t } from "../i18n";
import type { Session } from "../session";
import { placeOf } from "../sheet/address";
import { toClip } from "./drag";
import { Handles } from "./handles";
import { PolePopup } from "./popup";
import { PoleDrag } from "./poledrag";
import type { Up } from "./space";
import { Stage } from "./stage";
import { ViewTools } from "./tools";

const TURN = Math.PI / 24;
const ZOOM = 1.15;
/** The pointer may move this far and it is still a click. */
const STILL = 4;

/** The 3D view: shows the drawn cells, lets the viewer turn, and poles be dragged. */
export class View {
  private readonly canvas = el("canvas", { tabIndex: 0, role: "application" });
  private readonly label = el("div", { class: "drag-label", hidden: true });
  private readonly nothing = el("p", { class: "nothing", hidden: true });
  private readonly popup = new PolePopup();
  readonly root = el("section", { class: "view" }, this.canvas, this.label, this.nothing, this.popup.root);
  private readonly stage: Stage;
  private readonly handles: Handles;
  private readonly drag: PoleDrag;
  private readonly tools: ViewTools;
  private chosen = -1;
  private press: { x: number; y: number } | null = null;
  /** Until the viewer turns it, the view follows the size of what is drawn. */
  private untouched = true;
  /** The camera the kernel was told of last. */
  private remembered = "";

  constructor(private readonly session: Session) {
    const { store } = session;
    this.stage = new Stage(this.canvas);
    this.handles = new Handles(store, this.stage.cameras.space);
    this.stage.overlay.add(this.handles.group);
    this.drag = new PoleDrag(this.canvas, this.stage, this.handles, session, this.popup, this.label);
    this.tools = new ViewTools({
      look: (view) => this.look(view),
      fit: () => this.fit(),
      axes: (on) => this.stage.showAxes(on),
      handles: (on) => this.showHandles(on),
      upright: (on) => this.stand(on ? "z" : "y"),
      snap: (on) => (this.drag.snap = on),
    });
    this.root.append(this.tools.root);
    store.on("drawings", (touched) => this.refresh(touched));
    store.on("poles", () => this.refreshHandles());
    store.on("selection", () => this.refreshHandles());
    store.on("camera", (camera) => this.restore(camera));
    this.stage.controls.addEventListener("end", () => this.remember());
    this.listen();
    localised(() => this.describe());
  }

  /** Reads the colours of the ground and of the handles from the style sheet. */
  recolor(): void {
    const style = getComputedStyle(this.root);
    this.stage.setGround(style.backgroundColor);
    this.handles.setColors(style.color, style.accentColor, style.backgroundColor);
    this.stage.invalidate();
  }

  private describe(): void {
    this.canvas.setAttribute("aria-label", t("viewHelp"));
    this.nothing.textContent = t("nothingDrawn");
  }

  private refresh(touched: ReadonlySet<string> | null): void {
    const { store } = this.session;
    const drawn = new Set(this.stage.drawn);
    const first = drawn.size === 0;
    const all = touched ?? new Set([...drawn, ...store.drawings.keys()]);
    for (const address of all) this.stage.put(address, store.drawings.get(address));
    show(this.nothing, store.drawings.size === 0);
    if (this.drag.active) return;
    if (this.untouched || first) this.look(this.stage.cameras.view, false);
    else this.stage.fitAxes();
  }

  private refreshHandles(): void {
    this.handles.refresh();
    this.stage.invalidate();
  }

  private showHandles(on: boolean): void {
    this.handles.group.visible = on;
    this.stage.invalidate();
  }

  private stand(up: Up): void {
    this.stage.stand(up);
    this.handles.rebuild();
    this.look(this.stage.cameras.view);
  }

  private restore(camera: Camera): void {
    this.untouched = !camera.position;
    this.stage.stand(camera.up ?? "y");
    this.tools.showUpright(camera.up === "z");
    this.handles.rebuild();
    this.stage.cameras.restore(camera, this.stage.bounds());
    this.stage.cameraChanged();
    this.tools.show(this.stage.cameras.view);
    this.remembered = JSON.stringify(this.stage.cameras.state());
  }

  private look(view: ViewName, keep = true): void {
    this.stage.cameras.look(view, this.stage.bounds());
    this.stage.cameraChanged();
    this.tools.show(view);
    if (keep) {
      this.untouched = true;
      void this.session.setCamera({ view, up: this.stage.cameras.space.up });
    }
  }

  private fit(): void {
    this.stage.cameras.fit(this.stage.bounds());
    this.stage.cameraChanged();
    this.remember();
  }

  private remember(): void {
    const state = this.stage.cameras.state();
    const text = JSON.stringify(state);
    if (text === this.remembered) return;
    this.remembered = text;
    this.untouched = false;
    void this.session.setCamera(state);
  }

  private listen(): void {
    this.canvas.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || !this.key(event.key)) return;
      event.preventDefault();
    });
    this.root.addEventListener("pointerdown", () => (this.untouched = false), { capture: true });
    this.canvas.addEventListener("pointerdown", (event) => (this.press = { x: event.offsetX, y: event.offsetY }));
    this.canvas.addEventListener("pointerup", (event) => this.click(event));
  }

  /** A click on a form selects its cell. */
  private click(event: PointerEvent): void {
    const { press } = this;
    this.press = null;
    if (!press || Math.hypot(event.offsetX - press.x, event.offsetY - press.y) > STILL) return;
    const { clientWidth, clientHeight } = this.canvas;
    const place = placeOf(this.stage.hit(toClip(event.offsetX, event.offsetY, clientWidth, clientHeight)) ?? "");
    if (place) this.session.store.select(place);
  }

  private key(key: string): boolean {
    const turns: Record<string, [number, number]> = {
      ArrowLeft: [-TURN, 0],
      ArrowRight: [TURN, 0],
      ArrowUp: [0, -TURN],
      ArrowDown: [0, TURN],
    };
    const turn = turns[key];
    if (turn) this.turn(turn[0], turn[1]);
    else if (key === "+" || key === "=") this.zoom(ZOOM);
    else if (key === "-" || key === "−") this.zoom(1 / ZOOM);
    else if (key.toLowerCase() === "f") this.fit();
    else if (key === "]") this.choose(1);
    else if (key === "[") this.choose(-1);
    else if (key === "Enter") this.drag.type(this.handles.all[this.chosen] ?? this.handles.all[0] ?? null);
    else return false;
    return true;
  }

  private choose(step: number): void {
    const count = this.handles.all.length;
    if (count === 0) return;
    this.chosen = (this.chosen + step + count) % count;
    this.drag.type(this.handles.all[this.chosen] ?? null);
  }

  private turn(around: number, up: number): void {
    const { cameras } = this.stage;
    const eye = cameras.active.position;
    const ball = new Spherical().setFromVector3(eye.clone().sub(cameras.target));
    ball.theta += around;
    ball.phi = Math.min(Math.PI - 0.01, Math.max(0.01, ball.phi + up));
    eye.setFromSpherical(ball).add(cameras.target);
    this.stage.cameraChanged();
    this.remember();
  }

  private zoom(by: number): void {
    const { cameras } = this.stage;
    if (cameras.view === "PERSPECTIVE") {
      cameras.active.position.sub(cameras.target).divideScalar(by).add(cameras.target);
    } else {
      cameras.orthographic.zoom *= by;
    }
    cameras.project();
    this.stage.cameraChanged();
    this.remember();
  }
}
