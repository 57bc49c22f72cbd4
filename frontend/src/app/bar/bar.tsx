/** The bar: the project, the robot and the page's own menu. */

import { PupilChip } from "../../features/in-class/notes";
import { ShareButton } from "../../features/share/button";
import { HomeButton } from "../../features/start/home-button";
import { MoreMenu } from "./more-menu";
import { ProjectMenu } from "./project-menu";
import { RobotMenu } from "./robot-menu";
import "./bar.css";

export function Bar() {
  return (
    <header class="bar" data-region="bar" data-tour="bar">
      <h1 class="hidden">LearnBlock</h1>
      <HomeButton />
      <ProjectMenu />
      <span class="bar-space" />
      <ShareButton />
      <PupilChip />
      <RobotMenu />
      <MoreMenu />
    </header>
  );
}
