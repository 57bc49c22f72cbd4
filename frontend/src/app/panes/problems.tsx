/** The program's problems, and the error of the last run. */

import { CustomBlockLink } from "../../features/custom-blocks/link";
import { t } from "../../i18n";
import { type Finding, findingsOf, placeIn, placeText } from "../../model/findings";
import { addRobot, canAddRobot } from "../../model/missing-robot";
import { usePage } from "../../model/page";
import { sentence } from "../../model/run-result";
import type { Problem } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { RunsOn } from "./runs-on";
import "./problems.css";

export function Problems() {
  const { context } = usePage();
  const found = findingsOf(context);
  const ended = context.running.ended.value;
  const failed = ended?.ended === "error";
  return (
    <div class="problems">
      {found.length === 0 && !failed && <p class="dim">{t("page-problems-none")}</p>}
      {failed && <RunError />}
      <Group title={t("page-problems-errors")} found={found.filter((one) => one.severity === "error")} />
      {found.some(({ place }) => canAddRobot(context.program, place)) && (
        <button type="button" class="button bordered" onClick={() => addRobot(context.program)}>
          {t("page-problems-add-robot")}
        </button>
      )}
      <Group title={t("page-problems-warnings")} found={found.filter((one) => one.severity === "warning")} />
      <RunsOn />
    </div>
  );
}

function Group({ title, found }: { title: string; found: readonly Finding[] }) {
  if (found.length === 0) return null;
  return (
    <section>
      <h3>
        {title} <span class="dim">({found.length})</span>
      </h3>
      <ul>
        {found.map(({ key, ...finding }) => (
          <Row key={key} {...finding} />
        ))}
      </ul>
    </section>
  );
}

function Row({ message, severity, place }: Pick<Finding, "message" | "severity"> & { place: Problem | undefined }) {
  const { context } = usePage();
  return (
    <li>
      <button
        type="button"
        class={`problem ${severity}`}
        disabled={!place}
        onClick={() => place && context.goTo(place)}
      >
        <Icon name={severity} />
        <span>{message}</span>
        <span class="dim">{place && placeText(context, place)}</span>
      </button>
    </li>
  );
}

function RunError() {
  const { openView, runError, running } = usePage().context;
  const ended = running.ended.value;
  if (!ended) return null;
  return (
    <section>
      <h3>{t("page-problems-last-run")}</h3>
      <ul>
        <Row message={sentence(ended)} severity="error" place={placeIn(runError.value, openView.value)} />
      </ul>
      <CustomBlockLink ended={ended} />
    </section>
  );
}
