import {
  BufferGeometry,
  CanvasTexture,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Points,
  PointsMaterial,
  type PointsMaterialParameters,
  Vector3,
} from "three";
import type { Address, Pole, Poles } from "../engine/protocol";
import type { Store } from "../store";
import { netEdges, type Space } from "./space";

/** A pole that can be dragged, and where it is in the picture. */
export interface Handle {
  address: Address;
  pole: Pole;
  at: Vector3;
}

/** With more poles than this, only those of the selected cell get handles. */
export const MANY_POLES = 80;

/** Diameters of the dots, in pixels: of the selected cell, of the others, and what the rim adds. */
const OWN = 13;
const OTHER = 8;
const RIM = 4;

/** The cells whose poles are shown: all literal ones that are few enough, else the selected one. */
export function handledCells(poles: Iterable<Poles>, selected: Address): Poles[] {
  const all = [...poles];
  const total = all.reduce((sum, net) => sum + net.poles.length, 0);
  return total <= MANY_POLES ? all : all.filter((net) => net.address === selected);
}

/** Dots at the poles of literal cells, and the control net of the selected cell. */
export class Handles {
  readonly group = new Group();
  private handles: Handle[] = [];
  private readonly texture = new CanvasTexture(disc());
  private ink = "#22252a";
  private accent = "#1f6f78";
  private paper = "#ffffff";

  constructor(
    private readonly store: Store,
    private readonly space: Space,
  ) {}

  get all(): readonly Handle[] {
    return this.handles;
  }

  setColors(ink: string, accent: string, paper: string): void {
    this.ink = ink;
    this.paper = paper;
    this.accent = accent;
    this.rebuild();
  }

  /** Makes all dots anew, from what the store holds. */
  rebuild(): void {
    const selected = this.store.address;
    this.clear();
    for (const net of handledCells(this.store.poles.values(), selected)) {
      const own = net.address === selected;
      const handles = net.poles.flatMap((pole) =>
        pole.position ? [{ address: net.address, pole, at: this.space.toPicture(pole.position) }] : [],
      );
      this.handles.push(...handles);
      this.addDots(handles.map((handle) => handle.at), own);
      if (own) this.addNet(net);
    }
    const first = (handle: Handle): number => (handle.address === selected ? 0 : 1);
    this.handles.sort((a, b) => first(a) - first(b));
  }

  private clear(): void {
    this.handles = [];
    for (const part of this.group.children) {
      const drawn = part as Points | LineSegments;
      drawn.geometry.dispose();
      (drawn.material as PointsMaterial | LineBasicMaterial).dispose();
    }
    this.group.clear();
  }

  /** Full where the dot is seen, faint where a form hides it. */
  private addDots(places: Vector3[], own: boolean): void {
    const color = own ? this.accent : this.ink;
    const size = own ? OWN : OTHER;
    const order = own ? 13 : 10;
    this.addLayer(places, { color, size, opacity: own ? 0.3 : 0.18, depthTest: false }, order);
    if (own) this.addLayer(places, { color: this.paper, size: size + RIM, opacity: 1, depthTest: true }, order + 1);
    this.addLayer(places, { color, size, opacity: own ? 1 : 0.75, depthTest: true }, order + 2);
  }

  private addLayer(places: Vector3[], look: PointsMaterialParameters & { size: number }, order: number): void {
    const material = new PointsMaterial({
      ...look,
      size: look.size * Math.min(window.devicePixelRatio, 2),
      sizeAttenuation: false,
      map: this.texture,
      alphaTest: 0.05,
      transparent: true,
      depthWrite: false,
    });
    material.onBeforeCompile = comeForward;
    const dots = new Points(new BufferGeometry().setFromPoints(places), material);
    dots.renderOrder = order;
    this.group.add(dots);
  }

  private addNet(net: Poles): void {
    const corners: number[] = [];
    for (const [a, b] of netEdges(net.orders)) {
      const from = net.poles[a]?.position;
      const to = net.poles[b]?.position;
      if (from && to) corners.push(...this.space.toPicture(from).toArray(), ...this.space.toPicture(to).toArray());
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(corners, 3));
    const material = new LineBasicMaterial({ color: this.accent, opacity: 0.6, transparent: true });
    this.group.add(new LineSegments(geometry, material));
  }
}

/** Brings dots a little nearer to the viewer, so that a ball drawn at the pole itself does not hide them. */
function comeForward(shader: { vertexShader: string }): void {
  shader.vertexShader = shader.vertexShader.replace(
    "#include <project_vertex>",
    `#include <project_vertex>
     mvPosition.xyz *= isPerspectiveMatrix(projectionMatrix) ? vec3(0.96) : vec3(1.0, 1.0, 0.96);
     gl_Position = projectionMatrix * mvPosition;`,
  );
}

/** A disc that takes the colour of the material. */
function disc(): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d");
  if (pen) {
    pen.beginPath();
    pen.arc(32, 32, 26, 0, 2 * Math.PI);
    pen.fillStyle = "#ffffff";
    pen.fill();
  }
  return canvas;
}
