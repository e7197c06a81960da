// Lines of a width in pixels, which plain WebGL lines are not.
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";

export function thickLine(points: Float32Array | number[], color: string, width: number, opacity = 1): Line2 {
  const geometry = new LineGeometry();
  geometry.setPositions(points);
  const material = new LineMaterial({ color, linewidth: width, opacity, transparent: opacity < 1 });
  return new Line2(geometry, material);
}

export function moveLine(line: Line2, points: number[]): void {
  line.geometry.setPositions(points);
}
