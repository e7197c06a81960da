// Play, pause, speed, slider and keys.
import type { Clock } from "./clock";
import { element, option } from "./elements";
import { seconds } from "./format";

const STEPS = 200;

export interface Marks {
  nodes: number[];
  closest: number[];
  phases: number[];
}

export interface Others {
  nextCamera: () => void;
  zoom: () => void;
  whole: () => void;
  /** A key in the scene; whether it meant something. */
  nudge: (key: string) => boolean;
}

export class Player {
  private readonly slider = element<HTMLInputElement>("time");
  private readonly play = element<HTMLButtonElement>("play");
  private readonly speed = element<HTMLSelectElement>("speed");
  private readonly clockText = element("clock");

  constructor(
    private readonly clock: Clock,
    private readonly marks: Marks,
    private readonly others: Others,
  ) {
    this.slider.min = String(clock.t0);
    this.slider.max = String(clock.t1);
    element("end").textContent = `of ${seconds(clock.t1)}`;
    this.speed.append(...clock.speeds.map((s) => option(String(s), `${String(s)}×`)));
    this.drawMarks();
    this.listen();
    clock.onTime(() => {
      this.showTime();
    });
    clock.onState(() => {
      this.showState();
    });
    this.showTime();
    this.showState();
  }

  private listen(): void {
    const { clock } = this;
    this.slider.addEventListener("input", () => {
      clock.seek(Number(this.slider.value));
    });
    this.play.addEventListener("click", () => {
      clock.toggle();
    });
    this.speed.addEventListener("change", () => {
      clock.setSpeed(Number(this.speed.value));
    });
    element("start").addEventListener("click", () => {
      clock.seek(clock.t0);
    });
    const closest = element<HTMLButtonElement>("closest");
    closest.hidden = this.marks.closest.length === 0;
    closest.addEventListener("click", () => {
      this.toClosest();
    });
    for (const button of document.querySelectorAll<HTMLElement>("[data-seek]")) {
      button.addEventListener("click", () => {
        clock.pause();
        clock.seek(Number(button.dataset.seek));
      });
    }
    document.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      if (this.key(event)) event.preventDefault();
    });
  }

  private key(event: KeyboardEvent): boolean {
    const at = event.target as HTMLElement;
    if (at.id === "canvas" && this.others.nudge(event.key)) return true;
    // Elsewhere than on the slider, fields keep their keys; so do buttons those that press them.
    if (at !== this.slider && at.matches("select, input:not([type=checkbox])")) return false;
    if (event.key === " " && at.matches("button, input[type=checkbox], summary, [role=button]")) return false;
    if (at.matches(".scroll") && /^(Arrow|Home|End)/.test(event.key)) return false;
    const act = this.keys[event.key] as ((shift: boolean) => void) | undefined;
    act?.(event.shiftKey);
    return act !== undefined;
  }

  private readonly keys: Record<string, (shift: boolean) => void> = {
    " ": () => {
      this.clock.toggle();
    },
    ArrowLeft: (shift) => {
      this.step(shift ? -10 : -1);
    },
    ArrowRight: (shift) => {
      this.step(shift ? 10 : 1);
    },
    Home: () => {
      this.clock.seek(this.clock.t0);
    },
    End: () => {
      this.clock.seek(this.clock.t1);
    },
    ",": () => {
      this.toNode(-1);
    },
    ".": () => {
      this.toNode(1);
    },
    "[": () => {
      this.clock.shift(-1);
    },
    "]": () => {
      this.clock.shift(1);
    },
    c: () => {
      this.toClosest();
    },
    v: () => {
      this.others.nextCamera();
    },
    z: () => {
      this.others.zoom();
    },
    Z: () => {
      this.others.whole();
    },
  };

  private step(count: number): void {
    this.clock.pause();
    this.clock.seek(this.clock.t + (count * (this.clock.t1 - this.clock.t0)) / STEPS);
  }

  /** To the next node of any plan in this direction. */
  private toNode(direction: number): void {
    const ahead = this.marks.nodes
      .map((t) => direction * (t - this.clock.t))
      .filter((gap) => gap > 1e-9 * (this.clock.t1 - this.clock.t0));
    if (!ahead.length) return;
    this.clock.pause();
    this.clock.seek(this.clock.t + direction * Math.min(...ahead));
  }

  /** To the closest approach of the first plan, then of the next. */
  private toClosest(): void {
    const { closest } = this.marks;
    if (!closest.length) return;
    this.clock.pause();
    this.clock.seek(closest[(closest.indexOf(this.clock.t) + 1) % closest.length]);
  }

  private showTime(): void {
    this.slider.value = String(this.clock.t);
    this.slider.setAttribute("aria-valuetext", seconds(this.clock.t));
    this.clockText.textContent = seconds(this.clock.t);
  }

  private showState(): void {
    this.play.setAttribute("aria-label", this.clock.playing ? "Pause" : "Play");
    this.play.classList.toggle("playing", this.clock.playing);
    this.speed.value = String(this.clock.speed);
  }

  /** Under the slider: nodes, ends of phases, and the closest approaches. */
  private drawMarks(): void {
    const svg = element("ticks");
    svg.setAttribute("viewBox", "0 0 1000 10");
    const x = (t: number): string => ((1000 * (t - this.clock.t0)) / (this.clock.t1 - this.clock.t0)).toFixed(2);
    const mark = (t: number, kind: string): SVGLineElement => {
      const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
      for (const [key, value] of Object.entries({ x1: x(t), x2: x(t), y1: "0", y2: "10", class: kind })) line.setAttribute(key, value);
      return line;
    };
    svg.append(
      ...this.marks.nodes.map((t) => mark(t, "node")),
      ...this.marks.phases.map((t) => mark(t, "phase")),
      ...this.marks.closest.map((t) => mark(t, "closest")),
    );
  }
}
