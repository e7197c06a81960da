// Puts the page together.
import { WebGLRenderer } from "three";
import { Clock } from "./clock";
import { Arrays, column, readPage } from "./data";
import { checkbox, element, fillLegend, option } from "./elements";
import { short } from "./format";
import { panels, planColors, sources, type Source } from "./panels";
import { Player } from "./player";
import { Plots } from "./plots";
import { closestText, Readout } from "./readout";
import { SceneView } from "./scene";
import type { Layers } from "./actors";
import { onThemeChange, theme } from "./theme";

// More vehicles than this are not plotted until they are chosen.
const PLOTTED = 3;

const data = readPage();
const arrays = new Arrays(data.buffers);
const clock = new Clock(
  Math.min(...data.plans.map((p) => p.span[0])),
  Math.max(...data.plans.map((p) => p.span[1])),
);
const all = sources(data);
const chosen = new Set(all.slice(0, PLOTTED).map((s) => s.key));
const layers: Layers = { ghosts: data.plans.length === 1, trails: true, nodes: true, plane: true, grid: true };
const LAYER_NAMES: Record<keyof Layers, string> = {
  ghosts: "Ghosts",
  trails: "Trail",
  nodes: "Nodes",
  plane: "Closest points and plane",
  grid: "Grid",
};

const canvas = element<HTMLCanvasElement>("canvas");
const cameras = element<HTMLSelectElement>("camera");
const plots = new Plots(element("grid"), clock);
const renderer = newRenderer();
let scene: SceneView | undefined;

/** The renderer, or a word about why there is none: the rest of the page does without. */
function newRenderer(): WebGLRenderer | undefined {
  try {
    // Its own complaint would be an error on the console of a page that works.
    if (!document.createElement("canvas").getContext("webgl2")) throw new Error("no WebGL 2");
    return new WebGLRenderer({ canvas, antialias: true });
  } catch {
    const trouble = element("trouble");
    trouble.textContent = "This browser has no WebGL, so there is no scene; all else works without it.";
    trouble.hidden = false;
    return undefined;
  }
}

function buildScene(camera = "overview"): void {
  if (!renderer) return;
  scene?.dispose();
  scene = new SceneView(renderer, element("tag"), data, arrays, layers, theme());
  scene.show(clock.t);
  scene.setLayers(layers);
  cameras.replaceChildren(...scene.view.options.map((o) => option(o.value, o.text)));
  cameras.value = camera;
  scene.resize(canvas.clientWidth, canvas.clientHeight);
  scene.view.choose(cameras.value);
  describeScene();
}

function describeScene(): void {
  const vehicles = all.map((s) => s.name).join(", ");
  const structures = [...new Set(data.plans.flatMap((p) => p.structures.map((s) => s.name)))].join(", ");
  const near = data.plans.map((p) => closestText(p, arrays, p.closest_time ?? p.span[0])).join("; ");
  canvas.setAttribute(
    "aria-label",
    `Vehicles ${vehicles} among structures ${structures || "none"}. Closest of all: ${near}. The table “Now” has the numbers of the current time.`,
  );
}

function buildPlots(): void {
  const colors = theme();
  const shown = all.filter((s) => chosen.has(s.key));
  plots.build(panels(data, shown, arrays, colors), colors);
  const lines = (source: Source) => ({ text: source.name, color: colors.ink, dash: source.dash });
  const components = ["x", "y", "z", "w"].map((name) => ({ text: name, color: colors.component[name] }));
  fillLegend(element("dashes"), all.length > 1 ? [...components, ...shown.map(lines)] : components);
}

function buildLegend(): void {
  const colors = theme();
  const vehicles = new Map(scene?.vehicles.map((v) => [v.name, v.color]));
  const several = data.plans.length > 1;
  fillLegend(element("legend"), [
    ...[...vehicles].map(([text, color]) => ({ text, color })),
    ...(data.plans.some((p) => p.structures.length) ? [{ text: "structure", color: colors.structure }] : []),
    ...(several ? [] : [{ text: "closest points", color: colors.contact, dot: true }]),
  ]);
  document.querySelectorAll<HTMLElement>(".plan").forEach((name) => {
    name.style.borderColor = planColors(data, colors)[Number(name.dataset.plan)];
  });
}

/** Says so where shapes are drawn with fewer triangles than they have. */
function tellCoarse(): void {
  const bodies = data.plans.flatMap((p) => [...p.tracks, ...p.structures].map((one) => one.body));
  const off = Math.max(0, ...bodies.map((body) => body.off));
  const note = element("coarse");
  note.hidden = off === 0;
  note.textContent = `Drawn with fewer triangles than the shapes have, up to ${short(off, 2)} m inside them; clearance is that of the shapes themselves.`;
}

function nextCamera(): void {
  cameras.selectedIndex = (cameras.selectedIndex + 1) % cameras.options.length;
  cameras.dispatchEvent(new Event("change"));
}

function buildControls(): void {
  cameras.addEventListener("change", () => {
    scene?.view.choose(cameras.value);
    scene?.ask();
  });
  for (const key of Object.keys(layers) as (keyof Layers)[]) {
    const box = checkbox(LAYER_NAMES[key], layers[key], (on) => {
      layers[key] = on;
      scene?.setLayers(layers);
    });
    element("layers").append(box);
  }
  if (all.length > 1) {
    for (const source of all) {
      const box = checkbox(source.name, chosen.has(source.key), (on) => {
        if (on) chosen.add(source.key);
        else chosen.delete(source.key);
        buildPlots();
      });
      element("shown").append(box);
    }
  }
  element("zoom").addEventListener("click", () => {
    plots.zoom();
  });
  element("whole").addEventListener("click", () => {
    plots.whole();
  });
  const near = element<HTMLInputElement>("near");
  near.addEventListener("change", () => {
    plots.setNear(near.checked);
  });
}

buildControls();
buildScene();
buildLegend();
tellCoarse();
new Readout(data, all, arrays, clock);
new Player(
  clock,
  {
    nodes: data.plans.flatMap((p) => p.tracks.flatMap((t) => [...column(arrays.table(t.nodes.t), 0)])),
    closest: data.plans.flatMap((p) => p.closest_time ?? []),
    phases: data.plans.flatMap((p) => p.separations.slice(1).map((s) => arrays.table(s.t).values[0])),
  },
  {
    nextCamera,
    zoom: () => {
      plots.zoom();
    },
    whole: () => {
      plots.whole();
    },
    nudge: (key) => scene?.view.nudge(key) ?? false,
  },
);
buildPlots();
clock.onTime((t) => scene?.show(t));
new ResizeObserver(() => scene?.resize(canvas.clientWidth, canvas.clientHeight)).observe(canvas);
onThemeChange(() => {
  buildScene(cameras.value);
  buildLegend();
  buildPlots();
});
document.documentElement.dataset.ready = "true";
