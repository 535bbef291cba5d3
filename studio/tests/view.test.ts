import {
  Box3,
  type BufferAttribute,
  type InstancedMesh,
  type Mesh,
  type MeshStandardMaterial,
  Vector2,
  Vector3,
} from "three";
import { describe, expect, it } from "vitest";
import type { Drawing, MeshBuffers, Poles } from "../src/engine/protocol";
import { Cameras } from "../src/view/cameras";
import { Drag, pick, toPixels } from "../src/view/drag";
import { Picture } from "../src/view/drawings";
import { type Handle, handledCells, MANY_POLES } from "../src/view/handles";
import { decimalStep, netEdges, roundStep, Space } from "../src/view/space";

const UNIT = new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1));

function square(): Cameras {
  const cameras = new Cameras();
  cameras.resize(800, 800);
  return cameras;
}

describe("space", () => {
  it("mirrors z, or exchanges y and z, both ways and by its matrix", () => {
    const space = new Space();
    const pictures = { y: [1, 2, -3], z: [1, 3, 2] };
    for (const up of ["y", "z"] as const) {
      space.up = up;
      const picture = space.toPicture([1, 2, 3]);
      expect(picture.toArray()).toEqual(pictures[up]);
      expect(space.toSheet(picture)).toEqual([1, 2, 3]);
      expect(new Vector3(1, 2, 3).applyMatrix4(space.matrix()).toArray()).toEqual(pictures[up]);
      expect(space.matrix().determinant()).toBe(-1);
      expect(Object.is(space.toSheet(new Vector3())[2], 0)).toBe(true);
    }
  });

  it("rounds steps to 1, 2, 5 and to powers of ten", () => {
    expect([0.0731, 0.3, 1, 19, 0].map(roundStep)).toEqual([0.05, 0.2, 1, 10, 1]);
    expect([0.0731, 3].map(decimalStep)).toEqual([0.01, 1]);
  });

  it("joins the neighbours of a net along every axis", () => {
    expect(netEdges([3])).toEqual([[0, 1], [1, 2]]);
    expect(netEdges([2, 3])).toHaveLength(2 * 2 + 3);
    expect(netEdges([2, 2, 2])).toHaveLength(12);
    expect(netEdges([])).toEqual([]);
  });
});

describe("the views of the book", () => {
  const seen = (view: "OX" | "OY" | "OZ" | "AXO", book: [number, number, number]): [number, number] => {
    const cameras = square();
    cameras.look(view, UNIT);
    cameras.active.updateMatrixWorld();
    const at = toPixels(cameras.space.toPicture(book), cameras, 800, 800);
    return [Math.sign(Math.round(at.x - 400)), Math.sign(Math.round(400 - at.y))];
  };

  it("show x to the right and y up from the front", () => {
    expect(seen("OZ", [1, 0, 0])).toEqual([1, 0]);
    expect(seen("OZ", [0, 1, 0])).toEqual([0, 1]);
    expect(seen("OX", [0, 0, 1])).toEqual([1, 0]);
    expect(seen("OY", [0, 0, 1])).toEqual([0, 1]);
  });

  it("show the axonometry with x to the lower right and z to the upper right", () => {
    expect(seen("AXO", [1, 0, 0])).toEqual([1, -1]);
    expect(seen("AXO", [0, 0, 1])).toEqual([1, 1]);
    expect(seen("AXO", [0, 1, 0])).toEqual([0, 1]);
  });

  it("come back from what the sheet keeps", () => {
    const cameras = square();
    cameras.look("PERSPECTIVE", UNIT);
    const state = cameras.state();
    const other = square();
    other.restore(state, new Box3(new Vector3(5, 5, 5), new Vector3(6, 6, 6)));
    expect(other.active.position.distanceTo(cameras.active.position)).toBeLessThan(1e-9);
    expect(other.state()).toEqual(state);
  });
});

