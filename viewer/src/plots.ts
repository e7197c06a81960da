// The plots, their cursors at the current time.
import uPlot from "uplot";
import type { Clock } from "./clock";
import { seconds, short } from "./format";
import type { Level, Line, Panel } from "./panels";
import type { Theme } from "./theme";

const HEIGHT_PX = 210;
const ROOM = 0.08;
const NODE_PX = 2.2;
const CLICK_PX = 4;
const SYNC = "time";
// What is smaller than this part of the least span shown is printed as 0.
const ROUNDING = 1e-3;

export class Plots {
  private plots: uPlot[] = [];
  private range: [number, number];
  private near = true;
  private readonly observer: ResizeObserver;

  constructor(
    private readonly container: HTMLElement,
    private readonly clock: Clock,
  ) {
    this.range = [clock.t0, clock.t1];
    this.observer = new ResizeObserver(() => {
      for (const plot of this.plots) fit(plot);
    });
    this.observer.observe(container);
    clock.onTime((t) => {
      this.follow(t);
    });
  }

  build(panels: Panel[], theme: Theme): void {
    for (const plot of this.plots) plot.destroy();
    this.container.replaceChildren();
    this.plots = panels.filter((panel) => this.frame(panel)).map((panel) => this.plot(panel, theme));
    this.follow(this.clock.t);
  }

  setNear(near: boolean): void {
    this.near = near;
    this.rescale();
  }

  /** Shows this stretch of time in all plots. */
  setRange(from: number, to: number): void {
    this.range = [Math.max(from, this.clock.t0), Math.min(to, this.clock.t1)];
    this.rescale();
    this.follow(this.clock.t);
  }

  /** A quarter of what is shown, about the current time. */
  zoom(): void {
    const half = (this.range[1] - this.range[0]) / 8;
    this.setRange(this.clock.t - half, this.clock.t + half);
  }

  whole(): void {
    this.setRange(this.clock.t0, this.clock.t1);
  }

  /** At once, so that places asked for next are right. */
  private rescale(): void {
    const [min, max] = this.range;
    for (const plot of this.plots) {
      plot.batch(() => {
        plot.setScale("x", { min, max });
      });
    }
  }

  private follow(t: number): void {
    for (const plot of this.plots) plot.setCursor({ left: plot.valToPos(t, "x"), top: 0 }, false);
  }

  /** The figure around a plot; whether there is anything to plot in it. */
  private frame(panel: Panel): boolean {
    const figure = document.createElement("figure");
    figure.id = `plot-${panel.id}`;
    figure.className = panel.wide ? "wide" : "";
    const title = document.createElement("h3");
    title.textContent = panel.unit ? `${panel.title} [${panel.unit}]` : panel.title;
    figure.append(title);
    if (panel.note) {
      const note = document.createElement("figcaption");
      note.textContent = panel.note;
      figure.append(note);
    }
    const summary = document.createElement("p");
    summary.className = "hidden";
    summary.textContent = describe(panel);
    figure.append(summary);
    this.container.append(figure);
    return panel.lines.length > 0;
  }

  private plot(panel: Panel, theme: Theme): uPlot {
    const figure = document.getElementById(`plot-${panel.id}`);
    const host = document.createElement("div");
    host.className = "plot";
    figure?.querySelector("h3")?.after(host);
    const x = unionOf(panel.lines);
    const data: uPlot.AlignedData = [x, ...panel.lines.map((line) => onto(line, x))] as uPlot.AlignedData;
    const plot = new uPlot(this.options(panel, theme, host), data, host);
    this.listen(plot);
    return plot;
  }

