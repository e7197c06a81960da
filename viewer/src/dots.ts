// Round dots of a size in pixels.
import { BufferAttribute, BufferGeometry, CanvasTexture, Points, PointsMaterial } from "three";

let disc: CanvasTexture | undefined;

export function dots(positions: Float32Array, color: string, size: number): Points<BufferGeometry, PointsMaterial> {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  disc ??= drawnDisc();
  const material = new PointsMaterial({
    color,
    size,
    sizeAttenuation: false,
    map: disc,
    alphaTest: 0.5,
  });
  return new Points(geometry, material);
}

function drawnDisc(): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const context = canvas.getContext("2d");
  if (context) {
    context.fillStyle = "#fff";
    context.beginPath();
    context.arc(32, 32, 30, 0, 2 * Math.PI);
    context.fill();
  }
  return new CanvasTexture(canvas);
}
