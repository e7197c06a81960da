// What each plot shows: lines, nodes, limits and proven bounds, from the plans of the page.
import { type Arrays, column, type PairData, pairLabel, type PageData, type PlanData, type Table, type TrackData } from "./data";
import type { Theme } from "./theme";

export interface Line {
  label: string;
  color: string;
  dash: number[];
  x: Float64Array;
  y: Float64Array;
  /** Circles on the line. */
  nodes?: { x: Float64Array; y: Float64Array };
  /** Stretches [from, to, height] proven for the line. */
  steps?: Table;
}

/** A level that lines are judged by; without ends it spans the plot. */
export interface Level {
  y: number;
  from?: number;
  to?: number;
  color: string;
}

export interface Panel {
  id: string;
  title: string;
  unit: string;
  lines: Line[];
  levels: Level[];
  /** Less than this is noise and not magnified. */
  least: number;
  /** The top of the plot where it shows what is near the margin only. */
  near?: number;
  note?: string;
  wide?: boolean;
}

/** A vehicle of a plan over all its phases; the unit in which plots are chosen. */
export interface Source {
  key: string;
  name: string;
  plan: number;
  tracks: TrackData[];
  dash: number[];
}

const DASHES = [[], [7, 4], [2, 3], [9, 3, 2, 3]];
// Smallest spans shown in metres, m/s, components and rad/s: below lies rounding.
const LEAST = { position: 1e-3, velocity: 1e-6, attitude: 1e-3, rate: 1e-6, control: 1e-9, clearance: 1e-3 };
const CLOSE_UP = 6;
const LEAST_SHARE = 0.1;

export function sources(data: PageData): Source[] {
  const found: Source[] = [];
  data.plans.forEach((plan, index) => {
    for (const vehicle of new Set(plan.tracks.map((t) => t.vehicle))) {
      const tracks = plan.tracks.filter((t) => t.vehicle === vehicle);
      const name = vehicleName(data, plan, vehicle);
      const dash = DASHES[found.length % DASHES.length];
      found.push({ key: `${index} ${vehicle}`, name, plan: index, tracks, dash });
    }
  });
  return found;
}

/** A vehicle's name, with its plan's where there are several. */
export function vehicleName(data: PageData, plan: PlanData, vehicle: string): string {
  if (data.plans.length === 1) return vehicle;
  const alone = data.plans.every((p) => new Set(p.tracks.map((t) => t.vehicle)).size === 1);
  return alone ? plan.label : `${plan.label}: ${vehicle}`;
}

/** The colour of each plan's first vehicle; vehicles have theirs in the order of the plans. */
export function planColors(data: PageData, theme: Theme): string[] {
  let rank = 0;
  return data.plans.map((plan) => {
    const first = rank;
    rank += new Set(plan.tracks.map((t) => t.vehicle)).size;
    return theme.series[first % theme.series.length];
  });
}

export function panels(data: PageData, shown: Source[], arrays: Arrays, theme: Theme): Panel[] {
  const make = new Maker(shown, arrays, theme);
  const turning = shown.some((s) => s.tracks.some((t) => t.turns));
  return [
    clearance(data, arrays, theme),
    make.motion("position", "Position, inertial", "m", "xyz", LEAST.position),
    make.motion("velocity", "Velocity, inertial", "m/s", "xyz", LEAST.velocity),
    ...(turning
      ? [
          make.motion("attitude", "Attitude q_IB", "", "wxyz", LEAST.attitude),
          make.motion("rate", "Rates, body axes", "rad/s", "xyz", LEAST.rate),
        ]
      : []),
    ...make.controls(),
    hamiltonian(data, arrays, theme),
  ];
}

const KEYS = { position: "p", velocity: "v", attitude: "q", rate: "w" } as const;

class Maker {
  constructor(
    private readonly shown: Source[],
    private readonly arrays: Arrays,
    private readonly theme: Theme,
  ) {}

  motion(id: keyof typeof KEYS, title: string, unit: string, components: string, least: number): Panel {
    const key = KEYS[id];
    const lines = this.shown.flatMap((source) => {
      const tracks = source.tracks.filter((t) => id === "position" || id === "velocity" || t.turns);
      const flat = this.arrays.table(source.tracks[0].dense.v).columns;
      const names = id === "position" || id === "velocity" ? components.slice(0, flat) : components;
      return tracks.length === 0
        ? []
        : [...names].map((name, i) =>
            this.line(source, name, this.theme.component[name], tracks.map((t) => [t.dense.t, t.dense[key], t.nodes.t, t.nodes[key]]), i),
          );
    });
    return { id, title, unit, lines, levels: [], least };
  }

  /** One plot for each unit of any vehicle's controls. */
  controls(): Panel[] {
    const found = new Map<string, Panel>();
    for (const source of this.shown) {
      for (const [k, control] of source.tracks[0].controls.entries()) {
        const panel = found.get(control.unit) ?? {
          id: `control-${String(found.size)}`, title: control.title, unit: control.unit, lines: [], levels: [], least: LEAST.control,
        };
        found.set(control.unit, panel);
        control.names.forEach((name, i) => {
          const color = this.theme.component[name.at(-1) ?? ""] ?? this.theme.series[i % this.theme.series.length];
          const tracks = source.tracks.filter((t) => t.controls.length > k && t.controls[k].names.length > i);
          panel.lines.push(this.line(source, name, color, tracks.map((t) => [t.dense.t, t.dense.u[k], t.nodes.t, t.nodes.u[k]]), i));
        });
        for (const track of source.tracks) addLimits(panel, track, k, this.theme.limit);
      }
    }
    return [...found.values()];
  }

