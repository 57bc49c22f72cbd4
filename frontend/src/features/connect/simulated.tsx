/** The robots that need no connection: the twins, the user's own, and those in other simulators. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { prefer, preferences } from "../../model/preferences";
import { OTHER_SIMULATORS, plainTitle } from "../../model/robots";
import type { RobotChoice } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { RobotPicture } from "../../ui/robots/picture";

/** Our twins; the others are the user's. */
const TWINS: ReadonlySet<string> = new Set(
  ["ebo", "thymio", "ev3", "cozmo", "spike", "root", "create3"].map((robot) => `sim-${robot}`),
);

export function SimulatedRobots() {
  const { project } = usePage();
  const robots = project.welcome.value?.robots ?? [];
  const groups = [
    { name: "twins", robots: robots.filter((one) => TWINS.has(one.name)) },
    { name: "own", robots: robots.filter((one) => one.simulated && !TWINS.has(one.name)) },
    { name: "simulators", robots: robots.filter((one) => OTHER_SIMULATORS.has(one.name)) },
  ];
  return (
    <div class="connect-simulated">
      {groups.map(
        (group) =>
          group.robots.length > 0 && (
            <section key={group.name} aria-label={t(`page-connect-group-${group.name}`)}>
              <h3>{t(`page-connect-group-${group.name}`)}</h3>
              {group.name === "simulators" && <p class="dim">{t("page-connect-simulators-help")}</p>}
              <ul class="connect-cards">
                {group.robots.map((robot) => (
                  <TwinCard key={robot.name} robot={robot} />
                ))}
              </ul>
            </section>
          ),
      )}
    </div>
  );
}

function TwinCard({ robot }: { robot: RobotChoice }) {
  const { context, dialogs, project } = usePage();
  const { connection, running } = context;
  const chosen = project.atStart.value ? preferences.value.robot : running.robot.value;
  const real = usePage().connect.state.value.robot || chosen;
  const isChosen = chosen === robot.name;
  const isTwin = robot.name === `sim-${real}`;
  const off = running.active.value && !project.atStart.value;
  const use = () => {
    if (project.atStart.value) prefer({ robot: robot.name });
    else connection.send({ kind: "ChooseRobot", name: robot.name });
    dialogs.close();
  };
  return (
    <li class={isChosen || isTwin ? "twin chosen" : "twin"}>
      <RobotPicture robot={robot.name} />
      <strong>{plainTitle(robot)}</strong>
      {isTwin && <span class="dim">{t("page-connect-twin")}</span>}
      {isChosen ? (
        <span class="connect-chosen">
          <Icon name="check" />
          {t("page-connect-chosen")}
        </span>
      ) : (
        <button
          type="button"
          class="button filled"
          aria-label={t("page-connect-use-named", { robot: plainTitle(robot) })}
          disabled={off}
          onClick={use}
        >
          {t("page-connect-use")}
        </button>
      )}
    </li>
  );
}
