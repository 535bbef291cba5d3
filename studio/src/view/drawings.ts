import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  SphereGeometry,
} from "three";
import type { Drawing } from "../engine/protocol";

const BALL = new SphereGeometry(1, 20, 14);
const SMALL_BALL = new SphereGeometry(1, 10, 7);
/** Above so many balls, coarser ones are drawn. */
const MANY = 2000;

/** Turns the buffers of one cell into objects for the graphics card. */
export function makeDrawing(drawing: Drawing): Group {
  const group = new Group();
  group.userData["address"] = drawing.address;
  const material = makeMaterial(drawing);
  for (const mesh of drawing.meshes) group.add(makeMesh(mesh, material));
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
