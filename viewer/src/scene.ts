// The scene: everything in space at the current time, drawn when something changes.
import {
  AmbientLight,
  Box3,
  Color,
  DirectionalLight,
  HemisphereLight,
  type Mesh,
  Quaternion,
  Raycaster,
  Scene,
  Vector3,
  type WebGLRenderer,
} from "three";
import { StructureActor, VehicleActor, type Layers } from "./actors";
import { bestOverview, type Followed, View } from "./camera";
import { ClosestActor } from "./closest";
import { type Arrays, type PageData } from "./data";
import { fixed } from "./format";
import { ground, sizeLabels } from "./ground";
import { Pace } from "./pace";
import { vehicleName } from "./panels";
import { Shapes } from "./shape";
import type { Theme } from "./theme";

// Structures may reach far beyond the way; the view holds this many times its size of them.
const FRAMED = 1.0;
// Larger structures are not asked what they hide.
const RAYCAST_TRIANGLES = 20_000;

/** A plan of the page with what is drawn of it. */
interface Act {
  label: string;
  vehicles: VehicleActor[];
  closest: ClosestActor;
}

export class SceneView {
  readonly view: View;
  readonly acts: Act[];
  private readonly scene = new Scene();
  private readonly structures: StructureActor[];
  private readonly lamp = new DirectionalLight("#ffffff", 1.6);
  private readonly grid;
  private readonly followed: Followed[];
  private asked = false;
  private disposed = false;
  private readonly canvas: HTMLCanvasElement;
  private layers: Layers;
  private readonly pace = new Pace(() => {
    this.sharpen();
    this.ask();
  });

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly tag: HTMLElement,
    data: PageData,
    arrays: Arrays,
    layers: Layers,
    theme: Theme,
  ) {
    this.canvas = renderer.domElement;
    this.layers = layers;
    const shapes = new Shapes(arrays);
    this.structures = distinct(data).map(
      (s) => new StructureActor(s, arrays, shapes.of(s.body), theme),
    );
    let rank = 0;
    const several = data.plans.length > 1;
    this.acts = data.plans.map((plan) => {
      const colors = new Map<string, string>();
      const vehicles = plan.tracks.map((track) => {
        const color = colors.get(track.vehicle) ?? theme.series[rank++ % theme.series.length];
        colors.set(track.vehicle, color);
        const name = vehicleName(data, plan, track.vehicle);
        return new VehicleActor(name, track, arrays, shapes, color, theme);
      });
      const size = 1.25 * Math.max(...vehicles.map((v) => v.radius), 0.1);
      const color = several ? vehicles[0].color : theme.contact;
      return { label: plan.label, vehicles, closest: new ClosestActor(plan, arrays, color, size) };
    });
    const flat = data.plans.every((p) => p.dim === 2);
    for (const structure of this.structures) {
      structure.show(data.plans[0].span[0]);
      structure.group.updateMatrixWorld(true);
    }
    const overview = bestOverview((towards) => this.hidden(towards));
    const points = this.framed();
    const floor = ground(new Box3().setFromPoints(points), theme, flat, overview);
    this.grid = floor.group;
    this.light();
    this.scene.add(this.grid, ...this.structures.map((s) => s.group));
    for (const act of this.acts) this.scene.add(...act.vehicles.map((v) => v.group), act.closest.group);
    this.scene.background = new Color(theme.scene);
    this.followed = [...new Set(this.vehicles.map((v) => v.name))].map((name) => ({
      name,
      position: new Vector3(),
      rotation: new Quaternion(),
      radius: Math.max(...this.vehicles.filter((v) => v.name === name).map((v) => v.radius)),
    }));
    this.view = new View(this.canvas, [...points, ...floor.corners], flat, this.followed, overview);
    this.view.controls.addEventListener("change", () => {
      this.ask();
    });
    this.setLayers(layers);
  }

  get vehicles(): VehicleActor[] {
    return this.acts.flatMap((act) => act.vehicles);
  }

  show(t: number): void {
    for (const structure of this.structures) structure.show(t);
    for (const act of this.acts) {
      const end = Math.max(...act.vehicles.map((v) => v.last));
      // A plan that is over stays where it ended.
      for (const vehicle of act.vehicles) vehicle.show(Math.min(t, end), end);
      act.closest.show(Math.min(t, end));
    }
    for (const own of this.followed) {
      const actor = this.vehicles.find((v) => v.name === own.name && v.shown);
      if (!actor) continue;
      own.position.copy(actor.position);
      own.rotation.copy(actor.rotation);
    }
    this.view.follow();
    this.ask();
  }

  setLayers(layers: Layers): void {
    this.layers = layers;
    for (const actor of [...this.vehicles, ...this.structures]) actor.setLayers(layers);
    for (const act of this.acts) act.closest.setShown(layers.plane);
    this.grid.visible = layers.grid;
    this.ask();
  }

  resize(width: number, height: number): void {
    if (!width || !height) return;
    this.sharpen();
    this.renderer.setSize(width, height, false);
    this.view.resize(width, height);
    this.ask();
  }

  /** Draws before the next frame, once, however often it is asked. */
  ask(): void {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      if (!this.disposed) this.draw();
    });
  }

  /** Frees what this scene holds; the renderer serves the next one. */
  dispose(): void {
    this.view.controls.dispose();
    this.pace.stop();
    this.disposed = true;
    this.scene.traverse((object) => {
      const { geometry, material } = object as Partial<Mesh>;
      geometry?.dispose();
      for (const one of [material ?? []].flat()) one.dispose();
    });
  }

  private sharpen(): void {
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2) * this.pace.scale);
  }

  private draw(): void {
    if (this.pace.picture(performance.now())) this.sharpen();
    this.lamp.position.copy(this.view.camera.position);
    this.lamp.target.position.copy(this.view.controls.target);
    this.lamp.target.updateMatrixWorld();
    sizeLabels(this.grid, this.view.perPixel(this.canvas.clientHeight));
    this.renderer.render(this.scene, this.view.camera);
    this.placeTag();
  }

  /** The distance of the closest points, written beside them. */
  private placeTag(): void {
    const nearest = this.acts.length === 1 ? this.acts[0].closest.nearest : null;
    const at = nearest?.middle.clone().project(this.view.camera);
    const seen = at && Math.abs(at.x) < 1 && Math.abs(at.y) < 1 && at.z < 1;
    this.tag.hidden = !(seen && this.layers.plane);
    if (!seen || !nearest) return;
    this.tag.textContent = `${fixed(nearest.distance, 3)} m`;
    const x = ((at.x + 1) / 2) * this.canvas.clientWidth;
    const y = ((1 - at.y) / 2) * this.canvas.clientHeight;
    this.tag.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
  }

  private light(): void {
    const sky = new HemisphereLight("#ffffff", "#8893a0", 1.3);
    sky.position.set(0, 0, 1);
    this.scene.add(sky, new AmbientLight("#ffffff", 0.5), this.lamp, this.lamp.target);
  }

  /** How many places of the way a structure hides from a viewer in this direction. */
  private hidden(towards: Vector3): number {
    const triangles = this.structures.reduce((sum, s) => sum + (s.faces.geometry.index?.count ?? 0) / 3, 0);
    if (triangles > RAYCAST_TRIANGLES) return 0;
    const caster = new Raycaster();
    const seen = this.vehicles.flatMap((v) => v.places()).filter((place) => {
      caster.set(place, towards);
      return caster.intersectObjects(this.structures.map((s) => s.faces)).length === 0;
    });
    return -seen.length;
  }

  /** Corners of everything on the way, and of what of the structures is near it. */
  private framed(): Vector3[] {
    const points = this.vehicles.flatMap((v) => v.corners());
    const box = new Box3().setFromPoints(points);
    const near = box.clone().expandByScalar(box.getSize(new Vector3()).length() * FRAMED);
    const corners = this.structures.flatMap((s) => s.corners());
    return [...points, ...corners.map((corner) => near.clampPoint(corner, corner))];
  }
}

/** Structures of all plans, the same one once. */
function distinct(data: PageData): PageData["plans"][number]["structures"] {
  const found = new Map<string, PageData["plans"][number]["structures"][number]>();
  for (const plan of data.plans) {
    for (const s of plan.structures) found.set(JSON.stringify({ ...s, ghosts: null }), s);
  }
  return [...found.values()];
}
