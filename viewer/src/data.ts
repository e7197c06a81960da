// What the page is given: the JSON that berthing/report/offline writes, and its arrays.

/** A reference to an array: buffer, type, shape. */
export interface Ref {
  b: number;
  t: "f32" | "f64" | "u16" | "u32";
  n: number[];
}

export interface BodyData {
  v: Ref;
  i: Ref;
  e: Ref;
  /** Metres by which it is drawn too small, at most. */
  off: number;
}

export interface MotionData {
  t: Ref;
  p: Ref;
  q: Ref;
  v: Ref;
  w: Ref;
  u: Ref[];
}

export interface ControlPanel {
  title: string;
  unit: string;
  names: string[];
  lower: (number | null)[];
  upper: (number | null)[];
}

export interface TrackData {
  vehicle: string;
  phase: string;
  body: BodyData;
  turns: boolean;
  dense: MotionData;
  nodes: MotionData;
  controls: ControlPanel[];
  ghosts: number[];
}

export interface StructureData {
  name: string;
  body: BodyData;
  t: Ref;
  p: Ref;
  q: Ref;
  ghosts: number[];
}

export interface PairData {
  name: string;
  d: Ref;
  windows: [number, number, number | null][];
  proven: Ref;
}

export interface ClosestData {
  names: string[];
  pair: Ref;
  d: Ref;
  a: Ref;
  b: Ref;
  n: Ref;
}

export interface SeparationData {
  phase: string;
  t: Ref;
  pairs: PairData[];
  more: number;
  closest: ClosestData | null;
}

export interface PlanData {
  label: string;
  dim: number;
  span: [number, number];
  closest_time: number | null;
  tracks: TrackData[];
  structures: StructureData[];
  separations: SeparationData[];
  hamiltonian: { phase: string; t: Ref; h: Ref }[];
}

export interface PageData {
  schema_version: number;
  plans: PlanData[];
  buffers: string[];
}

/** An array with its shape; rows are consecutive. */
export interface Table {
  values: Float32Array | Float64Array | Uint16Array | Uint32Array;
  rows: number;
  columns: number;
}

const TYPES = { f32: Float32Array, f64: Float64Array, u16: Uint16Array, u32: Uint32Array };

/** Decodes references, each buffer once. */
export class Arrays {
  private readonly known = new Map<string, Table>();

  constructor(private readonly buffers: string[]) {}

  table(ref: Ref): Table {
    const key = `${ref.b} ${ref.t} ${ref.n.join(" ")}`;
    let found = this.known.get(key);
    if (!found) {
      const values = new TYPES[ref.t](bytes(this.buffers[ref.b]).buffer);
      found = { values, rows: ref.n[0], columns: ref.n[1] ?? 1 };
      this.known.set(key, found);
    }
    return found;
  }
}

/** One column of a table as plain numbers. */
export function column(table: Table, index: number): Float64Array {
  const out = new Float64Array(table.rows);
  for (let i = 0; i < table.rows; i++) out[i] = table.values[i * table.columns + index];
  return out;
}

function bytes(base64: string): Uint8Array<ArrayBuffer> {
  const raw = atob(base64);
  const out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) out[i] = raw.charCodeAt(i);
  return out;
}

export function readPage(): PageData {
  const element = document.getElementById("data");
  return JSON.parse(element?.textContent ?? "") as PageData;
}

/** "spacecraft.hull|truss.bay3" as it is read. */
export const pairLabel = (name: string): string => name.replace("|", " – ");
