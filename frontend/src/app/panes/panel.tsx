/** The panel below the world: console, variables, calls, why, runs, sensors, problems, result. */

import { untracked, useSignalEffect } from "@preact/signals";

import { Calls } from "../../features/calls/calls";
import { Runs } from "../../features/runs/runs";
import { Why } from "../../features/why/why";
import { t } from "../../i18n";
import { countProblems } from "../../model/findings";
import { type Page, usePage } from "../../model/page";
import { IslandPlace } from "../../ui/island-place";
import { Tabs } from "../../ui/tabs";
import { whenNeeded } from "./hidden-parts";
import { Problems } from "./problems";
import { Result } from "./result-panel";

export function Panel() {
  const page = usePage();
  const { views, context } = page;
  // While the output is closed, the world shows a question.
  useSignalEffect(() => {
    const isAsked = context.running.dialogue.asked.value !== null;
    if (isAsked && untracked(() => views.shows("panel"))) views.panel.value = "console";
  });
  return (
    <section
      id="panel"
      class="region panel-pane"
      hidden={!views.shows("panel")}
      aria-labelledby="title-panel"
      data-region="panel"
      data-tour="panel"
      tabIndex={-1}
    >
      <h2 id="title-panel" class="hidden">
        {t("page-shell-panel")}
      </h2>
      <Tabs
        label={t("page-shell-panel")}
        tabs={tabs(page)}
        selected={views.panel.value}
        select={(name) => (views.panel.value = name)}
      />
    </section>
  );
}

function tabs(page: Page) {
  const { count, serious } = countProblems(page.context);
  return [
    { name: "console", text: t("page-shell-console"), panel: <IslandPlace load={() => loadConsole(page)} /> },
    { name: "variables", text: t("page-shell-variables"), panel: <IslandPlace load={() => loadVariables(page)} /> },
    { name: "calls", text: t("page-shell-calls"), panel: <Calls /> },
    { name: "why", text: t("page-shell-why"), panel: <Why /> },
    { name: "runs", text: t("page-shell-runs"), panel: <Runs /> },
    { name: "sensors", text: t("page-shell-sensors"), panel: <IslandPlace load={() => loadSensors(page)} /> },
    { name: "problems", text: t("page-shell-problems"), count, serious, panel: <Problems /> },
    { name: "result", text: t("page-shell-result"), panel: <Result /> },
  ] as const;
}

async function loadConsole({ context }: Page) {
  const { createConsole } = await import("../../views/output/console");
  return createConsole(context);
}

async function loadVariables(page: Page) {
  await whenNeeded(page, () => page.views.showsPanel("variables"));
  const { createVariables } = await import("../../views/output/variables");
  return createVariables(page.context);
}

async function loadSensors(page: Page) {
  const { context, views } = page;
  await whenNeeded(page, () => views.showsPanel("sensors"));
  const { createSensors } = await import("../../views/output/sensors");
  return createSensors(context, views.plotted);
}
