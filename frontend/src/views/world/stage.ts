/** The drawing of one scene, updated by telemetry. */

import { type BufferGeometry, type Fog, Group, type Material, Mesh, type Object3D, Points, Sprite } from "three";
import type { GoalNow, Robot, Scene } from "../../protocol/messages";
import { type Beams, beams } from "./beams";
import type { Subject } from "./framing";
import { screensOf } from "./hiding";
import { farthestLine, type GoalMark, goalMarks, goalPlaces, Signs, startMark } from "./marks";
import type { Moment } from "./motion";
import { nameplate } from "./nameplate";
import { origin } from "./origin";
import { type RobotModel, robotModel } from "./robots";
import type { RobotValues, WorldValues, XY } from "./scenery/description";
import { floor, LINE_PAINT } from "./scenery/floor";
import { colourOf, legible } from "./scenery/floor-colours";
import { GameThings, mover } from "./scenery/games";
import type { Pose } from "./scenery/geometry";
import { depthBelow } from "./scenery/mat";
import type { Palette } from "./scenery/palette";
import { Pictures } from "./scenery/pictures";
import { namedProps, props } from "./scenery/props";
import { SHADE } from "./scenery/shadows";
import { COAT, PAINT } from "./scenery/solids";
import { SHINE } from "./scenery/star";
import { surroundings } from "./scenery/surroundings";
import { glow, place, things } from "./scenery/things";

/** Materials that all scenes share. */
const SHARED: ReadonlySet<Material> = new Set([PAINT, COAT, SHINE, SHADE, LINE_PAINT]);

/** Of the twin of a real robot. */
const FADED = { transparent: true, opacity: 0.35, depthWrite: false };

export class Stage {
  readonly object = new Group();
  readonly world: WorldValues;
  readonly robots: readonly RobotModel[];
  readonly beams: Beams | null;
  readonly fog: Fog;
  readonly floorColour: string;
  private readonly described: RobotValues | null;
  private readonly pushed: readonly Object3D[];
  private readonly games: GameThings;
  private readonly goals: readonly GoalMark[];
  private readonly signs = new Signs();
  /** Its own pictures; null if they are shared. */
  private readonly pictures: Pictures | null;
  private start: Object3D | null = null;
  /** Where a value is measured that the user points at. */
  private origin: Object3D | null = null;
  /** Where the twin of a real robot would have been. */
  private ghost: RobotModel | null = null;

  /**
   * @param changed is called when a picture has loaded.
   * @param color is the colour of a robot's name; null if robots are shown without names.
   * @param shared pictures that outlive the drawing.
   */
  constructor(
    scene: Scene,
    palette: Palette,
    changed: () => void,
    color: (name: string) => string | null = () => null,
    shared: Pictures | null = null,
  ) {
    this.world = scene.world;
    const pictures = shared ?? new Pictures(changed);
    this.pictures = shared ? null : pictures;
    const { fixed, pushed } = things(this.world, palette, pictures);
    const movers = this.world.mover.map(mover);
    this.pushed = [...pushed, ...movers];
    this.games = new GameThings(this.world);
    this.goals = goalMarks(this.world, scene.lines, this.signs);
    const descriptions = scene.robots.map(([, description]) => description);
    this.robots = descriptions.map(robotModel);
    this.described = descriptions[0] ?? null;
    scene.robots.forEach(([name], i) => {
      const shown = color(name);
      if (shown) this.robots[i]?.label(nameplate(name, shown));
    });
    this.beams = descriptions[0] ? beams(descriptions[0]) : null;
    const marks = [...this.world.light.map(glow), ...this.otherStarts(scene).map(startMark)];
    const models = [...this.goals, ...this.robots].map(({ object }) => object);
    const depth = depthBelow(this.world.floor);
    const around = surroundings(this.world.floor.size, depth, palette);
    this.fog = around.fog;
    this.floorColour = colourOf(this.world.floor, legible(palette, this.world.line));
    if (!scene.real) this.object.add(props(this.world.theme ?? "playground", this.world.floor.size, depth));
    this.object.add(around.object, floor(scene.name, this.world, scene.lines, palette, pictures), fixed);
    if (this.world.prop.length > 0) this.object.add(namedProps(this.world, depth));
    for (const part of [...this.pushed, ...marks, ...models, this.games.object]) this.object.add(part);
    this.showStarts(scene);
    if (this.robots[0] && this.beams) this.robots[0].object.add(this.beams.object);
    this.startAt(scene.start);
  }

  /** Close or open the eyes of all robots. */
  blink(closed: boolean): void {
    for (const robot of this.robots) robot.blink(closed);
  }

