// A grid under the scene with numbers along its edges, so that sizes can be read.
import {
  type Box3,
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  Group,
  LineBasicMaterial,
  LineSegments,
  SRGBColorSpace,
  Sprite,
  SpriteMaterial,
  Vector3,
} from "three";
import { short } from "./format";
import type { Theme } from "./theme";

const TICKS = 9;
const NUMBER_PX = 13;

interface Floor {
  x: [number, number];
  y: [number, number];
  z: number;
  top: number;
  step: number;
}

/** Lines of a round step that span the box, numbers in metres; and corners that hold all of it. */
export function ground(box: Box3, theme: Theme, flat: boolean, towards: Vector3): { group: Group; corners: Vector3[] } {
  const size = box.getSize(new Vector3());
  const step = roundStep(Math.max(size.x, size.y) / TICKS);
  const low = (v: number): number => Math.floor(v / step) * step;
  const high = (v: number): number => Math.ceil(v / step) * step;
  const floor: Floor = {
    x: [low(box.min.x), high(box.max.x)],
    y: [low(box.min.y), high(box.max.y)],
    z: flat ? box.min.z - 0.02 * size.length() : low(box.min.z),
    top: high(box.max.z),
    step,
  };
  const group = new Group();
  // Numbers stand at the edges that are nearer to the viewer of the overview.
  const near = { x: !flat && towards.x > 0 ? 1 : 0, y: !flat && towards.y > 0 ? 1 : 0 };
  const points = [...along(group, floor, near, "x", theme), ...along(group, floor, near, "y", theme)];
  if (!flat) points.push(...upright(group, floor, near, theme));
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  group.add(new LineSegments(geometry, new LineBasicMaterial({ color: theme.line })));
  return { group, corners: group.children.map((child) => child.position).filter((p) => p.lengthSq() > 0) };
}

/** The lines across one axis with its numbers and its name. */
function along(group: Group, floor: Floor, near: { x: number; y: number }, axis: "x" | "y", theme: Theme): number[] {
  const other = axis === "x" ? "y" : "x";
  const point = (own: number, cross: number): number[] =>
    axis === "x" ? [own, cross, floor.z] : [cross, own, floor.z];
  const outward = (near[other] ? 1 : -1) * 0.55 * floor.step;
  const edge = floor[other][near[other]];
  const points: number[] = [];
  for (const value of ticks(...floor[axis], floor.step)) {
    points.push(...point(value, floor[other][0]), ...point(value, floor[other][1]));
    group.add(label(short(value), point(value, edge + outward), theme));
  }
  const middle = (floor[axis][0] + floor[axis][1]) / 2;
  group.add(label(`${axis} [m]`, point(middle + floor.step / 2, edge + 2.2 * outward), theme));
  return points;
}

/** Heights, at the left of the two corners that are neither nearest nor farthest. */
function upright(group: Group, floor: Floor, near: { x: number; y: number }, theme: Theme): number[] {
  const { x, y, z, top, step } = floor;
  // Seen from a corner, the left one has its neighbour clockwise from above.
  const turn = near.x === near.y;
  const corner = turn ? [x[near.x], y[1 - near.y]] : [x[1 - near.x], y[near.y]];
  const side = turn ? [0, near.y ? -1 : 1] : [near.x ? -1 : 1, 0];
  const out = (reach: number): number[] => [corner[0] + reach * step * side[0], corner[1] + reach * step * side[1]];
  const points = [...corner, z, ...corner, top];
  for (const value of ticks(z, top, step).slice(1)) {
    points.push(...corner, value, ...out(0.15), value);
    group.add(label(short(value), [...out(0.5), value], theme));
  }
  group.add(label("z [m]", [...corner, top + 0.5 * step], theme));
  return points;
}

function ticks(from: number, to: number, step: number): number[] {
  const count = Math.round((to - from) / step);
  return Array.from({ length: count + 1 }, (_, i) => Number((from + i * step).toPrecision(9)));
}

/** 1, 2 or 5 times a power of ten, at least as large. */
function roundStep(wanted: number): number {
  const power = 10 ** Math.floor(Math.log10(wanted || 1));
  return ([1, 2, 5].find((k) => k * power >= wanted) ?? 10) * power;
}

function label(text: string, at: number[], theme: Theme): Sprite {
  const scale = 4;
  const canvas = document.createElement("canvas");
  const font = `${NUMBER_PX * scale}px system-ui, sans-serif`;
  const context = canvas.getContext("2d");
  if (context) {
    context.font = font;
    canvas.width = Math.ceil(context.measureText(text).width) + 2 * scale;
    canvas.height = NUMBER_PX * scale * 1.3;
    context.font = font;
    context.fillStyle = theme.muted;
    context.textBaseline = "middle";
    context.fillText(text, scale, canvas.height / 2);
  }
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const material = new SpriteMaterial({
    map,
    sizeAttenuation: false,
    depthWrite: false,
    transparent: true,
  });
  const sprite = new Sprite(material);
  sprite.position.fromArray(at);
  sprite.userData.pixels = [canvas.width / scale, canvas.height / scale];
  return sprite;
}

/** Gives every number the same height in pixels, whatever the camera's view (metres per pixel). */
export function sizeLabels(group: Group, perPixel: number): void {
  for (const child of group.children) {
    const pixels = child.userData.pixels as [number, number] | undefined;
    if (pixels) child.scale.set(pixels[0] * perPixel, pixels[1] * perPixel, 1);
  }
}
