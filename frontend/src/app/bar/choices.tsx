/** The choices for a run: speed, robot, world. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { robotGroups, robotTitle } from "../../model/robots";
import type { WorldChoice as World } from "../../protocol/messages";
import { IconButton } from "../../ui/button";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20];
/** The value of the option for the highest speed. */
const FREE = "free";

export function SpeedChoice() {
  const { context, controls } = usePage();
  const { speed } = context.running.state.value;
  const chosen = speed === null ? FREE : String(speed ?? 1);
  return (
    <label class="choice">
      <span>{t("page-bar-speed")}</span>
      <select value={chosen} onChange={({ currentTarget }) => controls.setSpeed(factor(currentTarget.value))}>
        {SPEEDS.map((one) => (
          <option key={one} value={String(one)}>
            {one < 1 ? t("page-bar-slow", { factor: one }) : t("page-bar-times", { factor: one })}
          </option>
        ))}
        <option value={FREE}>{t("page-bar-free")}</option>
      </select>
    </label>
  );
}

function factor(value: string): number | null {
  return value === FREE ? null : Number(value);
}

export function RobotChoice() {
  const { context, controls, dialogs, project } = usePage();
  const robots = project.welcome.value?.robots ?? [];
  const chosen = robots.find((one) => one.name === context.running.robot.value);
  return (
    <div class="choice-with-button">
      <label class="choice" data-tour="robot">
        <span>{t("page-bar-robot")}</span>
        <select
          value={context.running.robot.value}
          disabled={context.running.active.value}
          onChange={({ currentTarget }) => controls.chooseRobot(currentTarget.value)}
        >
          {robotGroups(robots).map((group) => (
            <optgroup key={group.name} label={t(`page-bar-robots-${group.name}`)}>
              {group.robots.map((robot) => (
                <option key={robot.name} value={robot.name}>
                  {robotTitle(robot)}
                </option>
              ))}
            </optgroup>
          ))}
        </select>
      </label>
      {chosen?.simulated === false && (
        <IconButton icon="edit" word="page-robots-robots" onClick={() => dialogs.show("robotSettings")} />
      )}
    </div>
  );
}

export function WorldChoice() {
  const { context, controls, dialogs, project } = usePage();
  const { running } = context;
  const worlds = project.worlds.value;
  const robot = project.welcome.value?.robots.find((one) => one.name === running.robot.value);
  const off = running.active.value || robot?.simulated === false;
  return (
    <div class="choice-with-button">
      <label class="choice">
        <span>{t("page-bar-world")}</span>
        <select
          value={running.world.value}
          disabled={off}
          onChange={({ currentTarget }) => controls.chooseWorld(currentTarget.value)}
        >
          <WorldOptions label={t("page-bar-own-worlds")} worlds={worlds.filter((one) => one.own)} />
          <WorldOptions label={t("page-bar-worlds")} worlds={worlds.filter((one) => !one.own)} />
        </select>
      </label>
      <IconButton icon="edit" word="page-bar-edit-world" off={off} onClick={() => dialogs.show("worldEditor")} />
    </div>
  );
}

function WorldOptions({ label, worlds }: { label: string; worlds: readonly World[] }) {
  const { project } = usePage();
  if (worlds.length === 0) return null;
  return (
    <optgroup label={label}>
      {worlds.map(({ name, title }) => (
        <option key={name} value={name} title={title}>
          {project.worldTitle(name)}
        </option>
      ))}
    </optgroup>
  );
}
