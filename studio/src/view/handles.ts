import {
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  DynamicDrawUsage,
  Group,
  LineBasicMaterial,
  LineSegments,
  Points,
  PointsMaterial,
  type PointsMaterialParameters,
  type Vector3,
} from "three";
import type { Address, Pole, Poles } from "../engine/protocol";
import type { Store } from "../store";
import { netEdges, type Space, type Triple } from "./space";

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
  private nets: NetDots[] = [];
  private handles: Handle[] = [];
  private readonly looks = new Looks();

  constructor(
    private readonly store: Store,
    private readonly space: Space,
  ) {}

  get all(): readonly Handle[] {
    return this.handles;
  }

  setColors(ink: string, accent: string, paper: string): void {
    this.looks.setColors(ink, accent, paper);
  }

  /** Shows the poles that the store holds: moves the dots that are there, makes new ones where that is not enough. */
  refresh(): void {
    const nets = handledCells(this.store.poles.values(), this.store.address);
    const fits = nets.length === this.nets.length && nets.every((net, at) => this.nets[at]!.takes(net, this.owns(net)));
    if (fits) nets.forEach((net, at) => this.nets[at]!.move(net, this.space));
    else this.rebuild(nets);
  }

  /** Makes all dots anew, as when another axis stands upright. */
  rebuild(nets = handledCells(this.store.poles.values(), this.store.address)): void {
    for (const dots of this.nets) dots.dispose();
    this.group.clear();
    this.nets = nets.map((net) => new NetDots(net, this.owns(net), this.looks, this.space));
    for (const dots of this.nets) this.group.add(...dots.parts);
    const own = (dots: NetDots): number => (dots.own ? 0 : 1);
    this.handles = [...this.nets].sort((a, b) => own(a) - own(b)).flatMap((dots) => dots.handles);
  }

  private owns(net: Poles): boolean {
    return net.address === this.store.address;
  }
}

/** The materials of dots and nets, shared by all. */
class Looks {
  private readonly texture = new CanvasTexture(disc());
  private readonly ownFaint = this.dots(OWN, { opacity: 0.3, depthTest: false });
  private readonly ownRim = this.dots(OWN + RIM, {});
  private readonly ownFull = this.dots(OWN, {});
  private readonly otherFaint = this.dots(OTHER, { opacity: 0.18, depthTest: false });
  private readonly otherFull = this.dots(OTHER, { opacity: 0.75 });
  readonly wire = new LineBasicMaterial({ opacity: 0.6, transparent: true });

  /** Full where the dot is seen, faint where a form hides it; with the order in which they are drawn. */
  layers(own: boolean): [PointsMaterial, number][] {
    if (!own) return [[this.otherFaint, 10], [this.otherFull, 12]];
    return [[this.ownFaint, 13], [this.ownRim, 14], [this.ownFull, 15]];
  }

  setColors(ink: string, accent: string, paper: string): void {
    for (const material of [this.ownFaint, this.ownFull, this.wire]) material.color.set(accent);
    for (const material of [this.otherFaint, this.otherFull]) material.color.set(ink);
    this.ownRim.color.set(paper);
  }

  private dots(size: number, look: PointsMaterialParameters): PointsMaterial {
    const material = new PointsMaterial({
      ...look,
      size: size * Math.min(window.devicePixelRatio, 2),
      sizeAttenuation: false,
      map: this.texture,
      alphaTest: 0.05,
      transparent: true,
      depthWrite: false,
    });
    material.onBeforeCompile = comeForward;
    return material;
  }
}

/** The dots of one net: one list of places, drawn in layers; and its edges when it is the selected cell's. */
class NetDots {
  readonly parts: (Points | LineSegments)[];
  readonly handles: Handle[];
  private readonly places: BufferAttribute;
  private readonly corners: BufferAttribute;
  private readonly edges: readonly [number, number][];

  constructor(
    private net: Poles,
    readonly own: boolean,
    looks: Looks,
    space: Space,
  ) {
    this.handles = placed(net).map((pole) => ({ address: net.address, pole, at: space.toPicture(pole.position) }));
    this.edges = own ? netEdges(net.orders).filter((edge) => edge.every((at) => net.poles[at]?.position)) : [];
    this.places = changing(this.handles.length);
    this.corners = changing(2 * this.edges.length);
    const dots = new BufferGeometry().setAttribute("position", this.places);
    this.parts = looks.layers(own).map(([material, order]) => {
      const layer = new Points(dots, material);
      layer.renderOrder = order;
      return layer;
    });
    if (own) this.parts.push(new LineSegments(new BufferGeometry().setAttribute("position", this.corners), looks.wire));
    for (const part of this.parts) part.frustumCulled = false;
    this.write(space);
  }

  /** Can these dots show the net by moving? */
  takes(net: Poles, own: boolean): boolean {
    if (net === this.net) return own === this.own;
    const { address, orders, poles } = this.net;
    return (
      net.address === address &&
      own === this.own &&
      net.orders.length === orders.length &&
      net.orders.every((order, axis) => order === orders[axis]) &&
      net.poles.length === poles.length &&
      net.poles.every((pole, at) => (pole.position === null) === (poles[at]!.position === null))
    );
  }

  move(net: Poles, space: Space): void {
    if (net === this.net) return;
    this.net = net;
    placed(net).forEach((pole, at) => {
      const handle = this.handles[at]!;
      handle.pole = pole;
      handle.at.copy(space.toPicture(pole.position));
    });
    this.write(space);
  }

  dispose(): void {
    for (const part of this.parts) part.geometry.dispose();
  }

  private write(space: Space): void {
    this.handles.forEach(({ at }, k) => this.places.setXYZ(k, at.x, at.y, at.z));
    this.edges.flat().forEach((pole, k) => {
      const { x, y, z } = space.toPicture(this.net.poles[pole]!.position!);
      this.corners.setXYZ(k, x, y, z);
    });
    this.places.needsUpdate = this.corners.needsUpdate = true;
  }
}

/** The poles that have a place. */
function placed(net: Poles): (Pole & { position: Triple })[] {
  return net.poles.filter((pole): pole is Pole & { position: Triple } => pole.position !== null);
}

function changing(count: number): BufferAttribute {
  return new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
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