  /** Set where the next run starts. */
  startAt(start: Scene["start"]): void {
    if (this.start) dispose(this.start);
    this.start = null;
    if (!start) return;
    const [x, y, heading] = start;
    this.start = startMark({ x, y, heading });
    this.object.add(this.start);
  }

  /** What the picture shows first: of a robot alone, nothing else; with null, ours and its goals. */
  subjectOf(alone: number | null): Subject {
    const robot = alone === null ? undefined : this.robots[alone];
    if (!robot || alone === 0) return this.subject;
    const { x, y, heading } = robot.pose;
    return { x, y, heading, reach: robot.reach, height: robot.height, goal: null, screens: screensOf(this.world) };
  }

  /** What the picture shows first. */
  get subject(): Subject {
    const robot = this.robots[0];
    const { x, y, heading } = robot?.pose ?? { x: 0, y: 0, heading: 0 };
    const size = { reach: robot?.reach ?? 100, height: robot?.height ?? 100 };
    const [goal = farthestLine(this.world, x, y), ...others] = goalPlaces(this.world);
    return { x, y, heading, ...size, goal, others, screens: screensOf(this.world) };
  }

  /** Where a goal is, by its number in telemetry; where our robot is if it has no place. */
  placeOf(goal: number): XY | null {
    const { x = 0, y = 0 } = this.robots[0]?.pose ?? {};
    return this.goals[goal]?.place ?? [x, y];
  }

  /** Where all goals are. */
  get places(): XY[] {
    return this.goals.map(({ place }) => place);
  }

  /** Turn what has a front to the camera. */
  face({ x, y }: { readonly x: number; readonly y: number }): void {
    for (const goal of this.goals) goal.face(x, y);
  }

  show({ robots, pushed, game }: Moment): void {
    robots.forEach((robot, i) => this.robots[i]?.show(robot));
    pushed.forEach((pose, i) => this.pushed[i] && place(this.pushed[i], pose));
    if (game) this.games.show(game);
  }

  /** Mark where on our robot a type of device measures; null marks nothing. */
  point(device: string | null): void {
    if (this.origin) dispose(this.origin);
    this.origin = null;
    const [robot] = this.robots;
    if (!device || !robot || !this.described) return;
    this.origin = origin(device, this.described, robot.reach);
    robot.object.add(this.origin);
  }

  get isPointing(): boolean {
    return this.origin !== null;
  }

  /** Show where the twin of a real robot would have been; null hides it. */
  showGhost(pose: Robot | null): void {
    if (!this.ghost && pose && this.described) {
      this.ghost = robotModel(this.described);
      fade(this.ghost.object);
      this.object.add(this.ghost.object);
    }
    if (!this.ghost) return;
    this.ghost.object.visible = pose !== null;
    if (pose) this.ghost.show(pose);
  }

  /** Show the states of the goals; return those that changed. */
  showGoals(goals: readonly GoalNow[]): GoalNow[] {
    return goals.filter((goal, i) => this.goals[i]?.show(goal.state));
  }

  dispose(): void {
    this.pictures?.dispose();
    this.signs.dispose();
    for (const robot of this.robots) robot.dispose();
    this.ghost?.dispose();
    dispose(this.object);
  }

  /** Initial poses until telemetry arrives. */
  private showStarts(scene: Scene): void {
    scene.robots.forEach(([name], i) => {
      const [x, y, heading] = (i === 0 && scene.start) || [0, 0, 0];
      const start = i > 0 || !scene.start ? this.world.start[i] : undefined;
      this.robots[i]?.show({ name, ...(start ?? { x, y, heading }) });
    });
  }

  /** The poses of the other robots; the first robot has the start of the next run. */
  private otherStarts(scene: Scene): Pose[] {
    return this.world.start.slice(scene.start ? 1 : 0);
  }
}

/** Let everything shine through an object, which has no shadow. */
function fade(object: Object3D): void {
  object.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    part.castShadow = false;
    const materials: Material[] = [part.material].flat();
    const faded = materials.map((material) => Object.assign(material.clone(), FADED));
    part.material = Array.isArray(part.material) ? faded : faded[0];
  });
}

function dispose(object: Object3D): void {
  object.removeFromParent();
  object.traverse((part) => {
    if (part instanceof Mesh || part instanceof Points) release(part);
    if (part instanceof Sprite) releaseSprite(part);
  });
}

function releaseSprite({ material }: Sprite): void {
  material.map?.dispose();
  material.dispose();
}

type Drawn = Mesh<BufferGeometry, Material | Material[]> | Points<BufferGeometry, Material | Material[]>;

function release(mesh: Drawn): void {
  mesh.geometry.dispose();
  for (const material of [mesh.material].flat()) if (!SHARED.has(material)) material.dispose();
}
