/** The world in 3D, as one plays in it, below the marks of the editor. */

import { Vector3 } from "three";

import { type ThemeName, theme } from "../../model/preferences";
import type { Running } from "../../model/running";
import type { GoalNow } from "../../protocol/messages";
import { Cameras } from "../../views/world/cameras";
import type { Ref } from "../../views/world/plan/sorts";
import { svg } from "../../views/world/plan/svg";
import { Pointing } from "../../views/world/pointing";
import type { WorldValues, XY } from "../../views/world/scenery/description";
import { cornersOf } from "../../views/world/scenery/geometry";
import { paletteOf } from "../../views/world/scenery/palette";
import { Pictures } from "../../views/world/scenery/pictures";
import { Stage } from "../../views/world/stage";
import { View } from "../../views/world/view";
import { type Body, bodiesOf, chainOf } from "./bodies";
import { hull } from "./hull";
import type { Lens, Pointed } from "./lens";

/** Where a place behind the camera is, in pixels: far from the picture. */
const AWAY: XY = [-1e5, -1e5];

const OPEN: GoalNow = { name: "", sort: "", state: "open", time: null };

export class RoomLens implements Lens {
  readonly picture = document.createElement("div");
  readonly scale = 1;
  private readonly canvas = document.createElement("canvas");
  private readonly cameras = new Cameras(this.canvas, () => this.view?.invalidate());
  private readonly view = new View(this.canvas, this.cameras.camera, (now) => this.draw(now));
  private readonly pointing = new Pointing(this.canvas, this.cameras.camera);
  private readonly pictures = new Pictures(() => this.view.invalidate());
  private stage: Stage | null = null;
  /** The stage before, until the next frame: it keeps the shaders that both use. */
  private outdated: Stage | null = null;
  private world: WorldValues | null = null;
  private page: ThemeName | null = null;
  private isStale = false;
  /** The view of the frame before, to see whether the marks have to follow. */
  private seen = "";
  private place: XY = [0, 0];

  /**
   * @param changed is called when the marks have to be drawn again.
   * @throws Error if the browser cannot draw in 3D.
   */
  constructor(
    private readonly running: Running,
    private readonly changed: () => void,
  ) {
    this.picture.className = "room";
    this.picture.append(this.canvas);
    this.canvas.setAttribute("aria-hidden", "true");
    this.cameras.choose("orbit");
  }

  get centre(): XY {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    return this.at({ clientX: left + width / 2, clientY: top + height / 2 });
  }

  show(world: WorldValues): void {
    if (world === this.world && theme.value === this.page) return;
    this.world = world;
    this.page = theme.value;
    this.isStale = true;
    this.view.invalidate();
  }

  ground(): SVGElement[] {
    return [];
  }

  shapes(world: WorldValues, ref: Ref): SVGElement[] {
    const chain = chainOf(world, ref).map((place) => this.point(place));
    if (chain.length > 0) {
      const points = chain.map((place) => place.join(",")).join(" ");
      return [svg("polyline", { points, class: "chain" })];
    }
    const bodies = bodiesOf(world, ref);
    return [
      ...bodies.map((body) => svg("path", { d: closed(hull(this.corners(body))), class: "body" })),
      ...bodies.map(({ outline }) =>
        svg("path", { d: closed(outline.map((place) => this.point(place))), class: "foot" }),
      ),
    ];
  }

  point([x, y]: XY, height = 0): XY {
    const { camera } = this.cameras;
    const place = new Vector3(x, y, height);
    if (place.clone().applyMatrix4(camera.matrixWorldInverse).z > -camera.near) return AWAY;
    const { x: right, y: up } = place.project(camera);
    return [((right + 1) / 2) * this.canvas.clientWidth, ((1 - up) / 2) * this.canvas.clientHeight];
  }

  at(pointed: Pointed): XY {
    // There is no floor above the horizon: the last place stays.
    this.place = this.pointing.floor(pointed) ?? this.place;
    return this.place;
  }

  fit(size: XY): void {
    this.cameras.floor(size);
    this.cameras.reset();
    this.follow();
  }

  zoom(factor: number): void {
    this.cameras.zoom(factor);
  }

  pan(right: number, down: number): void {
    this.cameras.turn(-right / 3, down / 3);
  }

  resized(): void {
    const { clientWidth, clientHeight } = this.picture;
    if (clientWidth === 0) return;
    this.cameras.size(clientWidth, clientHeight);
    this.view.resize(clientWidth, clientHeight);
  }

  destroy(): void {
    this.cameras.dispose();
    this.outdated?.dispose();
    this.stage?.dispose();
    this.pictures.dispose();
    this.view.dispose();
    this.picture.remove();
  }

  private corners({ outline, bottom, top }: Body): XY[] {
    return outline.flatMap((place) => [this.point(place, bottom), this.point(place, top)]);
  }

  /** Return whether the camera is still moving. */
  private draw(now: number): boolean {
    this.outdated?.dispose();
    this.outdated = null;
    if (this.isStale) this.build();
    const moves = this.cameras.step(now);
    this.stage?.face(this.cameras.camera.position);
    this.follow();
    return moves;
  }

  /** Let the marks follow the camera. */
  private follow(): void {
    const { camera } = this.cameras;
    camera.updateMatrixWorld();
    const seen = [...camera.matrixWorld.elements, ...camera.projectionMatrix.elements].join();
    if (seen === this.seen) return;
    this.seen = seen;
    this.changed();
  }

  private build(): void {
    const { world } = this;
    this.isStale = false;
    if (!world) return;
    this.outdated = this.stage;
    this.outdated?.object.removeFromParent();
    const palette = paletteOf(world.theme, theme.peek());
    const scene = this.running.scene.peek();
    const [first] = world.start;
    const start: [number, number, number] = first ? [first.x, first.y, first.heading] : [0, 0, 0];
    const robots = (scene?.robots ?? []).slice(0, Math.max(1, world.start.length));
    const lines = world.line.map(cornersOf);
    this.stage = new Stage(
      { kind: "Scene", name: scene?.name ?? "", world, lines, robots, start },
      palette,
      () => this.view.invalidate(),
      () => null,
      this.pictures,
    );
    this.stage.showGoals(
      Object.values(world.goal)
        .flat()
        .map(() => OPEN),
    );
    this.view.scene.add(this.stage.object);
    this.view.surround(world.floor.size, palette, this.stage.fog);
    this.view.moveShadows();
    this.cameras.floor(world.floor.size);
  }
}

function closed(points: readonly XY[]): string {
  return points.length > 0 ? `M${points.map((place) => place.join(" ")).join("L")}Z` : "";
}