  private options(panel: Panel, theme: Theme, host: HTMLElement): uPlot.Options {
    const axis = {
      stroke: theme.ink,
      font: "12px system-ui, sans-serif",
      grid: { stroke: theme.line, width: 1 },
      ticks: { stroke: theme.line, width: 1, size: 4 },
      values: (_: uPlot, splits: number[]) => splits.map((v) => short(v, 5)),
    };
    return {
      width: host.clientWidth || 320,
      height: HEIGHT_PX,
      scales: {
        x: { time: false, range: () => this.range },
        y: { range: (_, low, high) => this.span(panel, low, high) },
      },
      axes: [
        { ...axis, size: 28, space: 60 },
        { ...axis, size: 62, space: 28 },
      ],
      cursor: {
        // Plots share the pointer's time; what is drawn with it in one is handled for all by that.
        sync: { key: SYNC, setSeries: false, scales: ["x", null], filters: { pub: moves } },
        drag: { x: true, y: false, setScale: false },
        y: false,
        points: { size: 7 },
      },
      legend: { live: true },
      series: [
        { label: "t", value: (_, t) => (t === null ? "–" : seconds(t)) },
        ...panel.lines.map((line) => ({
          label: line.label,
          stroke: line.color,
          width: 1.6,
          dash: line.dash,
          points: { show: false },
          spanGaps: true,
          value: (_: uPlot, v: number | null) => (v === null ? "–" : short(Math.abs(v) < ROUNDING * panel.least ? 0 : v)),
        })),
      ],
      hooks: {
        drawSeries: [(plot, index) => { drawExtras(plot, index, panel.lines[index - 1]); }],
        drawAxes: [(plot) => { drawLevels(plot, panel.levels); }],
        setSelect: [(plot) => { this.selected(plot); }],
        ready: [reachable],
      },
    };
  }

  /** What of the values is shown: all lines and levels, with room, and no noise magnified. */
  private span(panel: Panel, low: number | null, high: number | null): [number, number] {
    const values = [low, high, ...panel.levels.map((l) => l.y)].filter((v) => v !== null && Number.isFinite(v)) as number[];
    let [min, max] = values.length ? [Math.min(...values), Math.max(...values)] : [0, 1];
    if (panel.near !== undefined) {
      min = Math.min(min, 0);
      if (this.near) return [min, panel.near];
    }
    const lack = Math.max(panel.least - (max - min), 0) / 2;
    [min, max] = [min - lack, max + lack];
    const room = ROOM * (max - min);
    return [min - room, max + room];
  }

  /** A stretch was drawn with the pointer: show it in all plots. */
  private selected(plot: uPlot): void {
    const { left, width } = plot.select;
    if (width <= CLICK_PX) return;
    const [from, to] = [left, left + width].map((x) => plot.posToVal(x, "x"));
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.setRange(from, to);
  }

  private listen(plot: uPlot): void {
    let down = NaN;
    plot.over.addEventListener("mousedown", (event) => {
      down = event.clientX;
    });
    plot.over.addEventListener("click", (event) => {
      if (Math.abs(event.clientX - down) > CLICK_PX) return;
      this.clock.seek(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, "x"));
    });
    plot.over.addEventListener("dblclick", () => {
      this.whole();
    });
    // Cursors follow the pointer while it is over a plot, and the time otherwise.
    plot.over.addEventListener("mouseleave", () => {
      requestAnimationFrame(() => {
        this.follow(this.clock.t);
      });
    });
  }
}

const moves = (type: string): boolean => type === "mousemove" || type === "mouseleave";

function fit(plot: uPlot): void {
  const width = plot.root.parentElement?.clientWidth ?? 0;
  if (width && width !== plot.width) plot.setSize({ width, height: HEIGHT_PX });
}

/** Names in the legend switch lines on and off; let keys do so too. */
function reachable(plot: uPlot): void {
  plot.ctx.canvas.ariaHidden = "true";
  plot.root.querySelectorAll<HTMLElement>(".u-series > th").forEach((name, index) => {
    if (index === 0) return;
    name.tabIndex = 0;
    name.setAttribute("role", "button");
    name.setAttribute("aria-pressed", "true");
    name.addEventListener("click", () => {
      name.setAttribute("aria-pressed", String(plot.series[index].show));
    });
    name.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      event.stopPropagation();
      name.click();
    });
  });
}

function clipped(plot: uPlot, draw: (context: CanvasRenderingContext2D) => void): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  draw(ctx);
  ctx.restore();
}

