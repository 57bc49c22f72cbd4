/** The world of a recorded run: it is written once for all robots in it, each of which sees itself first. */

import type { Scene, Telemetry } from "../../protocol/messages";

type RobotNow = Telemetry["robots"][number];

/** What a robot of the world has of its own. */
export interface Resident extends Pick<Scene, "cameras" | "start"> {
  readonly name: string;
}

export class RecordedWorld {
  private readonly states: ReadonlyMap<number, readonly RobotNow[]>;

  /** `states` are those of all robots at each time in s. */
  constructor(
    private readonly scene: Scene,
    states: readonly (readonly [number, readonly RobotNow[]])[],
  ) {
    this.states = new Map(states);
  }

  /** The world in which a robot is. */
  sceneOf({ name, cameras, start }: Resident): Scene {
    return { ...this.scene, cameras, start, robots: ownFirst(this.scene.robots, ([other]) => other === name) };
  }

  /** Where all robots were at a time in s of a recorded moment. */
  robotsAt(time: number, { name }: Resident): RobotNow[] {
    return ownFirst(this.states.get(time) ?? [], (robot) => robot.name === name);
  }
}

function ownFirst<Robot>(robots: readonly Robot[], isOwn: (robot: Robot) => boolean): Robot[] {
  return [...robots.filter(isOwn), ...robots.filter((robot) => !isOwn(robot))];
}
