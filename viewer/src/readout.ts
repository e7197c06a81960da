// The state at the current time, in numbers and in words.
import { Quaternion, Vector3 } from "three";
import type { Clock } from "./clock";
import { type Arrays, pairLabel, type PageData, type PlanData } from "./data";
import { element } from "./elements";
import { fixed, seconds, short } from "./format";
import type { Source } from "./panels";
import { Locator, quaternionAt, vectorAt } from "./samples";

// Screen readers are told when the time has stood still this long.
const QUIET_MS = 700;
const COLUMNS = ["", "x [m]", "y [m]", "z [m]", "Speed [m/s]", "Turned by [°]", "Rate [rad/s]"];

interface Row {
  source: Source;
  cells: HTMLElement[];
  at: Locator[];
}

interface NearRow {
  plan: PlanData;
  cell: HTMLElement;
}

/** What is closest in a plan at a time, in words. */
export function closestText(plan: PlanData, arrays: Arrays, t: number): string {
  const found = plan.separations.find((s) => t <= new Locator(arrays.table(s.t)).last) ?? plan.separations.at(-1);
  if (!found?.closest) return "nothing to keep clear of";
  const row = new Locator(arrays.table(found.t)).to(t).nearest;
  const pair = found.closest.names[arrays.table(found.closest.pair).values[row]];
  const distance = arrays.table(found.closest.d).values[row];
  return `${pairLabel(pair)}, ${fixed(distance, 4)} m`;
}

export class Readout {
  private readonly rows: Row[] = [];
  private readonly near: NearRow[] = [];
  private readonly spoken = element("spoken");
  private timer = 0;
  private readonly vector = new Vector3();
  private readonly rotation = new Quaternion();

  constructor(
    private readonly data: PageData,
    sources: Source[],
    private readonly arrays: Arrays,
    clock: Clock,
  ) {
    element("state").append(this.table(sources), this.nearList());
    clock.onTime((t) => {
      this.show(t);
      this.speakLater(t);
    });
    this.show(clock.t);
  }

  private table(sources: Source[]): HTMLTableElement {
    const table = document.createElement("table");
    const head = table.createTHead().insertRow();
    for (const name of COLUMNS) {
      const cell = document.createElement("th");
      cell.scope = "col";
      cell.textContent = name;
      head.append(cell);
    }
    const body = table.createTBody();
    for (const source of sources) {
      const row = body.insertRow();
      const name = document.createElement("th");
      name.scope = "row";
      name.textContent = source.name;
      row.append(name);
      const cells = COLUMNS.slice(1).map(() => {
        const cell = row.insertCell();
        cell.className = "number";
        return cell;
      });
      const at = source.tracks.map((t) => new Locator(this.arrays.table(t.dense.t)));
      this.rows.push({ source, cells, at });
    }
    return table;
  }

  private nearList(): HTMLElement {
    const list = document.createElement("dl");
    list.className = "near";
    for (const plan of this.data.plans) {
      const term = document.createElement("dt");
      term.textContent = this.data.plans.length > 1 ? `Closest, ${plan.label}` : "Closest";
      const cell = document.createElement("dd");
      list.append(term, cell);
      this.near.push({ plan, cell });
    }
    return list;
  }

  private show(t: number): void {
    for (const row of this.rows) this.fill(row, t);
    for (const { plan, cell } of this.near) cell.textContent = closestText(plan, this.arrays, t);
  }

  private fill({ source, cells, at }: Row, t: number): void {
    const known = at.findIndex((a) => t <= a.last);
    const k = known < 0 ? at.length - 1 : known;
    const { dense, turns } = source.tracks[k];
    const here = at[k].to(t);
    const table = (ref: (typeof dense)["p"]) => this.arrays.table(ref);
    const p = vectorAt(table(dense.p), here, this.vector).toArray().map((v) => fixed(v, 3));
    const speed = short(vectorAt(table(dense.v), here, this.vector).length(), 3);
    const rate = short(vectorAt(table(dense.w), here, this.vector).length(), 3);
    const q = quaternionAt(table(dense.q), here, this.rotation);
    const angle = (2 * Math.atan2(Math.hypot(q.x, q.y, q.z), Math.abs(q.w)) * 180) / Math.PI;
    const values = [...p, speed, turns ? fixed(angle, 1) : "–", turns ? rate : "–"];
    cells.forEach((cell, i) => {
      cell.textContent = values[i];
    });
  }

  private speakLater(t: number): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      const where = this.rows.map(({ source, cells }) =>
        `${source.name} at ${cells.slice(0, 3).map((c) => c.textContent).join(", ")} m`,
      );
      const near = this.near.map(({ plan, cell }) =>
        `${this.near.length > 1 ? `${plan.label}, ` : ""}closest ${cell.textContent ?? ""}`,
      );
      this.spoken.textContent = `${seconds(t)}: ${[...where, ...near].join("; ")}`;
    }, QUIET_MS);
  }
}