function drawLevels(plot: uPlot, levels: Level[]): void {
  clipped(plot, (context) => {
    context.lineWidth = 1.4 * devicePixelRatio;
    context.setLineDash([6, 4].map((n) => n * devicePixelRatio));
    for (const { y, from, to, color } of levels) {
      const x0 = from === undefined ? plot.bbox.left : plot.valToPos(from, "x", true);
      const x1 = to === undefined ? plot.bbox.left + plot.bbox.width : plot.valToPos(to, "x", true);
      const height = plot.valToPos(y, "y", true);
      context.strokeStyle = color;
      context.beginPath();
      context.moveTo(x0, height);
      context.lineTo(x1, height);
      context.stroke();
    }
  });
}

/** Nodes and proven steps of a line. */
function drawExtras(plot: uPlot, index: number, line: Line | undefined): void {
  if (!line || !plot.series[index].show) return;
  clipped(plot, (context) => {
    context.strokeStyle = line.color;
    context.lineWidth = devicePixelRatio;
    if (line.steps) drawSteps(plot, context, line.steps.values as Float64Array);
    if (line.nodes) drawNodes(plot, context, line.nodes);
  });
}

function drawSteps(plot: uPlot, context: CanvasRenderingContext2D, rows: Float64Array): void {
  context.beginPath();
  let end = NaN;
  for (let i = 0; i < rows.length; i += 3) {
    const [x0, x1, y] = [
      plot.valToPos(rows[i], "x", true),
      plot.valToPos(rows[i + 1], "x", true),
      plot.valToPos(rows[i + 2], "y", true),
    ];
    if (rows[i] === end) context.lineTo(x0, y);
    else context.moveTo(x0, y);
    context.lineTo(x1, y);
    end = rows[i + 1];
  }
  context.stroke();
}

function drawNodes(plot: uPlot, context: CanvasRenderingContext2D, nodes: { x: Float64Array; y: Float64Array }): void {
  context.fillStyle = getComputedStyle(plot.root).getPropertyValue("--card");
  for (let i = 0; i < nodes.x.length; i++) {
    if (!Number.isFinite(nodes.y[i])) continue;
    context.beginPath();
    context.arc(plot.valToPos(nodes.x[i], "x", true), plot.valToPos(nodes.y[i], "y", true), NODE_PX * devicePixelRatio, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }
}

/** All times of all lines, sorted, once each. */
function unionOf(lines: Line[]): Float64Array {
  const [first, ...rest] = lines.map((line) => line.x);
  if (rest.every((x) => x.length === first.length && x.every((t, i) => t === first[i]))) return first;
  const every = new Set(lines.flatMap((line) => [...line.x]));
  return Float64Array.from(every).sort();
}

/** A line's values at these times: straight between its own, nothing outside. */
function onto(line: Line, x: Float64Array): (number | null)[] {
  const out: (number | null)[] = [];
  let i = 0;
  const last = line.x.length - 1;
  for (const t of x) {
    while (i < last && line.x[i + 1] <= t) i++;
    const [t0, t1] = [line.x[i], line.x[Math.min(i + 1, last)]];
    const share = t1 > t0 ? (t - t0) / (t1 - t0) : 0;
    const value = share === 0 ? line.y[i] : line.y[i] + share * (line.y[Math.min(i + 1, last)] - line.y[i]);
    out.push(t < line.x[0] || t > line.x[last] || !Number.isFinite(value) ? null : value);
  }
  return out;
}

/** The plot in words. */
function describe(panel: Panel): string {
  const lines = panel.lines.map((line) => {
    const known = line.y.filter((v) => Number.isFinite(v));
    const [low, high] = [known.reduce((a, b) => Math.min(a, b), Infinity), known.reduce((a, b) => Math.max(a, b), -Infinity)];
    return `${line.label} from ${short(low)} to ${short(high)}`;
  });
  const levels = [...new Set(panel.levels.map((level) => short(level.y)))];
  const limits = levels.length ? `; levels at ${levels.join(", ")}` : "";
  return `${panel.title}${panel.unit ? `, in ${panel.unit}` : ""}: ${lines.join("; ")}${limits}.`;
}
