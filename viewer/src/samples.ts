// Values between samples: rows at sorted times.
import { Quaternion, Vector3 } from "three";
import type { Table } from "./data";

/** Where a time lies among sorted times: the row before it, and how far on to the next. */
export class Locator {
  row = 0;
  share = 0;
  private t = NaN;

  constructor(readonly times: Table) {}

  get first(): number {
    return this.times.values[0];
  }

  get last(): number {
    return this.times.values[this.times.rows - 1];
  }

  to(t: number): this {
    if (t === this.t) return this;
    this.t = t;
    const { values, rows } = this.times;
    let low = 0;
    let high = rows - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (values[middle] <= t) low = middle;
      else high = middle;
    }
    this.row = low;
    const step = rows > 1 ? values[high] - values[low] : 0;
    this.share = step > 0 ? Math.min(Math.max((t - values[low]) / step, 0), 1) : 0;
    return this;
  }

  /** The row nearest to the time. */
  get nearest(): number {
    return this.share > 0.5 ? Math.min(this.row + 1, this.times.rows - 1) : this.row;
  }
}

export function vectorAt(table: Table, at: Locator, out: Vector3): Vector3 {
  const { values, columns, rows } = table;
  const i = at.row * columns;
  const j = Math.min(at.row + 1, rows - 1) * columns;
  const mix = (k: number): number =>
    k < columns ? values[i + k] + at.share * (values[j + k] - values[i + k]) : 0;
  return out.set(mix(0), mix(1), mix(2));
}

const next = new Quaternion();

/** Scalar first in the table, as everywhere in berthing. */
export function quaternionAt(table: Table, at: Locator, out: Quaternion): Quaternion {
  quaternionRow(table, at.row, out);
  if (at.share > 0) out.slerp(quaternionRow(table, at.row + 1, next), at.share);
  return out;
}

function quaternionRow(table: Table, row: number, out: Quaternion): Quaternion {
  const i = 4 * Math.min(row, table.rows - 1);
  const v = table.values;
  return out.set(v[i + 1], v[i + 2], v[i + 3], v[i]);
}
