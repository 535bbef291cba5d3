import {
  CanvasTexture,
  DoubleSide,
  Group,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
  Vector3,
} from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

const AXES = [
  { name: "x", color: "#d3463a", end: [1, 0, 0] },
  { name: "y", color: "#3d9a4e", end: [0, 1, 0] },
  { name: "z", color: "#3f6fd1", end: [0, 0, 1] },
] as const;

/** The half-length of the axes when the scene has unit size. */
const LENGTH = 1.35;

/** The size of the names, in pixels; less in a picture lower than `TALL`. */
const LETTER = 26;
const TALL = 420;

/** Ox red, Oy green, Oz blue, with their names at the positive ends. The negative halves are faint. */
export class Axes {
  readonly group = new Group();
  private readonly names: Sprite[] = [];

  constructor() {
    for (const axis of AXES) {
      const [x, y, z] = axis.end;
      const name = label(axis.name, axis.color);
      name.position.set(x, y, z).multiplyScalar(LENGTH * 1.06);
      this.names.push(name);
      this.group.add(
        ray([x * LENGTH, y * LENGTH, z * LENGTH], axis.color, 1),
        ray([-x * LENGTH, -y * LENGTH, -z * LENGTH], axis.color, 0.35),
        name,
      );
    }
  }

  /** Keeps the names at their size; `pixel` tells the length of a pixel at a place. */
  size(height: number, pixel: (at: Vector3) => number): void {
    const letter = LETTER * Math.min(1, 0.3 + height / TALL);
    for (const name of this.names) {
      const at = name.getWorldPosition(new Vector3());
      name.scale.setScalar((letter * pixel(at)) / this.group.scale.x);
    }
  }
}

function ray(end: [number, number, number], color: string, opacity: number): LineSegments2 {
  const geometry = new LineSegmentsGeometry().setPositions([0, 0, 0, ...end]);
  const material = new LineMaterial({ color, opacity, transparent: opacity < 1, linewidth: 1.6, side: DoubleSide });
  return new LineSegments2(geometry, material);
}

function label(text: string, color: string): Sprite {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d");
  if (pen) {
    pen.font = "italic 600 44px 'Inter', sans-serif";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.fillStyle = color;
    pen.fillText(text, 32, 32);
  }
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  return new Sprite(new SpriteMaterial({ map, depthTest: false }));
}
