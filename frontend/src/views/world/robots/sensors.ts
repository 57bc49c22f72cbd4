/** The windows of a robot's distance sensors, from its description. */

import type { RobotValues } from "../scenery/description";
import { radians } from "../scenery/geometry";
import { type Parts, roundedBox } from "../scenery/solids";

/** Add a dark window for each sensor, `z` mm above the floor. */
export function addWindows(parts: Parts, robot: RobotValues, z: number, width = 12, height = 9): void {
  for (const { x, y, direction } of robot.distance) {
    const frame = roundedBox(7, width, height, 3).rotateZ(-radians(direction));
    parts.add(frame, "#151b2b", x, y, z);
    const pane = roundedBox(8, width * 0.4, height * 0.4, 1.5).rotateZ(-radians(direction));
    parts.add(pane, "#12b5cb", x, y, z);
  }
}
