import { Matrix4, Vector3 } from "three";
import type { ViewName } from "../engine/protocol";

export type Triple = [number, number, number];

/** The axis of the sheet that stands upright in the picture. */
export type Up = "y" | "z";

/** Where the named views look from, in the picture: x right, y up, z towards the viewer. */
const RIGHT: Triple = [1, 0, 0];
const ABOVE: Triple = [0, 1, 0];
const FRONT: Triple = [0, 0, 1];
const DIRECTIONS: Record<Up, Record<ViewName, Triple>> = {
  y: { OX: RIGHT, OY: ABOVE, OZ: FRONT, AXO: [1, 1, 1], PERSPECTIVE: [0.7, 1.3, 1.1] },
  z: { OX: RIGHT, OY: FRONT, OZ: ABOVE, AXO: [1, 1, 1], PERSPECTIVE: [0.7, 1.3, 1.1] },
};

/**
 * The book is left-handed (x right, y up, z away from the viewer), WebGL is right-handed.
 * Only the view turns one into the other: z changes its sign; or, for models that stand on the axis z,
 * y and z change places. Numbers of the sheet stay as they are.
 */
export class Space {
  up: Up = "y";

  toPicture([x, y, z]: Triple): Vector3 {
    return this.up === "y" ? new Vector3(x, y, -z) : new Vector3(x, z, y);
  }

  toSheet({ x, y, z }: Vector3): Triple {
    return this.up === "y" ? [x, y, -z || 0] : [x, z, y];
  }

  /** What turns the whole sheet into the picture. */
  matrix(): Matrix4 {
    const [x, y, z] = [this.toPicture([1, 0, 0]), this.toPicture([0, 1, 0]), this.toPicture([0, 0, 1])];
    return new Matrix4().makeBasis(x, y, z);
  }

  /** From the middle of the picture to the eye. */
  direction(view: ViewName): Vector3 {
    return new Vector3(...DIRECTIONS[this.up][view]).normalize();
  }
}

/** The step 1, 2 or 5 times a power of ten that is nearest below `size`. */
export function roundStep(size: number): number {
  if (!(size > 0) || !Number.isFinite(size)) return 1;
  const power = 10 ** Math.floor(Math.log10(size));
  const lead = size / power;
  return power * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
}

/** The power of ten nearest below `size`: what one pixel can tell apart. */
export function decimalStep(size: number): number {
  if (!(size > 0) || !Number.isFinite(size)) return 1;
  return 10 ** Math.floor(Math.log10(size));
}

/** The index pairs of neighbours in a net of poles, along every axis; last index fastest. */
export function netEdges(orders: readonly number[]): [number, number][] {
  const edges: [number, number][] = [];
  const total = orders.reduce((product, order) => product * order, 1);
  let stride = 1;
  for (let axis = orders.length - 1; axis >= 0; axis--) {
    const order = orders[axis]!;
    for (let at = 0; at < total; at++) {
      if (Math.floor(at / stride) % order < order - 1) edges.push([at, at + stride]);
    }
    stride *= order;
  }
  return edges;
}
