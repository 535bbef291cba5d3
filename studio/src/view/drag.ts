import { Plane, Raycaster, Vector2, Vector3 } from "three";
import type { Cameras } from "./cameras";
import type { Handle } from "./handles";

/** How near, in pixels, the pointer must come to a pole to take it. */
const REACH = 14;

const AXES = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];

/** A place of the canvas in pixels, as the graphics card counts it: −1 … 1. */
export function toClip(x: number, y: number, width: number, height: number): Vector2 {
  return new Vector2((2 * x) / width - 1, 1 - (2 * y) / height);
}

/** Where a place of space appears on the canvas, in pixels. */
export function toPixels(at: Vector3, cameras: Cameras, width: number, height: number): Vector2 {
  const clip = at.clone().project(cameras.active);
  return new Vector2(((clip.x + 1) * width) / 2, ((1 - clip.y) * height) / 2);
}

/** The handle under the pointer: the nearest in reach; of several at one place the first. */
export function pick(
  handles: readonly Handle[],
  pointer: Vector2,
  project: (at: Vector3) => Vector2,
): Handle | null {
  let best: Handle | null = null;
  let least = REACH;
  for (const handle of handles) {
    const distance = project(handle.at).distanceTo(pointer);
    if (distance < least - 0.5) {
      best = handle;
      least = distance;
    }
  }
  return best;
}

/** One drag: the pole moves in the plane through it that faces the viewer. */
export class Drag {
  private readonly plane: Plane;
  private readonly grip: Vector3;

  constructor(
    readonly start: Vector3,
    private readonly cameras: Cameras,
    pointer: Vector2,
  ) {
    this.plane = new Plane().setFromNormalAndCoplanarPoint(cameras.direction(), start);
    this.grip = (this.meet(pointer) ?? start).clone().sub(start);
  }

  /** Where the pole goes; `constrained` keeps it on the axis that the movement follows best. */
  to(pointer: Vector2, constrained: boolean): Vector3 {
    const place = (this.meet(pointer) ?? this.start).clone().sub(this.grip);
    return constrained ? this.onAxis(place) : place;
  }

  private meet(pointer: Vector2): Vector3 | null {
    const ray = new Raycaster();
    ray.setFromCamera(pointer, this.cameras.active);
    return ray.ray.intersectPlane(this.plane, new Vector3());
  }

  private onAxis(place: Vector3): Vector3 {
    const moved = place.clone().sub(this.start);
    let best = this.start.clone();
    let least = Number.POSITIVE_INFINITY;
    for (const axis of AXES) {
      const seen = axis.clone().projectOnPlane(this.plane.normal);
      if (seen.lengthSq() < 1e-4) continue;
      const along = moved.dot(seen) / seen.lengthSq();
      const missed = moved.distanceTo(seen.multiplyScalar(along));
      if (missed < least) {
        least = missed;
        best = this.start.clone().addScaledVector(axis, along);
      }
    }
    return best;
  }
}
