// A mesh ready to be drawn: normals smooth but across creases, where corners are doubled.
import { BufferAttribute, BufferGeometry } from "three";
import type { Arrays, BodyData } from "./data";

// Faces that bend by more than this at an edge are not smoothed over it.
const CREASE_COSINE = Math.cos((25 * Math.PI) / 180);
// Normals that differ by less than this look alike.
const SAME_NORMAL = 1e-4;

export interface Shape {
  faces: BufferGeometry;
  edges: BufferGeometry;
  triangles: number;
  /** Whether it has an inside, so that its back is never seen. */
  closed: boolean;
}

/** Builds each body once, however many places draw it. */
export class Shapes {
  private readonly known = new Map<string, Shape>();

  constructor(private readonly arrays: Arrays) {}

  of(body: BodyData): Shape {
    const key = `${body.v.b} ${body.i.b} ${body.e.b}`;
    let shape = this.known.get(key);
    if (!shape) {
      shape = this.build(body);
      this.known.set(key, shape);
    }
    return shape;
  }

  private build(body: BodyData): Shape {
    const points = this.arrays.table(body.v).values;
    const corners = this.arrays.table(body.i).values;
    const faces = new BufferGeometry();
    const { positions, normals, index } = smoothed(points, corners);
    faces.setAttribute("position", new BufferAttribute(positions, 3));
    faces.setAttribute("normal", new BufferAttribute(normals, 3));
    faces.setIndex(new BufferAttribute(index, 1));
    const edges = new BufferGeometry();
    edges.setAttribute("position", new BufferAttribute(gathered(points, this.arrays.table(body.e).values), 3));
    return { faces, edges, triangles: corners.length / 3, closed: !isFlat(points) };
  }
}

type Numbers = ArrayLike<number>;

function gathered(points: Numbers, indices: Numbers): Float32Array {
  const out = new Float32Array(3 * indices.length);
  for (let i = 0; i < indices.length; i++) {
    for (let k = 0; k < 3; k++) out[3 * i + k] = points[3 * indices[i] + k];
  }
  return out;
}

/** Of shapes in the plane every point is at the same height. */
function isFlat(points: Numbers): boolean {
  for (let i = 5; i < points.length; i += 3) if (points[i] !== points[2]) return false;
  return true;
}

interface Indexed {
  positions: Float32Array;
  normals: Float32Array;
  index: Uint32Array;
}

/** Corners with normals: the mean, by area, of the faces around that are nearly as level. */
function smoothed(points: Numbers, corners: Numbers): Indexed {
  const area = faceNormals(gathered(points, corners));
  const [starts, faces] = around(points.length / 3, corners);
  const [positions, normals]: [number[], number[]] = [[], []];
  const index = new Uint32Array(corners.length);
  // Corners at a point have few normals: each is kept once.
  const own: number[][] = Array.from({ length: points.length / 3 }, () => []);
  for (let corner = 0; corner < corners.length; corner++) {
    const point = corners[corner];
    const n = normalAt(area, 3 * Math.floor(corner / 3), faces.subarray(starts[point], starts[point + 1]));
    let found = own[point].find((i) => n.every((value, k) => Math.abs(value - normals[3 * i + k]) < SAME_NORMAL));
    if (found === undefined) {
      found = positions.length / 3;
      own[point].push(found);
      for (let k = 0; k < 3; k++) {
        positions.push(points[3 * point + k]);
        normals.push(n[k]);
      }
    }
    index[corner] = found;
  }
  return { positions: new Float32Array(positions), normals: new Float32Array(normals), index };
}

function normalAt(area: Float64Array, face: number, around: Uint32Array): number[] {
  const sum = [0, 0, 0];
  for (const neighbour of around) {
    const other = 3 * neighbour;
    if (cosine(area, face, other) >= CREASE_COSINE) {
      for (let k = 0; k < 3; k++) sum[k] += area[other + k];
    }
  }
  const length = Math.hypot(sum[0], sum[1], sum[2]) || 1;
  return sum.map((value) => value / length);
}

function faceNormals(positions: Float32Array): Float64Array {
  const out = new Float64Array(positions.length / 3);
  for (let f = 0; f < out.length / 3; f++) {
    const at = (corner: number, k: number): number => positions[9 * f + 3 * corner + k];
    const a = [0, 1, 2].map((k) => at(1, k) - at(0, k));
    const b = [0, 1, 2].map((k) => at(2, k) - at(0, k));
    out[3 * f] = a[1] * b[2] - a[2] * b[1];
    out[3 * f + 1] = a[2] * b[0] - a[0] * b[2];
    out[3 * f + 2] = a[0] * b[1] - a[1] * b[0];
  }
  return out;
}

/** The faces at each point, one list after the other, and where each list starts. */
function around(count: number, corners: Numbers): [Uint32Array, Uint32Array] {
  const starts = new Uint32Array(count + 1);
  for (let i = 0; i < corners.length; i++) starts[corners[i] + 1]++;
  for (let i = 0; i < count; i++) starts[i + 1] += starts[i];
  const fill = starts.slice();
  const faces = new Uint32Array(corners.length);
  for (let i = 0; i < corners.length; i++) faces[fill[corners[i]]++] = Math.floor(i / 3);
  return [starts, faces];
}

function cosine(v: Float64Array, i: number, j: number): number {
  if (i === j) return 1;
  const dot = v[i] * v[j] + v[i + 1] * v[j + 1] + v[i + 2] * v[j + 2];
  const sizes = Math.hypot(v[i], v[i + 1], v[i + 2]) * Math.hypot(v[j], v[j + 1], v[j + 2]);
  return sizes > 0 ? dot / sizes : 0;
}
