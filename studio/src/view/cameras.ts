import { Box3, OrthographicCamera, PerspectiveCamera, Sphere, Vector3 } from "three";
import type { Camera, ViewName } from "../engine/protocol";
import { Space } from "./space";

/** The vertical angle of the book's square pictures, in degrees. */
const ANGLE = 53.13;
const MARGIN = 1.12;

/** Both cameras, and the view that is on. */
export class Cameras {
  readonly perspective = new PerspectiveCamera(ANGLE, 1, 0.001, 1000);
  readonly orthographic = new OrthographicCamera(-1, 1, 1, -1, -1000, 1000);
  readonly target = new Vector3();
  readonly space = new Space();
  view: ViewName = "AXO";
  private aspect = 1;
  /** Half of what the orthographic camera shows, along the shorter side. */
  private half = 1;

  get active(): PerspectiveCamera | OrthographicCamera {
    return this.view === "PERSPECTIVE" ? this.perspective : this.orthographic;
  }

  resize(width: number, height: number): void {
    this.aspect = Math.max(width, 1) / Math.max(height, 1);
    this.project();
  }

  /** Turns to a named view and shows the whole of `box`. */
  look(view: ViewName, box: Box3): void {
    this.view = view;
    this.frame(this.space.direction(view), box);
  }

  /** Shows the whole of `box` from the present direction. */
  fit(box: Box3): void {
    this.frame(this.direction(), box);
  }

  /** The length of one pixel of a picture `height` pixels high, at a place. */
  pixel(at: Vector3, height: number): number {
    if (this.view !== "PERSPECTIVE") {
      const { top, bottom, zoom } = this.orthographic;
      return (top - bottom) / zoom / height;
    }
    const depth = this.perspective.position.distanceTo(at);
    return (2 * depth * Math.tan((ANGLE * Math.PI) / 360)) / height;
  }

  /** Takes over a camera of the sheet; what it leaves open is fitted to `box`. */
  restore(camera: Camera, box: Box3): void {
    // `box` lies in the picture, whose upright axis the caller has set: see `Stage.stand`.
    this.look(camera.view ?? "AXO", box);
    const zoom = camera.zoom ?? 0;
    const aim = camera.target ? this.space.toPicture(camera.target) : this.target.clone();
    const away = this.active.position.clone().sub(this.target);
    if (zoom > 0 && this.view === "PERSPECTIVE") away.divideScalar(zoom);
    this.target.copy(aim);
    this.place(camera.position ? this.space.toPicture(camera.position) : aim.clone().add(away));
    if (zoom > 0) this.half = 0.5 / zoom;
    this.project();
  }

  state(): Camera {
    const shown = this.half / this.orthographic.zoom;
    return {
      view: this.view,
      up: this.space.up,
      position: this.space.toSheet(this.active.position),
      target: this.space.toSheet(this.target),
      zoom: this.view === "PERSPECTIVE" ? null : 0.5 / shown,
    };
  }

  /** From the target to the eye. */
  direction(): Vector3 {
    return this.active.position.clone().sub(this.target).normalize();
  }

  private frame(direction: Vector3, box: Box3): void {
    const ball = box.isEmpty() ? new Sphere(new Vector3(), 1) : box.getBoundingSphere(new Sphere());
    const radius = Math.max(ball.radius, 1e-6) * MARGIN;
    this.target.copy(ball.center);
    this.half = radius;
    this.orthographic.zoom = 1;
    const angle = (ANGLE * Math.PI) / 360;
    const narrow = Math.atan(Math.tan(angle) * Math.min(1, this.aspect));
    this.place(ball.center.clone().addScaledVector(direction, radius / Math.sin(narrow)));
    this.project();
  }

  private place(eye: Vector3): void {
    for (const camera of [this.perspective, this.orthographic]) {
      camera.position.copy(eye);
      camera.up.set(0, 1, 0);
      camera.lookAt(this.target);
    }
  }

  /** Adapts both cameras to the shape of the canvas and to the distance. */
  project(): void {
    const distance = Math.max(this.active.position.distanceTo(this.target), 1e-9);
    this.perspective.aspect = this.aspect;
    this.perspective.near = distance / 500;
    this.perspective.far = distance * 500;
    this.perspective.updateProjectionMatrix();
    const tall = this.half / Math.min(1, this.aspect);
    Object.assign(this.orthographic, {
      left: -tall * this.aspect,
      right: tall * this.aspect,
      top: tall,
      bottom: -tall,
      near: -distance * 100,
      far: distance * 100,
    });
    this.orthographic.updateProjectionMatrix();
  }
}
