/** Everything that is wrong with the program, and the last run's error. */

import { t } from "../../i18n";
import type { Problem } from "../../messages";
import { findings, type Finding } from "./findings";
import { Icon } from "../widgets/icons";
import { OwnBlockLink } from "./ownblocklink";
import { usePage, type Page } from "../page";
import { sentence } from "../result";
import "./problems.css";

export function Problems() {
  const { context } = usePage();
  const found = findings(context.program.state.value.problems);
  const ended = context.running.ended.value;
  const failed = ended?.ended === "error";
  return (
    <div class="problems">
      {found.length === 0 && !failed && <p class="dim">{t("problems.none")}</p>}
      {failed && <RunError />}
      <Group title={t("problems.errors")} found={found.filter((one) => one.severity === "error")} />
      <Group title={t("problems.warnings")} found={found.filter((one) => one.severity === "warning")} />
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
      <button type="button" class={`problem ${severity}`} disabled={!best} onClick={() => best && page.views.goTo(best)}>
        <Icon name={severity} />
        <span>{message}</span>
        <span class="dim">{places.map(placeText).filter(Boolean).join(" · ")}</span>
      </button>
    </li>
  );
}

/** Where the mistake was made, or else where it is seen. */
function nearest(places: readonly Problem[], { context, views }: Page): Problem | undefined {
  const { origin } = context.program.state.value;
  return places.find((one) => one.view === origin) ?? places.find((one) => views.shows(one.view)) ?? places[0];
}

export function placeText({ view, line = 0 }: Problem): string {
  const name = t(`chrome.${view}`);
  return line > 0 ? t("problems.place", { view: name, line }) : name;
}

function RunError() {
  const { runError, running } = usePage().context;
  const ended = running.ended.value;
  if (!ended) return null;
  const finding = { key: "run", message: sentence(ended), severity: "error", places: runError.value } as const;
  return (
    <section>
      <h3>{t("problems.lastRun")}</h3>
      <ul>
        <Row finding={finding} />
      </ul>
      <OwnBlockLink ended={ended} />
    </section>
  );
}