describe("dragging", () => {
  const cameras = square();
  cameras.look("OZ", UNIT);
  cameras.active.updateMatrixWorld();

  it("moves in the plane that faces the viewer", () => {
    const start = cameras.space.toPicture([0.1, 0.2, 0.3]);
    const grip = start.clone().project(cameras.active);
    const drag = new Drag(start, cameras, new Vector2(grip.x, grip.y));
    const to = cameras.space.toSheet(drag.to(new Vector2(grip.x + 0.1, grip.y), false));
    expect(to[0]).toBeGreaterThan(0.1);
    expect(to[1]).toBeCloseTo(0.2, 12);
    expect(to[2]).toBeCloseTo(0.3, 12);
  });

  it("keeps to the nearest axis when asked", () => {
    const start = new Vector3();
    const drag = new Drag(start, cameras, new Vector2(0, 0));
    const to = drag.to(new Vector2(0.03, 0.2), true);
    expect([to.x, to.z]).toEqual([0, 0]);
    expect(to.y).toBeGreaterThan(0);
  });

  it("takes the nearest pole in reach, and the first of several at one place", () => {
    const handle = (address: string, x: number): Handle => ({
      address,
      pole: { index: [0], position: [x, 0, 0], coordinates: [], weight: "1" },
      at: new Vector3(x, 0, 0),
    });
    const handles = [handle("A1", 0), handle("A2", 0), handle("A3", 10)];
    const flat = (at: Vector3): Vector2 => new Vector2(at.x, at.y);
    expect(pick(handles, new Vector2(2, 0), flat)?.address).toBe("A1");
    expect(pick(handles, new Vector2(9, 0), flat)?.address).toBe("A3");
    expect(pick(handles, new Vector2(40, 0), flat)).toBeNull();
  });

  it("shows the poles of all cells while they are few", () => {
    const net = (address: string, count: number): Poles => ({
      address,
      orders: [count],
      poles: Array.from({ length: count }, (_, i) => ({ index: [i], position: null, coordinates: [], weight: "1" })),
    });
    const few = [net("A1", 3), net("A2", 3)];
    expect(handledCells(few, "A2")).toEqual(few);
    const many = [net("A1", MANY_POLES), net("A2", 3)];
    expect(handledCells(many, "A2").map((one) => one.address)).toEqual(["A2"]);
  });
});

describe("a drawn cell", () => {
  const RED: [number, number, number] = [1, 0, 0];
  const triangle = new Uint32Array([0, 1, 2]);
  const mesh = (height: number, indices = triangle): MeshBuffers => ({
    positions: new Float32Array([0, 0, height, 1, 0, height, 0, 1, height]),
    normals: new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1]),
    indices,
  });
  const drawing = (meshes: MeshBuffers[], balls: number[] = []): Drawing => ({
    address: "A1",
    color: RED,
    opacity: 1,
    meshes,
    points: balls.length > 0 ? [{ positions: new Float32Array(balls), radius: 0.125 }] : [],
  });
  const parts = (picture: Picture): Mesh[] => picture.group.children as Mesh[];

  it("is written over while it keeps its size: no new object, geometry or material", () => {
    const picture = new Picture(drawing([mesh(0)], [1, 2, 3]));
    const before = parts(picture).map((part) => [part, part.geometry, part.geometry.attributes, part.material]);
    const [flat, balls] = parts(picture) as [Mesh, InstancedMesh];
    const versions = (): number[] => {
      const { position, normal } = flat.geometry.attributes as Record<string, BufferAttribute>;
      return [position!.version, normal!.version, flat.geometry.index!.version, balls.instanceMatrix.version];
    };
    const first = versions();
    for (let frame = 1; frame <= 10; frame++) picture.update(drawing([mesh(frame)], [frame, 2, 3]));
    const after = parts(picture).map((part) => [part, part.geometry, part.geometry.attributes, part.material]);
    expect(after.flat().every((thing, at) => thing === before.flat()[at])).toBe(true);
    expect(versions().map((version, at) => version - first[at]!)).toEqual([10, 10, 0, 10]);
    expect(picture.group.children).toHaveLength(2);
    expect(new Box3().expandByObject(picture.measured()).max.toArray()).toEqual([10.125, 2.125, 10]);
    expect(flat.geometry.boundingSphere!.center.z).toBe(10);
    picture.update(drawing([mesh(20)], [1, 2, 3]));
    expect(new Box3().expandByObject(picture.measured()).max.toArray()).toEqual([1.125, 2.125, 20]);
    picture.update(drawing([mesh(10)], [10, 2, 3]));
    expect(Array.from(balls.instanceMatrix.array.slice(12, 15))).toEqual([10, 2, 3]);
  });

  it("gets other triangles in place, and another geometry only for another size", () => {
    const picture = new Picture(drawing([mesh(0), mesh(1)]));
    const [first, second] = parts(picture);
    picture.update(drawing([mesh(0, new Uint32Array([2, 1, 0])), mesh(1)]));
    expect(parts(picture)).toEqual([first, second]);
    expect(Array.from(first!.geometry.index!.array)).toEqual([2, 1, 0]);
    picture.update(drawing([mesh(0, new Uint32Array([0, 1, 2, 2, 1, 0])), mesh(1)]));
    expect(parts(picture)[0]).not.toBe(first);
    expect(parts(picture)[1]).toBe(second);
    picture.update(drawing([mesh(0)]));
    expect(parts(picture)).toHaveLength(1);
  });

  it("becomes transparent without another material", () => {
    const picture = new Picture(drawing([mesh(0)]));
    const material = parts(picture)[0]!.material as MeshStandardMaterial;
    const { version } = material;
    picture.update({ ...drawing([mesh(0)]), opacity: 0.5, color: [0, 0, 1] });
    expect(parts(picture)[0]!.material).toBe(material);
    expect([material.transparent, material.depthWrite, material.opacity]).toEqual([true, false, 0.5]);
    expect(material.version).toBe(version + 1);
    picture.update({ ...drawing([mesh(0)]), opacity: 0.4 });
    expect(material.version).toBe(version + 1);
  });
});
