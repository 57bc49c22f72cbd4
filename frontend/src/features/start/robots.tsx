/** Which robot the user has. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { prefer, preferences } from "../../model/preferences";
import { hasReal, isTwin, plainTitle } from "../../model/robots";
import type { RobotChoice } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { RobotPicture } from "../../ui/robots/picture";
import { kindTitle } from "../connect/names";

export function Robots() {
  const { dialogs, project } = usePage();
  const robots = project.welcome.value?.robots ?? [];
  return (
    <section class="start-card" aria-labelledby="start-robots" data-region="robots">
      <h2 id="start-robots">{t("page-start-robots")}</h2>
      <fieldset class="start-robots" aria-labelledby="start-robots">
        {robots.filter(isTwin).map((robot) => (
          <Robot key={robot.name} robot={robot} />
        ))}
      </fieldset>
      <div class="start-no-robot">
        <RealRobot robots={robots} />
        {hasReal(robots) && (
          <button type="button" class="button bordered" onClick={() => dialogs.show("connect")}>
            <Icon name="bluetooth" />
            {t("page-start-connect")}
          </button>
        )}
      </div>
    </section>
  );
}

/** The real robot that is used, if there is one. */
function RealRobot({ robots }: { robots: readonly RobotChoice[] }) {
  const used = usePage().connect.used.value;
  if (used === null || preferences.value.robot !== used.robot) {
    return (
      <>
        <span class="start-dot" />
        {t("page-start-no-robot")}
      </>
    );
  }
  const robot = kindTitle(robots, used.robot);
  return (
    <span role="status" class="start-ready">
      <Icon name="check" />
      {used.charge === null
        ? t("page-start-robot-ready", { robot })
        : t("page-start-robot-charge", { robot, percent: Math.round(used.charge * 100) })}
    </span>
  );
}

function Robot({ robot }: { robot: RobotChoice }) {
  const preferred = preferences.value.robot;
  // A twin's card also represents the real robot.
  const chosen = preferred === robot.name || `sim-${preferred}` === robot.name;
  return (
    <label class="start-robot choice-card">
      <input type="radio" name="robot" class="hidden" checked={chosen} onChange={() => prefer({ robot: robot.name })} />
      <RobotPicture robot={robot.name} />
      {plainTitle(robot)}
      {chosen && (
        <span class="choice-tick">
          <Icon name="check" />
        </span>
      )}
    </label>
  );
}
