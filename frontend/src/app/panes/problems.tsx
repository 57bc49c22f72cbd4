/** The program's problems, and the error of the last run. */

import { CustomBlockLink } from "../../features/custom-blocks/link";
import { t } from "../../i18n";
import { type Finding, findings } from "../../model/findings";
import { type Page, usePage } from "../../model/page";
import { sentence } from "../../model/run-result";
import type { Problem } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { RunsOn } from "./runs-on";
import "./problems.css";

export function Problems() {
  const { context } = usePage();
  const { problems, origin } = context.program.state.value;
  const found = findings(problems, origin);
  const ended = context.running.ended.value;
  const failed = ended?.ended === "error";
  return (
    <div class="problems">
      {found.length === 0 && !failed && <p class="dim">{t("page-problems-none")}</p>}
      {failed && <RunError />}
      <Group title={t("page-problems-errors")} found={found.filter((one) => one.severity === "error")} />
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
        {found.map((one) => (
          <Row key={one.key} finding={one} />
        ))}
      </ul>
    </section>
  );
}

function Row({ finding: { message, severity, places } }: { finding: Finding }) {
  const page = usePage();
  const best = nearest(places, page);
  return (
    <li>
      <button
        type="button"
        class={`problem ${severity}`}
        disabled={!best}
        onClick={() => best && page.views.goTo(best)}
      >
        <Icon name={severity} />
        <span>{message}</span>
        <span class="dim">{places.map(placeText).filter(Boolean).join(" · ")}</span>
      </button>
    </li>
  );
}

/** The position in the view with the mistake, else in another view. */
function nearest(places: readonly Problem[], { context, views }: Page): Problem | undefined {
  const { origin } = context.program.state.value;
  return places.find((one) => one.view === origin) ?? places.find((one) => views.shows(one.view)) ?? places[0];
}

function placeText({ view, line = 0 }: Problem): string {
  const name = t(`page-shell-${view}`);
  return line > 0 ? t("page-problems-place", { view: name, line }) : name;
}

function RunError() {
  const { runError, running } = usePage().context;
  const ended = running.ended.value;
  if (!ended) return null;
  const finding = { key: "run", message: sentence(ended), severity: "error", places: runError.value } as const;
  return (
    <section>
      <h3>{t("page-problems-last-run")}</h3>
      <ul>
        <Row finding={finding} />
      </ul>
      <CustomBlockLink ended={ended} />
    </section>
  );
}
