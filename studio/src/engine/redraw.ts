import type { Drawing, Redrawing } from "./protocol";

/** A drawing made whole again: what did not travel is taken from the one before. */
export function redrawn({ address, color, opacity, shape }: Redrawing, before?: Drawing): Drawing {
  if (!shape) return { address, color, opacity, meshes: before?.meshes ?? [], points: before?.points ?? [] };
  const meshes = shape.meshes.map((mesh, at) => ({
    ...mesh,
    indices: mesh.indices ?? before?.meshes[at]?.indices ?? new Uint32Array(),
  }));
  return { address, color, opacity, meshes, points: shape.points };
}
