// Things that are drawn in the scene: vehicles with their trails, and structures.
import {
  type Box3,
  DoubleSide,
  FrontSide,
  Group,
  InstancedMesh,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  Quaternion,
  Vector3,
} from "three";
import type { Line2 } from "three/examples/jsm/lines/Line2.js";
import { type Arrays, type StructureData, type Table, type TrackData } from "./data";
import { dots } from "./dots";
import { thickLine } from "./lines";
import { Locator, quaternionAt, vectorAt } from "./samples";
import type { Shape, Shapes } from "./shape";
import type { Theme } from "./theme";

const GHOST_OPACITY = 0.1;
const GHOST_EDGE_OPACITY = 0.35;
// Ghosts of larger bodies have no faces: seven of them would be too much to draw smoothly.
const GHOST_TRIANGLES = 20_000;
const TRAIL_PX = 2.5;
const NODE_PX = 4.5;
const ONE = new Vector3(1, 1, 1);

/** Which kinds of things are shown. */
export interface Layers {
  ghosts: boolean;
  trails: boolean;
  nodes: boolean;
  plane: boolean;
  grid: boolean;
}

/** A body with faces and edges. */
function drawnBody(shape: Shape, color: string, edge: string): Group {
  const group = new Group();
  // Edges of a body lie in its faces: push the faces back a little.
  const faces = new MeshLambertMaterial({
    color,
    side: shape.closed ? FrontSide : DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  group.add(new Mesh(shape.faces, faces));
  group.add(new LineSegments(shape.edges, new LineBasicMaterial({ color: edge })));
  return group;
}

/** The body at several poses at once, see-through. */
function drawnGhosts(shape: Shape, poses: Matrix4[], color: string): Group {
  const group = new Group();
  if (shape.triangles <= GHOST_TRIANGLES) {
    const material = new MeshLambertMaterial({
      color,
      side: DoubleSide,
      transparent: true,
      opacity: GHOST_OPACITY,
      depthWrite: false,
    });
    const faces = new InstancedMesh(shape.faces, material, poses.length);
    poses.forEach((pose, i) => faces.setMatrixAt(i, pose));
    faces.frustumCulled = false;
    group.add(faces);
  }
  const material = new LineBasicMaterial({ color, transparent: true, opacity: GHOST_EDGE_OPACITY });
  for (const pose of poses) {
    const edges = new LineSegments(shape.edges, material);
    edges.matrixAutoUpdate = false;
    edges.matrix.copy(pose);
    group.add(edges);
  }
  return group;
}

/** Poses over time, and the things that follow them. */
class Moving {
  readonly position = new Vector3();
  readonly rotation = new Quaternion();
  protected readonly at: Locator;

  constructor(
    times: Table,
    private readonly positions: Table,
    private readonly rotations: Table,
  ) {
    this.at = new Locator(times);
  }

  protected sample(t: number): void {
    this.at.to(t);
    vectorAt(this.positions, this.at, this.position);
    quaternionAt(this.rotations, this.at, this.rotation);
  }

  protected poses(times: number[]): Matrix4[] {
    return times.map((t) => {
      this.sample(t);
      return new Matrix4().compose(this.position, this.rotation, ONE);
    });
  }
}

/** A vehicle in one phase. */
export class VehicleActor extends Moving {
  readonly group = new Group();
  readonly radius: number;
  private readonly body: Group;
  private readonly ghosts: Group;
  private readonly trail: Group;
  private readonly nodes: Group;
  private readonly done: Line2;
  private readonly trailTimes: Float64Array;
  private readonly shape: Shape;

  constructor(
    readonly name: string,
    readonly data: TrackData,
    arrays: Arrays,
    shapes: Shapes,
    readonly color: string,
    theme: Theme,
  ) {
    super(arrays.table(data.dense.t), arrays.table(data.dense.p), arrays.table(data.dense.q));
    const shape = (this.shape = shapes.of(data.body));
    shape.faces.computeBoundingSphere();
    const sphere = shape.faces.boundingSphere;
    this.radius = sphere ? sphere.center.length() + sphere.radius : 0;
    this.body = drawnBody(shape, color, theme.edge);
    this.ghosts = drawnGhosts(shape, this.poses(data.ghosts), color);
    const points = arrays.table(data.dense.p).values as Float32Array;
    this.trailTimes = arrays.table(data.dense.t).values as Float64Array;
    this.done = thickLine(points, color, TRAIL_PX);
    this.trail = new Group().add(thickLine(points, color, TRAIL_PX, 0.35), this.done);
    const nodes = arrays.table(data.nodes.p).values as Float32Array;
    this.nodes = new Group();
    if (nodes.length) this.nodes.add(dots(nodes, color, NODE_PX));
    this.group.add(this.body, this.ghosts, this.trail, this.nodes);
  }

  get first(): number {
    return this.at.first;
  }

  get last(): number {
    return this.at.last;
  }

  /** Whether its phase is on; where two meet, the later one is. */
  get shown(): boolean {
    return this.body.visible;
  }

  show(t: number, end: number): void {
    this.sample(t);
    this.body.visible = t >= this.first && (t < this.last || (t === this.last && t >= end));
    this.body.position.copy(this.position);
    this.body.quaternion.copy(this.rotation);
    let passed = 0;
    while (passed < this.trailTimes.length - 1 && this.trailTimes[passed + 1] <= t) passed++;
    this.done.geometry.instanceCount = passed;
    this.done.visible = passed > 0;
  }

  setLayers(layers: Layers): void {
    this.ghosts.visible = layers.ghosts;
    this.trail.visible = layers.trails;
    this.nodes.visible = layers.nodes;
  }

  /** Corners of its box at the ghosts' times, for framing. */
  corners(): Vector3[] {
    return boxCorners(this.shape, this.poses(this.data.ghosts));
  }

  /** Where it is at the ghosts' times. */
  places(): Vector3[] {
    return this.poses(this.data.ghosts).map((pose) => new Vector3().setFromMatrixPosition(pose));
  }
}

/** A structure, at rest or moving. */
export class StructureActor extends Moving {
  readonly group = new Group();
  private readonly body: Group;
  private readonly ghosts: Group;

  constructor(
    readonly data: StructureData,
    arrays: Arrays,
    private readonly shape: Shape,
    theme: Theme,
  ) {
    super(arrays.table(data.t), arrays.table(data.p), arrays.table(data.q));
    this.body = drawnBody(shape, theme.structure, theme.edge);
    this.ghosts = drawnGhosts(shape, this.poses(data.ghosts), theme.muted);
    this.group.add(this.body, this.ghosts);
  }

  show(t: number): void {
    this.sample(t);
    this.body.position.copy(this.position);
    this.body.quaternion.copy(this.rotation);
  }

  setLayers(layers: Layers): void {
    this.ghosts.visible = layers.ghosts;
  }

  /** Corners of its box at the first and the last time, for framing. */
  corners(): Vector3[] {
    return boxCorners(this.shape, this.poses([this.at.first, this.at.last]));
  }

  /** Its faces, placed as at the last time shown. */
  get faces(): Mesh {
    return this.body.children[0] as Mesh;
  }
}

function boxCorners(shape: Shape, poses: Matrix4[]): Vector3[] {
  shape.faces.computeBoundingBox();
  const box = shape.faces.boundingBox;
  if (!box) return [];
  return poses.flatMap((pose) => cornersOf(box).map((corner) => corner.applyMatrix4(pose)));
}

export function cornersOf({ min, max }: Box3): Vector3[] {
  const ends = [min, max];
  return [0, 1, 2, 3, 4, 5, 6, 7].map(
    (k) => new Vector3(ends[k & 1].x, ends[(k >> 1) & 1].y, ends[(k >> 2) & 1].z),
  );
}
