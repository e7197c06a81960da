// The closest points of a plan at the current time, and the plane between them.
import {
  BufferAttribute,
  DoubleSide,
  Group,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Vector3,
} from "three";
import type { Arrays, PlanData, SeparationData, Table } from "./data";
import { pairLabel } from "./data";
import { dots } from "./dots";
import { moveLine, thickLine } from "./lines";
import { Locator, vectorAt } from "./samples";

const DOT_PX = 10;
const LINE_PX = 3;
const PLANE_OPACITY = 0.16;
const SQUARE = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, -1, -1, 0];

/** What is nearest at one time. */
export interface Nearest {
  pair: string;
  distance: number;
  middle: Vector3;
}

interface Source {
  at: Locator;
  names: string[];
  pair: Table;
  d: Table;
  a: Table;
  b: Table;
  n: Table;
}

export class ClosestActor {
  readonly group = new Group();
  nearest: Nearest | null = null;
  private readonly sources: Source[];
  private readonly line;
  private readonly points;
  private readonly plane = new Group();
  private readonly a = new Vector3();
  private readonly b = new Vector3();
  private readonly n = new Vector3();

  constructor(plan: PlanData, arrays: Arrays, color: string, size: number) {
    this.sources = plan.separations.flatMap((s) => source(s, arrays));
    this.line = thickLine([0, 0, 0, 0, 0, 0], color, LINE_PX);
    this.points = dots(new Float32Array(6), color, DOT_PX);
    this.points.frustumCulled = this.line.frustumCulled = false;
    // Seen through what it touches: the points lie on surfaces.
    for (const material of [this.line.material, this.points.material]) {
      material.depthTest = false;
      material.transparent = true;
    }
    this.line.renderOrder = this.points.renderOrder = 2;
    const sheet = new MeshBasicMaterial({
      color,
      side: DoubleSide,
      transparent: true,
      opacity: PLANE_OPACITY,
      depthWrite: false,
    });
    const border = thickLine(SQUARE, color, 1.5, 0.8);
    this.plane.add(new Mesh(new PlaneGeometry(2, 2), sheet), border);
    this.plane.scale.set(size, size, 1);
    this.group.add(this.line, this.points, this.plane);
  }

  show(t: number): void {
    const from = this.sources.find((s) => t <= s.at.last) ?? this.sources.at(-1);
    if (!from) return;
    from.at.to(t);
    const row = from.at.nearest;
    const same = from.pair.values[from.at.row] === from.pair.values[Math.min(from.at.row + 1, from.at.times.rows - 1)];
    // Between samples of one pair the points go straight; where the pair changes they jump.
    if (!same) from.at.share = Math.round(from.at.share);
    vectorAt(from.a, from.at, this.a);
    vectorAt(from.b, from.at, this.b);
    vectorAt(from.n, from.at, this.n).normalize();
    const { values } = from.d;
    const next = Math.min(from.at.row + 1, from.at.times.rows - 1);
    const distance = values[from.at.row] + from.at.share * (values[next] - values[from.at.row]);
    const middle = this.a.clone().add(this.b).multiplyScalar(0.5);
    this.nearest = { pair: pairLabel(from.names[from.pair.values[row]]), distance, middle };
    this.place(middle);
  }

  setShown(visible: boolean): void {
    this.group.visible = visible && this.sources.length > 0;
  }

  private place(middle: Vector3): void {
    moveLine(this.line, [...this.a.toArray(), ...this.b.toArray()]);
    const position = this.points.geometry.getAttribute("position") as BufferAttribute;
    position.setXYZ(0, ...this.a.toArray());
    position.setXYZ(1, ...this.b.toArray());
    position.needsUpdate = true;
    this.plane.position.copy(middle);
    this.plane.quaternion.setFromRotationMatrix(upright(this.n));
  }
}

/** Turns z to the normal and keeps y as near to up as may be, so that the plane does not roll. */
function upright(n: Vector3): Matrix4 {
  const up = Math.abs(n.z) < 0.99 ? new Vector3(0, 0, 1) : new Vector3(0, 1, 0);
  const x = up.cross(n).normalize();
  return new Matrix4().makeBasis(x, new Vector3().crossVectors(n, x), n);
}

function source(found: SeparationData, arrays: Arrays): Source[] {
  const c = found.closest;
  if (!c) return [];
  const [pair, d, a, b, n] = [c.pair, c.d, c.a, c.b, c.n].map((ref) => arrays.table(ref));
  return [{ at: new Locator(arrays.table(found.t)), names: c.names, pair, d, a, b, n }];
}
