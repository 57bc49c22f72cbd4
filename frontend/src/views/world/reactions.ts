/** What the picture shows for a moment when something happens to the robot. */

import { preferences } from "../../model/preferences";
import type { GoalNow, Sound, Telemetry } from "../../protocol/messages";
import { Confetti } from "./effects/confetti";
import type { Effects } from "./effects/effects";
import { Flash } from "./effects/flash";
import { Notes } from "./effects/notes";
import type { Stage } from "./stage";

export class Reactions {
  private touches = false;

  /**
   * @param stage returns what is drawn; null without a world.
   * @param isCalm returns whether nothing should move needlessly.
   */
  constructor(
    private readonly effects: Effects,
    private readonly stage: () => Stage | null,
    private readonly isCalm: () => boolean,
  ) {}

  /** Celebrate the goals that have just been reached. */
  celebrate(goals: readonly GoalNow[], news: readonly GoalNow[]): void {
    if (!preferences.peek().celebrate || this.isCalm()) return;
    goals.forEach((goal, i) => {
      const place = this.stage()?.placeOf(i);
      const isNew = goal.state === "reached" && news.includes(goal);
      if (isNew && place) this.effects.begin(new Confetti(place), performance.now());
    });
  }

  /** Show that the robot has bumped into something. */
  feel({ sensors, robots: [robot] }: Telemetry): void {
    const touches = sensors?.some(({ device, value }) => device === "Bumper" && value === true) ?? false;
    const reach = this.stage()?.robots[0]?.reach;
    if (touches && !this.touches && robot && reach)
      this.effects.begin(new Flash([robot.x, robot.y], reach), performance.now());
    this.touches = touches;
  }

  /** Show that the robot plays or says something; return whether there is anything to draw. */
  hear({ device, action }: Sound): boolean {
    const robot = this.stage()?.robots[0];
    if (!robot || !["Speaker", "MP3"].includes(device) || this.isCalm()) return false;
    const { x, y } = robot.pose;
    const notes = new Notes(action === "say" ? "speech" : "notes", { x, y, height: robot.height });
    this.effects.begin(notes, performance.now());
    return true;
  }
}
