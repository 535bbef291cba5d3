import {
  BufferAttribute,
  BufferGeometry,
  Color,
  CylinderGeometry,
  DoubleSide,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";
import type { Drawing } from "../engine/protocol";

const BALL = new SphereGeometry(1, 20, 14);
const SMALL_BALL = new SphereGeometry(1, 10, 7);
const ROD = new CylinderGeometry(1, 1, 1, 12, 1, true);
/** Above so many balls, coarser ones are drawn. */
const MANY = 2000;

/** Turns the buffers of one cell into objects for the graphics card. */
export function makeDrawing(drawing: Drawing): Group {
  const group = new Group();
  group.userData["address"] = drawing.address;
  const material = makeMaterial(drawing);
  for (const mesh of drawing.meshes) group.add(makeMesh(mesh, material));
  for (const line of drawing.lines) group.add(...makeTubes(line, material));
  for (const points of drawing.points) group.add(makeBalls(points.positions, points.radius, material));
  return group;
}

/** Frees what a drawing holds on the graphics card. */
export function dispose(object: Object3D): void {
  object.traverse((part) => {
    if (part instanceof InstancedMesh) part.dispose();
    else if (part instanceof Mesh) (part.geometry as BufferGeometry).dispose();
    if (part instanceof Mesh) (part.material as MeshStandardMaterial).dispose();
  });
}

function makeMaterial(drawing: Drawing): MeshStandardMaterial {
  const [red, green, blue] = drawing.color;
  const clear = drawing.opacity < 1;
  const material = new MeshStandardMaterial({
    color: new Color().setRGB(red, green, blue, "srgb"),
    opacity: drawing.opacity,
    transparent: clear,
    depthWrite: !clear,
    side: DoubleSide,
    roughness: 0.55,
    metalness: 0,
  });
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

function makeMesh(part: Drawing["meshes"][number], material: MeshStandardMaterial): Mesh {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(part.positions, 3));
  if (part.normals.length === part.positions.length) {
    geometry.setAttribute("normal", new BufferAttribute(part.normals, 3));
  }
  geometry.setIndex(new BufferAttribute(part.indices, 1));
  return new Mesh(geometry, material);
}

function makeBalls(positions: Float32Array, radius: number, material: MeshStandardMaterial): InstancedMesh {
  const count = positions.length / 3;
  const balls = new InstancedMesh(count > MANY ? SMALL_BALL : BALL, material, count);
  const place = new Matrix4();
  for (let i = 0; i < count; i++) {
    place.makeScale(radius, radius, radius);
    place.setPosition(positions[3 * i]!, positions[3 * i + 1]!, positions[3 * i + 2]!);
    balls.setMatrixAt(i, place);
  }
  balls.computeBoundingSphere();
  return balls;
}

/** Rods between the points of each polyline, and balls that round the joints. */
function makeTubes(line: Drawing["lines"][number], material: MeshStandardMaterial): Object3D[] {
  const { positions, starts, radius } = line;
  const points = positions.length / 3;
  const rods = new InstancedMesh(ROD, material, Math.max(0, points - (starts.length - 1)));
  const from = new Vector3();
  const to = new Vector3();
  let rod = 0;
  for (let part = 0; part + 1 < starts.length; part++) {
    for (let i = starts[part]!; i + 1 < starts[part + 1]!; i++) {
      from.fromArray(positions, 3 * i);
      to.fromArray(positions, 3 * i + 3);
      rods.setMatrixAt(rod++, rodMatrix(from, to, radius));
    }
  }
  rods.computeBoundingSphere();
  return [rods, makeBalls(positions, radius, material)];
}

const UP = new Vector3(0, 1, 0);

function rodMatrix(from: Vector3, to: Vector3, radius: number): Matrix4 {
  const axis = to.clone().sub(from);
  const length = axis.length();
  const turn = new Quaternion().setFromUnitVectors(UP, length > 0 ? axis.divideScalar(length) : UP);
  const middle = from.clone().add(to).multiplyScalar(0.5);
  return new Matrix4().compose(middle, turn, new Vector3(radius, length, radius));
}
