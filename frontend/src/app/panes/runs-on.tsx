/** Below the problems: which robots can run the program, and what the others lack. */

import { useEffect } from "preact/hooks";

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { robotTitle } from "../../model/robots";
import type { RobotChoice, Verdict } from "../../protocol/messages";

const MARKS = { runs: "✓", without: "✓", refused: "✗", unknown: "?" } as const;

export function RunsOn() {
  const { runsOn, project, views } = usePage();
  useEffect(() => runsOn.watch(() => views.showsPanel("problems")), [runsOn]);
  const verdicts = new Map(runsOn.verdicts.value.map((one) => [one.robot, one]));
  const known = (project.welcome.value?.robots ?? []).filter(({ name }) => verdicts.has(name));
  if (known.length === 0) return null;
  return (
    <section class="runs-on">
      <h3>{t("page-problems-runs-on")}</h3>
      <ul>
        {known.map((robot) => (
          <Row key={robot.name} robot={robot} verdict={verdicts.get(robot.name)} />
        ))}
      </ul>
    </section>
  );
}

function Row({ robot, verdict }: { robot: RobotChoice; verdict: Verdict | undefined }) {
  if (!verdict) return null;
  return (
    <li class={verdict.state}>
      <span aria-hidden="true">{MARKS[verdict.state]}</span> {robotTitle(robot)}{" "}
      <span class="dim">{say(verdict.message)}</span>
    </li>
  );
}
