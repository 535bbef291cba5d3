import { Vector3 } from "three";

export type Triple = [number, number, number];

/**
 * The book is left-handed (x right, y up, z away from the viewer), WebGL is right-handed.
 * Only the view turns one into the other: z changes its sign, and nothing else does.
 */
export function toScreenSpace([x, y, z]: Triple): Vector3 {
  return new Vector3(x, y, -z);
}

export function toBook(point: Vector3): Triple {
  return [point.x, point.y, -point.z || 0];
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
