import {
  Box3,
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  NoToneMapping,
  Raycaster,
  Scene,
  type Vector2,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Drawing } from "../engine/protocol";
import { Axes } from "./axes";
import { Cameras } from "./cameras";
import { Picture } from "./drawings";
import type { Up } from "./space";

/** The three.js scene: drawings of cells, axes, lights, cameras. Draws only when something changed. */
export class Stage {
  readonly cameras = new Cameras();
  readonly controls: OrbitControls;
  /** Holds everything in the coordinates of the sheet, and turns it into the picture. */
  readonly world = new Group();
  /** Holds what is placed in the picture. */
  readonly overlay = new Group();
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly axes = new Axes();
  private readonly pictures = new Map<string, Picture>();
  private readonly lamp = new Group();
  private readonly key = new DirectionalLight("#ffffff", 2.1);
  private readonly fill = new DirectionalLight("#e6ecff", 0.55);
  private pending = false;
  /** Of the canvas, in pixels of the page; kept so that no frame has to ask the page for it. */
  width = 1;
  height = 1;

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: false });
    this.renderer.toneMapping = NoToneMapping;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.world.matrixAutoUpdate = false;
    this.stand("y");
    this.world.add(this.axes.group);
    this.scene.add(this.world, this.overlay);
    this.addLights();
    this.controls = new OrbitControls(this.cameras.active, canvas);
    this.controls.enableDamping = false;
    this.controls.target = this.cameras.target;
    this.controls.addEventListener("change", () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement ?? canvas);
    this.resize();
  }

  /** Chooses the axis that stands upright. */
  stand(up: Up): void {
    this.cameras.space.up = up;
    this.world.matrix.copy(this.cameras.space.matrix());
    this.world.updateMatrixWorld(true);
  }

  /** Asks for a new picture at the next chance. */
  invalidate(): void {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => this.render());
  }

  setGround(color: string): void {
    this.scene.background = new Color(color);
    this.invalidate();
  }

  showAxes(on: boolean): void {
    this.axes.group.visible = on;
    this.invalidate();
  }

  /** Shows a cell as it is drawn now, or no longer. */
  put(address: string, drawing: Drawing | undefined): void {
    const picture = this.pictures.get(address);
    if (picture && drawing) picture.update(drawing);
    else if (drawing) this.add(address, new Picture(drawing));
    else if (picture) this.remove(address, picture);
    this.invalidate();
  }

  private add(address: string, picture: Picture): void {
    this.pictures.set(address, picture);
    this.world.add(picture.group);
  }

  private remove(address: string, picture: Picture): void {
    this.pictures.delete(address);
    this.world.remove(picture.group);
    picture.dispose();
  }

  get drawn(): Iterable<string> {
    return this.pictures.keys();
  }

  /** The box around everything drawn, in the picture. */
  bounds(): Box3 {
    this.world.updateMatrixWorld();
    const box = new Box3();
    for (const picture of this.pictures.values()) box.expandByObject(picture.measured());
    return box;
  }

  /** The cell whose drawing is under a place of the picture. */
  hit(at: Vector2): string | null {
    const ray = new Raycaster();
    ray.setFromCamera(at, this.cameras.active);
    const first = ray.intersectObjects([...this.pictures.values()].map((picture) => picture.measured()), true)[0];
    const address: unknown = first?.object.parent?.userData["address"];
    return typeof address === "string" ? address : null;
  }

  /** The picture as it is now, as a PNG. */
  picture(): Promise<Blob | null> {
    this.render();
    return new Promise((resolve) => this.canvas.toBlob(resolve));
  }

  /** After the cameras were set by hand. */
  cameraChanged(): void {
    this.controls.object = this.cameras.active;
    this.fitAxes();
    this.controls.update();
    this.invalidate();
  }

  /** Lets the axes reach a little beyond the forms. */
  fitAxes(): void {
    const box = this.bounds();
    const far = Math.max(...box.min.toArray().map(Math.abs), ...box.max.toArray().map(Math.abs));
    this.axes.group.scale.setScalar(box.isEmpty() || far === 0 ? 1 : far);
  }

  /** The main light comes over the viewer's left shoulder, wherever the viewer goes. */
  private addLights(): void {
    this.key.target.position.set(0, 0, -1);
    this.lamp.add(this.key, this.key.target, this.fill, this.fill.target);
    this.key.position.set(-1.2, 1.6, 2);
    this.fill.position.set(2.5, -0.4, 1);
    this.scene.add(this.lamp, new HemisphereLight("#ffffff", "#c4bcae", 1.15));
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas.parentElement ?? this.canvas;
    this.width = clientWidth;
    this.height = clientHeight;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.cameras.resize(clientWidth, clientHeight);
    this.invalidate();
  }

  private render(): void {
    this.pending = false;
    this.lamp.quaternion.copy(this.cameras.active.quaternion);
    this.axes.size(this.height, (at) => this.cameras.pixel(at, this.height));
    this.renderer.render(this.scene, this.cameras.active);
    this.canvas.dataset["frames"] = String(Number(this.canvas.dataset["frames"] ?? "0") + 1);
  }
}
