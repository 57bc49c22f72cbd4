/** The chosen robot, and the menu that chooses another. */

import { titleOf } from "../../features/connect/names";
import { t } from "../../i18n";
import type { Connect } from "../../model/connect";
import { type Page, usePage } from "../../model/page";
import { areRobotsFixed } from "../../model/robot-tabs";
import { hasReal, robotGroups, robotTitle } from "../../model/robots";
import type { RobotChoice } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { Menu, type MenuGroup } from "../../ui/menu";
import { RobotPicture } from "../../ui/robots/picture";

export function RobotMenu() {
  const page = usePage();
  const { context, controls, dialogs, project, tabs } = page;
  const { connect } = page;
  const robots = project.welcome.value?.robots ?? [];
  const chosen = robots.find((one) => one.name === context.running.robot.value);
  const off = context.running.active.value;
  const choices = robotGroups(robots).map((group) => ({
    title: t(`page-bar-robots-${group.name}`),
    items: group.robots.map((robot) => ({
      text: robotTitle(robot),
      checked: robot === chosen,
      off,
      run: () => controls.chooseRobot(robot.name),
    })),
  }));
  const settings = [
    { text: t("page-connect-menu"), run: () => dialogs.show("connect") },
    { text: t("page-robots-robots-menu"), run: () => dialogs.show("robotSettings") },
  ];
  const add = {
    text: t("page-tabs-add-menu"),
    off: areRobotsFixed(context) || tabs.isFull.value,
    run: () => dialogs.show("addRobots"),
  };
  const real = hasReal(robots);
  const commands = { items: real ? [add, ...settings] : [add] };
  const groups = real ? [...choices, nearby(page, connect, off), commands] : [...choices, commands];
  // Robots are looked for while the menu is open, and go on being looked for in the dialog.
  const toggled = (isOpen: boolean) => {
    if (!real) return;
    if (isOpen) connect.begin();
    else if (dialogs.open.peek() !== "connect") connect.end();
  };
  return (
    <div class="robot-menu" data-tour="robot">
      <Menu label={t("page-bar-robot")} groups={groups} look="pill" side="right" toggled={toggled}>
        <span class="robot-icon">{chosen ? <RobotPicture robot={chosen.name} /> : <Icon name="robot" />}</span>
        <span class="hidden">{t("page-bar-robot")}: </span>
        <span class="robot-name">{chosen ? robotTitle(chosen) : "…"}</span>
        {chosen && <Kind robot={chosen} />}
        <Icon name="down" />
      </Menu>
    </div>
  );
}

/** The real robots that answer now: choosing one connects to it. */
function nearby({ dialogs, project }: Page, connect: Connect, off: boolean): MenuGroup {
  const robots = project.welcome.value?.robots ?? [];
  const items = connect.lists.value.found.map((one) => ({
    text: t("page-connect-connect-named", { robot: titleOf(robots, one) }),
    icon: "wifi" as const,
    off: off || one.isBusy,
    run: () => {
      dialogs.show("connect");
      connect.connect(one.id);
    },
  }));
  return { title: t("page-connect-near"), items };
}

function Kind({ robot }: { robot: RobotChoice }) {
  if (!robot.simulated) return null;
  return <span class="robot-kind">{t("page-bar-simulated")}</span>;
}
