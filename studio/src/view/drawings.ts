import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  InstancedMesh,
  Mesh,
  MeshStandardMaterial,
  SphereGeometry,
  type TypedArray,
} from "three";
import type { BallBuffers, Drawing, MeshBuffers } from "../engine/protocol";

const BALL = new SphereGeometry(1, 20, 14);
const SMALL_BALL = new SphereGeometry(1, 10, 7);
/** Above so many balls, coarser ones are drawn. */
const MANY = 2000;

/**
 * The objects of one drawn cell on the graphics card.
 *
 * They are made once. While a pole is dragged the sizes stay, and the numbers are written over the old ones:
 * no new geometry, no new material, and no index that is the same array as before is sent again.
 */
export class Picture {
  readonly group = new Group();
  private readonly material = makeMaterial();
  private meshes: Mesh[] = [];
  private balls: InstancedMesh[] = [];
  /** Were the objects written over since someone asked how large they are? */
  private stale = false;

  constructor(drawing: Drawing) {
    this.group.userData["address"] = drawing.address;
    this.update(drawing);
  }

  /** Shows the cell as it is now. */
  update(drawing: Drawing): void {
    this.stale = true;
    this.paint(drawing);
    this.meshes = fit(this.meshes, drawing.meshes, rewriteMesh, (part) => makeMesh(part, this.material), disposeMesh);
    this.balls = fit(this.balls, drawing.points, rewriteBalls, (part) => makeBalls(part, this.material), disposeBalls);
    const parts = [...this.meshes, ...this.balls];
    if (parts.some((part) => part.parent !== this.group) || parts.length < this.group.children.length) {
      this.group.clear();
      this.group.add(...parts);
    }
  }

  /**
   * The group, ready to be measured and hit: boxes and spheres round the parts are right again.
   *
   * They cost a pass over all vertices. To draw, old ones do: they only tell in which order.
   */
  measured(): Group {
    if (this.stale) {
      for (const { geometry } of this.meshes) geometry.computeBoundingBox();
      for (const { geometry } of this.meshes) geometry.computeBoundingSphere();
      for (const balls of this.balls) balls.computeBoundingBox();
      for (const balls of this.balls) balls.computeBoundingSphere();
    }
    this.stale = false;
    return this.group;
  }

  /** Frees what the picture holds on the graphics card. */
  dispose(): void {
    this.meshes.forEach(disposeMesh);
    this.balls.forEach(disposeBalls);
    this.material.dispose();
  }

  private paint({ color: [red, green, blue], opacity }: Drawing): void {
    const { material } = this;
    const clear = opacity < 1;
    material.color.setRGB(red, green, blue, "srgb");
    material.opacity = opacity;
    if (material.transparent !== clear) {
      material.transparent = clear;
      material.depthWrite = !clear;
      material.needsUpdate = true;
    }
  }
}

/** One object for each part: the old one where it can be written anew, else another. */
function fit<T, P>(
  old: T[],
  parts: readonly P[],
  rewrite: (object: T, part: P) => boolean,
  make: (part: P) => T,
  drop: (object: T) => void,
): T[] {
  old.slice(parts.length).forEach(drop);
  return parts.map((part, at) => {
    const object = old[at];
    if (object !== undefined && rewrite(object, part)) return object;
    if (object !== undefined) drop(object);
    return make(part);
  });
}

function makeMaterial(): MeshStandardMaterial {
  const material = new MeshStandardMaterial({ side: DoubleSide, roughness: 0.55, metalness: 0 });
  material.onBeforeCompile = faceViewer;
  return material;
}

/** A form has no outside: whichever side is seen is the one that is lit. */
function faceViewer(shader: { fragmentShader: string }): void {
  shader.fragmentShader = shader.fragmentShader.replace(
    "#include <normal_fragment_maps>",
    `#include <normal_fragment_maps>
     normal *= dot(normal, isOrthographic ? vec3(0.0, 0.0, 1.0) : vViewPosition) < 0.0 ? -1.0 : 1.0;`,
  );
}

function makeMesh(part: MeshBuffers, material: MeshStandardMaterial): Mesh {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", changing(part.positions, 3));
  if (part.normals.length === part.positions.length) geometry.setAttribute("normal", changing(part.normals, 3));
  geometry.setIndex(changing(part.indices, 1));
  const mesh = new Mesh(geometry, material);
  // Whether it is seen is told by its sphere, and that is not kept up to date: see `Picture.measured`.
  mesh.frustumCulled = false;
  return mesh;
}

function changing(array: TypedArray, size: number): BufferAttribute {
  return new BufferAttribute(array, size).setUsage(DynamicDrawUsage);
}

function rewriteMesh({ geometry }: Mesh, part: MeshBuffers): boolean {
  const { position, normal } = geometry.attributes as Record<string, BufferAttribute | undefined>;
  const { index } = geometry;
  const lit = part.normals.length === part.positions.length;
  if (position?.array.length !== part.positions.length || index?.array.length !== part.indices.length) return false;
  if (lit !== (normal !== undefined)) return false;
  write(position, part.positions);
  if (normal) write(normal, part.normals);
  write(index, part.indices);
  return true;
}

/** Takes an array of the same length in place of the old one; the graphics card gets it with the next picture. */
function write(attribute: BufferAttribute, array: TypedArray): void {
  if (attribute.array === array) return;
  attribute.array = array;
  attribute.needsUpdate = true;
}

function disposeMesh(mesh: Mesh): void {
  mesh.geometry.dispose();
}

function makeBalls(part: BallBuffers, material: MeshStandardMaterial): InstancedMesh {
  const count = part.positions.length / 3;
  const balls = new InstancedMesh(count > MANY ? SMALL_BALL : BALL, material, count);
  balls.instanceMatrix.setUsage(DynamicDrawUsage);
  balls.frustumCulled = false;
  rewriteBalls(balls, part);
  return balls;
}

/** A ball is the unit ball, scaled and moved: sixteen numbers, column after column. */
function rewriteBalls(balls: InstancedMesh, { positions, radius }: BallBuffers): boolean {
  const count = positions.length / 3;
  if (balls.count !== count) return false;
  const { array } = balls.instanceMatrix;
  for (let i = 0; i < count; i++) {
    const at = 16 * i;
    array[at] = array[at + 5] = array[at + 10] = radius;
    array[at + 12] = positions[3 * i]!;
    array[at + 13] = positions[3 * i + 1]!;
    array[at + 14] = positions[3 * i + 2]!;
    array[at + 15] = 1;
  }
  balls.instanceMatrix.needsUpdate = true;
  return true;
}

function disposeBalls(balls: InstancedMesh): void {
  balls.dispose();
}
