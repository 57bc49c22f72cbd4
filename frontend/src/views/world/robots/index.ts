/** The robots' models: built-in robots have their own, others follow their description. */

import type { RobotValues } from "../scenery/description";
import { cozmo } from "./cozmo";
import { create3 } from "./create3";
import { ebo } from "./ebo";
import { ev3 } from "./ev3";
import { legoed } from "./legoed";
import { type Look, RobotModel } from "./model";
import { plain } from "./plain";
import { root } from "./root";
import { spike } from "./spike";
import { thymio } from "./thymio";

const LOOKS: Readonly<Record<string, (robot: RobotValues) => Look>> = {
  ebo,
  thymio,
  ev3,
  cozmo,
  spike,
  legoed,
  root,
  create3,
};

export function robotModel(robot: RobotValues): RobotModel {
  return new RobotModel((LOOKS[robot.name] ?? plain)(robot), robot);
}

export { type EyePose, RobotModel } from "./model";
