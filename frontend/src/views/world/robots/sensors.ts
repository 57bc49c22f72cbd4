/** The windows of a robot's distance sensors, from its description. */

import type { RobotValues } from "../scenery/description";
import { radians } from "../scenery/geometry";
import { type Parts, roundedBox } from "../scenery/solids";

/** Add a dark window for each sensor, `z` mm above the floor. */
export function addWindows(parts: Parts, robot: RobotValues, z: number, width = 12, height = 9): void {
  for (const { x, y, direction } of robot.distance) {
    const frame = roundedBox(5, width, height, 2).rotateZ(-radians(direction));
    parts.add(frame, "#20242c", x, y, z);
    const pane = roundedBox(6, width * 0.5, height * 0.5, 2).rotateZ(-radians(direction));
    parts.add(pane, "#b0243a", x, y, z);
  }
}
