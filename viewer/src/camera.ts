// Where the scene is seen from: fixed views, and views that follow a vehicle.
import { Box3, OrthographicCamera, PerspectiveCamera, Quaternion, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

const FIELD_DEG = 35;
// The box fills the view up to this.
const FILL = 0.94;
// Following, this many radii of the vehicle are in sight.
const FOLLOWED_RADII = 3.4;
const TURN_RAD = Math.PI / 36;
const ZOOM = 1.1;

/** Towards the viewer; azimuth from x about z, elevation from the xy plane. */
function direction(azimuthDeg: number, elevationDeg: number): Vector3 {
  const [a, e] = [azimuthDeg, elevationDeg].map((d) => (d * Math.PI) / 180);
  return new Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
}

// Overviews, the first that hides least of the way is taken.
const OVERVIEWS = [24, 50].flatMap((elevation) =>
  [-62, -118, 62, 118].map((azimuth) => direction(azimuth, elevation)),
);
// Straight down has no upright; a hair beside it keeps y up.
const FIXED: Record<string, Vector3> = {
  top: direction(-90, 89.99),
  front: direction(-90, 0),
  side: direction(0, 0),
};

/** Where to look from to see most of the way. */
export function bestOverview(hidden: (towards: Vector3) => number): Vector3 {
  const scores = OVERVIEWS.map(hidden);
  return OVERVIEWS[scores.indexOf(Math.min(...scores))];
}

export interface Followed {
  name: string;
  position: Vector3;
  rotation: Quaternion;
  radius: number;
}

export class View {
  readonly camera: PerspectiveCamera | OrthographicCamera;
  readonly controls: OrbitControls;
  readonly options: { value: string; text: string }[];
  value = "";
  private followed: Followed | undefined;
  private riding = false;
  private readonly lastPosition = new Vector3();
  private readonly lastRotation = new Quaternion();
  private aspect = 1;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly points: Vector3[],
    readonly flat: boolean,
    private readonly vehicles: Followed[],
    private readonly overview: Vector3,
  ) {
    this.camera = flat ? new OrthographicCamera() : new PerspectiveCamera(FIELD_DEG);
    this.camera.up.set(0, flat ? 1 : 0, flat ? 0 : 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableRotate = !flat;
    this.controls.zoomToCursor = true;
    const fixed = flat ? ["overview"] : ["overview", ...Object.keys(FIXED)];
    this.options = [
      ...fixed.map((value) => ({ value, text: value[0].toUpperCase() + value.slice(1) })),
      ...vehicles.map((v, i) => ({ value: `follow ${i}`, text: `Follow ${v.name}` })),
      ...(flat ? [] : vehicles.map((v, i) => ({ value: `ride ${i}`, text: `Ride with ${v.name}` }))),
    ];
  }

  choose(value: string): void {
    this.value = value;
    const [kind, index] = value.split(" ");
    this.followed = index === undefined ? undefined : this.vehicles[Number(index)];
    this.riding = kind === "ride";
    const target = new Vector3();
    if (this.followed) {
      target.copy(this.followed.position);
      this.lastPosition.copy(target);
      this.lastRotation.copy(this.followed.rotation);
      const reach = this.followed.radius * FOLLOWED_RADII;
      this.look(this.overview, target, cube(target, reach / 2));
    } else {
      new Box3().setFromPoints(this.points).getCenter(target);
      this.look(value in FIXED ? FIXED[value] : this.overview, target, this.points);
    }
  }

  /** Goes along with the vehicle that is followed. */
  follow(): void {
    if (!this.followed) return;
    const { position, rotation } = this.followed;
    const arm = this.camera.position.clone().sub(this.lastPosition);
    const aim = this.controls.target.clone().sub(this.lastPosition);
    if (this.riding) {
      const turn = rotation.clone().multiply(this.lastRotation.clone().invert());
      arm.applyQuaternion(turn);
      aim.applyQuaternion(turn);
      this.camera.up.applyQuaternion(turn);
    }
    this.camera.position.copy(position).add(arm);
    this.controls.target.copy(position).add(aim);
    this.lastPosition.copy(position);
    this.lastRotation.copy(rotation);
    this.camera.lookAt(this.controls.target);
  }

  resize(width: number, height: number): void {
    const before = this.aspect;
    this.aspect = width / height;
    if (this.camera instanceof PerspectiveCamera) this.camera.aspect = this.aspect;
    else this.camera.left = (this.camera.right = this.camera.top * this.aspect) * -1;
    this.camera.updateProjectionMatrix();
    if (Math.abs(before - this.aspect) > 0.01 && this.value) this.choose(this.value);
  }

  /** Keys in the scene: turn (or move, in the plane) and zoom. */
  nudge(key: string): boolean {
    const turns: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    };
    if (key in turns) {
      if (this.flat) this.pan(...turns[key]);
      else this.orbit(...turns[key]);
    } else if (key === "+" || key === "=") this.zoom(ZOOM);
    else if (key === "-") this.zoom(1 / ZOOM);
    else return false;
    this.controls.update();
    return true;
  }

  /** Metres on a pixel of a view of this height: at a distance of 1, or everywhere in the plane. */
  perPixel(height: number): number {
    if (this.camera instanceof PerspectiveCamera) {
      return (2 * Math.tan((FIELD_DEG * Math.PI) / 360)) / height;
    }
    return (this.camera.top - this.camera.bottom) / this.camera.zoom / height;
  }

  private look(from: Vector3, target: Vector3, points: Vector3[]): void {
    this.camera.up.set(0, this.flat ? 1 : 0, this.flat ? 0 : 1);
    this.controls.target.copy(target);
    const towards = this.flat ? new Vector3(0, 0, 1) : from;
    const right = new Vector3().crossVectors(this.camera.up, towards).normalize();
    const up = new Vector3().crossVectors(towards, right);
    const offsets = points.map((p) => p.clone().sub(target));
    const radius = Math.max(...offsets.map((p) => p.length()), 1e-3);
    if (this.camera instanceof PerspectiveCamera) {
      const slope = Math.tan((FIELD_DEG * Math.PI) / 360) * FILL;
      const [x, across] = fit(offsets, right, towards, slope * this.aspect);
      const [y, along] = fit(offsets, up, towards, slope);
      const distance = Math.max(across, along);
      target.addScaledVector(right, x).addScaledVector(up, y);
      this.controls.target.copy(target);
      this.camera.near = Math.max(distance / 1000, 1e-3);
      this.camera.far = 100 * (distance + radius);
      this.camera.position.copy(target).addScaledVector(towards, distance);
    } else {
      const half = Math.max(
        ...offsets.map((p) => Math.max(Math.abs(p.dot(up)), Math.abs(p.dot(right)) / this.aspect)),
      );
      this.camera.top = half / FILL;
      this.camera.bottom = -this.camera.top;
      this.camera.right = this.camera.top * this.aspect;
      this.camera.left = -this.camera.right;
      this.camera.zoom = 1;
      this.camera.near = 0;
      this.camera.far = 200 * radius;
      this.camera.position.copy(target).addScaledVector(towards, 100 * radius);
    }
    this.camera.lookAt(target);
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  private orbit(x: number, y: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const side = new Vector3().crossVectors(this.camera.up, offset).normalize();
    const turned = offset
      .clone()
      .applyAxisAngle(this.camera.up, x * TURN_RAD)
      .applyAxisAngle(side, -y * TURN_RAD);
    if (turned.clone().normalize().cross(this.camera.up).length() < 0.02) return;
    this.camera.position.copy(this.controls.target).add(turned);
  }

  private pan(x: number, y: number): void {
    const step = new Vector3(x, y, 0).multiplyScalar(30 * this.perPixel(600));
    this.camera.position.add(step);
    this.controls.target.add(step);
  }

  private zoom(by: number): void {
    if (this.camera instanceof OrthographicCamera) {
      this.camera.zoom *= by;
      this.camera.updateProjectionMatrix();
    } else {
      const offset = this.camera.position.clone().sub(this.controls.target);
      this.camera.position.copy(this.controls.target).addScaledVector(offset, 1 / by);
    }
  }
}

/**
 * How far to shift along an axis, and how far to stand back, to see all points between two planes
 * of this slope. A point with a along the axis and z towards the viewer lies between them for a
 * shift s and a distance d where ±(a − s) ≤ slope (d − z); both bounds are met at once by
 * R = max(a + slope z), L = max(slope z − a), s = (R − L)/2, d = (R + L)/(2 slope).
 */
function fit(points: Vector3[], axis: Vector3, towards: Vector3, slope: number): [number, number] {
  const most = (sign: number): number =>
    Math.max(...points.map((p) => sign * p.dot(axis) + slope * p.dot(towards)));
  const [r, l] = [most(1), most(-1)];
  return [(r - l) / 2, (r + l) / (2 * slope)];
}

function cube(centre: Vector3, half: number): Vector3[] {
  return [-half, half].flatMap((x) =>
    [-half, half].flatMap((y) => [-half, half].map((z) => new Vector3(x, y, z).add(centre))),
  );
}
