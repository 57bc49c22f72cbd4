/** Below the world: what the program says, what it knows, what the robot senses, what is wrong. */

import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import { findings } from "./findings";
import { IslandPlace } from "../widgets/island";
import { usePage, type Page } from "../page";
import { Problems } from "./problems";
import { Result } from "./resultpanel";
import { Tabs } from "../widgets/tabs";

export function Panel({ weight }: { weight: number }) {
  const page = usePage();
  const { views, context } = page;
  useEffect(() => context.connection.on("InputWanted", () => views.showPanel("console")), [context, views]);
  return (
    <section
      id="panel"
      class="pane panel-pane"
      style={{ flexGrow: weight }}
      hidden={!views.shows("panel")}
      aria-labelledby="title-panel"
      data-region="panel"
      data-tour="panel"
      tabIndex={-1}
    >
      <h2 id="title-panel" class="hidden">
        {t("chrome.panel")}
      </h2>
      <Tabs label={t("chrome.panel")} tabs={tabs(page)} selected={views.panel.value} select={(name) => (views.panel.value = name)} />
    </section>
  );
}

function tabs(page: Page) {
  const { context } = page;
  const failed = context.running.ended.value?.ended === "error" ? 1 : 0;
  const found = findings(context.program.state.value.problems);
  const count = found.length + failed;
  const serious = failed > 0 || found.some((one) => one.severity === "error");
  return [
    { name: "console", text: t("chrome.console"), panel: <IslandPlace load={() => loadConsole(page)} /> },
    { name: "variables", text: t("chrome.variables"), panel: <IslandPlace load={() => loadVariables(page)} /> },
    { name: "sensors", text: t("chrome.sensors"), panel: <IslandPlace load={() => loadSensors(page)} /> },
    { name: "problems", text: t("chrome.problems"), count, serious, panel: <Problems /> },
    { name: "result", text: t("chrome.result"), panel: <Result /> },
  ] as const;
}

async function loadConsole({ context }: Page) {
  const { createConsole } = await import("../../robot/console");
  return createConsole(context);
}

async function loadVariables({ context }: Page) {
  const { createVariables } = await import("../../robot/variables");
  return createVariables(context);
}

async function loadSensors({ context }: Page) {
  const { createSensors } = await import("../../robot/sensors");
  return createSensors(context);
}
