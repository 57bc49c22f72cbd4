/** The picture of a robot; a robot without one has a drawn icon. */

import { Icon } from "../icons";
import cozmo from "./cozmo.webp";
import create3 from "./create3.webp";
import ebo from "./ebo.webp";
import ev3 from "./ev3.webp";
import legoed from "./legoed.webp";
import root from "./root.webp";
import spike from "./spike.webp";
import thymio from "./thymio.webp";
import "./picture.css";

/** By the robot's id without `sim-`; simulators show the robot in them. */
const PICTURES: Readonly<Record<string, string>> = {
  cozmo,
  create3,
  ebo,
  ev3,
  legoed,
  root,
  spike,
  thymio,
  rcis: ebo,
  coppeliasim: ev3,
};

interface Props {
  /** The robot's id. */
  readonly robot: string;
}

/** Screen readers skip it, because the robot's name is beside it. */
export function RobotPicture({ robot }: Props) {
  const picture = PICTURES[robot.replace(/^sim-/, "")];
  return (
    <span class="robot-picture">
      {picture ? <img src={picture} alt="" width={320} height={240} /> : <Icon name="robot" />}
    </span>
  );
}
