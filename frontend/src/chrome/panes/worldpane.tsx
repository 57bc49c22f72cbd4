/** The world with the robot in it, its camera, and driving by hand. */

import { t } from "../../i18n";
import { arrange, preferences } from "../../preferences";
import { IconButton } from "../widgets/button";
import { IslandPlace } from "../widgets/island";
import { usePage, type Page } from "../page";

export function WorldPane({ weight }: { weight: number }) {
  const page = usePage();
  return (
    <section
      id="world"
      class="pane world-pane"
      style={{ flexGrow: weight }}
      hidden={!page.views.shows("world")}
      aria-labelledby="title-world"
      data-region="world"
      data-tour="world"
      tabIndex={-1}
    >
      <Head />
      <div class="world-place">
        <IslandPlace load={() => loadWorld(page)} ready={(world) => (page.views.world = world)} />
        <Extras />
      </div>
    </section>
  );
}

function Head() {
  const { context, controls } = usePage();
  const { camera, drive } = preferences.value.layout;
  const { telemetry, active, state } = context.running;
  return (
    <div class="pane-head">
      <h2 id="title-world">{t("chrome.world")}</h2>
      <Goals />
      <span class="state">
        {t(`bar.state_${state.value.state}`)} · {(telemetry.value?.time ?? 0).toFixed(1)} s
      </span>
      <IconButton icon="restart" word="chrome.resetWorld" off={active.value} onClick={() => controls.resetWorld()} />
      <IconButton icon="camera" word="chrome.camera" pressed={camera} onClick={() => arrange({ camera: !camera })} />
      <IconButton icon="drive" word="chrome.drive" pressed={drive} onClick={() => arrange({ drive: !drive })} />
    </div>
  );
}

function Goals() {
  const goals = usePage().context.running.telemetry.value?.goals ?? [];
  if (goals.length === 0) return null;
  const reached = goals.filter((goal) => goal.state === "reached").length;
  return <span class="state">{t("problems.goalsReached", { reached, all: goals.length })}</span>;
}

function Extras() {
  const page = usePage();
  const { camera, drive } = preferences.value.layout;
  return (
    <>
      {camera && (
        <aside class="extra camera-place" aria-label={t("chrome.camera")}>
          <IslandPlace load={() => loadCamera(page)} />
        </aside>
      )}
      {drive && (
        <aside class="extra drive-place" aria-label={t("chrome.drive")}>
          <IslandPlace load={() => loadDrive(page)} />
        </aside>
      )}
    </>
  );
}

async function loadWorld({ context }: Page) {
  const { createWorld } = await import("../../world");
  return createWorld(context);
}

async function loadCamera({ context }: Page) {
  const { createCamera } = await import("../../robot/camera");
  return createCamera(context);
}

async function loadDrive({ context }: Page) {
  const { createDrive } = await import("../../robot/drive");
  return createDrive(context);
}
