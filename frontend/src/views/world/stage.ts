/** The drawing of one scene, updated by telemetry. */

import { type BufferGeometry, Group, type Material, Mesh, type Object3D } from "three";
import type { GoalNow, Scene } from "../../protocol/messages";
import { type Beams, beams } from "./beams";
import { type GoalMark, goalMarks, Signs, startMark } from "./marks";
import type { Moment } from "./motion";
import { type RobotModel, robotModel } from "./robots";
import type { RobotValues, WorldValues } from "./scenery/description";
import { floor, LINE_PAINT } from "./scenery/floor";
import type { Pose } from "./scenery/geometry";
import { Pictures } from "./scenery/pictures";
import { SHADE } from "./scenery/shadows";
import { PAINT } from "./scenery/solids";
import { glow, place, things } from "./scenery/things";

/** Materials that all scenes share. */
const SHARED: ReadonlySet<Material> = new Set([PAINT, SHADE, LINE_PAINT]);

export class Stage {
  readonly object = new Group();
  readonly world: WorldValues;
  readonly robots: readonly RobotModel[];
  readonly beams: Beams | null;
  private readonly pushed: readonly Object3D[];
  private readonly goals: readonly GoalMark[];
  private readonly signs = new Signs();
  private readonly pictures: Pictures;
  private start: Object3D | null = null;

  /** @param changed is called when a picture has loaded. */
  constructor(scene: Scene, changed: () => void) {
    this.world = scene.world as unknown as WorldValues;
    this.pictures = new Pictures(changed);
    const { fixed, pushed } = things(this.world, this.pictures);
    this.pushed = pushed;
    this.goals = goalMarks(this.world, scene.lines, this.signs);
    const descriptions = scene.robots.map(([, values]) => values as unknown as RobotValues);
    this.robots = descriptions.map(robotModel);
    this.beams = descriptions[0] ? beams(descriptions[0]) : null;
    const marks = [...this.world.light.map(glow), ...this.otherStarts(scene).map(startMark)];
    const models = [...this.goals, ...this.robots].map(({ object }) => object);
    this.object.add(floor(scene.name, this.world, scene.lines, this.pictures), fixed);
    for (const part of [...pushed, ...marks, ...models]) this.object.add(part);
    this.showStarts(scene);
    if (this.robots[0] && this.beams) this.robots[0].object.add(this.beams.object);
    this.startAt(scene.start);
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

  show({ robots, pushed }: Moment): void {
    robots.forEach((robot, i) => this.robots[i]?.show(robot));
    pushed.forEach((pose, i) => this.pushed[i] && place(this.pushed[i], pose));
  }

  /** Show the states of the goals; return those that changed. */
  showGoals(goals: readonly GoalNow[]): GoalNow[] {
    return goals.filter((goal, i) => this.goals[i]?.show(goal.state));
  }

  dispose(): void {
    this.pictures.dispose();
    this.signs.dispose();
    for (const robot of this.robots) robot.dispose();
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

function dispose(object: Object3D): void {
  object.removeFromParent();
  object.traverse((part) => part instanceof Mesh && release(part));
}

function release(mesh: Mesh<BufferGeometry, Material | Material[]>): void {
  mesh.geometry.dispose();
  for (const material of [mesh.material].flat()) if (!SHARED.has(material)) material.dispose();
}