  private line(source: Source, name: string, color: string, refs: TrackData["dense"]["t"][][], i: number): Line {
    const label = this.shown.length > 1 ? `${source.name} ${name}` : name;
    const [x, y, nodeX, nodeY] = [0, 1, 2, 3].map((part) =>
      joined(refs.map((track) => {
        const table = this.arrays.table(track[part]);
        return column(table, part % 2 ? i : 0);
      })),
    );
    return { label, color, dash: source.dash, x, y, nodes: { x: nodeX, y: nodeY } };
  }
}

function addLimits(panel: Panel, track: TrackData, k: number, color: string): void {
  const control = track.controls.at(k);
  for (const y of [...(control?.lower ?? []), ...(control?.upper ?? [])]) {
    if (y !== null && !panel.levels.some((level) => level.y === y)) panel.levels.push({ y, color });
  }
}

function clearance(data: PageData, arrays: Arrays, theme: Theme): Panel {
  const lines: Line[] = [];
  const levels: Level[] = [];
  const names = [...new Set(data.plans.flatMap(pairsOf).map((p) => p.name))];
  data.plans.forEach((plan, index) => {
    for (const [rank, name] of names.entries()) {
      const found = plan.separations.flatMap((s) => s.pairs.filter((p) => p.name === name).map((pair) => ({ s, pair })));
      if (found.length === 0) continue;
      const label = data.plans.length > 1 ? `${plan.label}: ${pairLabel(name)}` : pairLabel(name);
      lines.push({
        label,
        color: theme.series[rank % theme.series.length],
        dash: DASHES[index % DASHES.length],
        x: joined(found.map(({ s }) => column(arrays.table(s.t), 0))),
        y: joined(found.map(({ pair }) => column(arrays.table(pair.d), 0))),
        steps: stacked(found.map(({ pair }) => arrays.table(pair.proven))),
      });
      for (const { pair } of found) addMargins(levels, pair, theme.limit);
    }
  });
  const largest = Math.max(0, ...levels.map((level) => level.y));
  const lowest = Math.min(...lines.map((line) => least(line.y)));
  const top = CLOSE_UP * largest || 1;
  const more = data.plans.flatMap((p) => p.separations).reduce((sum, s) => sum + s.more, 0);
  return {
    id: "clearance",
    title: "Clearance of each pair",
    unit: "m",
    lines,
    levels,
    least: LEAST.clearance,
    near: Math.max(top, lowest + top / 2),
    wide: true,
    note:
      lines.length === 0
        ? "Nothing to keep clear of."
        : `Dashed: the margin. Steps: what is proven for every instant of each interval.${more > 0 ? ` ${more} more pairs are farther apart.` : ""}`,
  };
}

const pairsOf = (plan: PlanData): PairData[] => plan.separations.flatMap((s) => s.pairs);

function addMargins(levels: Level[], pair: PairData, color: string): void {
  for (const [from, to, y] of pair.windows) {
    if (y !== null && !levels.some((l) => l.y === y && l.from === from && l.to === to)) {
      levels.push({ y, from, to, color });
    }
  }
}

function hamiltonian(data: PageData, arrays: Arrays, theme: Theme): Panel {
  const lines: Line[] = [];
  const levels: Level[] = [];
  const colors = planColors(data, theme);
  let reach = 0;
  data.plans.forEach((plan, index) => {
    for (const found of plan.hamiltonian) {
      const x = column(arrays.table(found.t), 0);
      const y = column(arrays.table(found.h), 0);
      if (y.length === 0) continue;
      const color = colors[index];
      const mean = y.reduce((a, b) => a + b, 0) / y.length;
      const phase = plan.hamiltonian.length > 1 ? `H, ${found.phase}` : "H";
      const label = data.plans.length > 1 ? `${plan.label}: ${phase}` : phase;
      lines.push({ label, color, dash: DASHES[index % DASHES.length], x, y, nodes: { x, y } });
      levels.push({ y: mean, from: x[0], to: x[x.length - 1], color: theme.muted });
      reach = Math.max(reach, Math.abs(mean));
    }
  });
  const note = lines.length
    ? "Constant on an optimal trajectory where nothing depends on time; dashed: the mean."
    : "The scheme gives no costates.";
  // A constant should look constant.
  return { id: "hamiltonian", title: "Lower Hamiltonian at the nodes", unit: "cost/s", lines, levels, least: 2 * LEAST_SHARE * reach, note, wide: true };
}

function joined(parts: Float64Array[]): Float64Array {
  if (parts.length === 1) return parts[0];
  const out = new Float64Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

function stacked(tables: Table[]): Table {
  const values = joined(tables.map((t) => Float64Array.from(t.values)));
  return { values, rows: values.length / 3, columns: 3 };
}

const least = (values: Float64Array): number => values.reduce((a, b) => Math.min(a, b), Infinity);
