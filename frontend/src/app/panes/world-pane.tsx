/** The world with the robot, its camera and manual control. */

import { WorldMenu } from "../../features/worlds/menu";
import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import { arrange, preferences } from "../../model/preferences";
import { IconButton } from "../../ui/button";
import { IslandPlace } from "../../ui/island-place";

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
  const { telemetry, active, scene, state } = context.running;
  return (
    <div class="pane-head">
      <h2 id="title-world">{t("page-shell-world")}</h2>
      <Goals />
      <Link />
      <span class="state">
        {t(`page-bar-state-${state.value.state}`)} · {(telemetry.value?.time ?? 0).toFixed(1)} s
      </span>
      <IconButton
        icon="restart"
        word="page-shell-reset-world"
        off={active.value || scene.value?.real}
        onClick={() => controls.resetWorld()}
      />
      <IconButton
        icon="camera"
        word="page-shell-camera"
        pressed={camera}
        onClick={() => arrange({ camera: !camera })}
      />
      <IconButton icon="drive" word="page-shell-drive" pressed={drive} onClick={() => arrange({ drive: !drive })} />
      {!active.value && !scene.value?.real && <WorldMenu />}
    </div>
  );
}

function Goals() {
  const goals = usePage().context.running.telemetry.value?.goals ?? [];
  if (goals.length === 0) return null;
  const reached = goals.filter((goal) => goal.state === "reached").length;
  return <span class="state">{t("page-problems-goals-reached", { reached, all: goals.length })}</span>;
}

const LINK_WORDS = {
  disconnected: "page-link-disconnected",
  connected: "page-link-connected",
  weak: "page-link-weak",
  lost: "page-link-lost",
} as const;

/** The link to a real robot, with its battery if the robot reports it. */
function Link() {
  const link = usePage().context.running.link.value;
  if (!link || link.state === "simulated") return null;
  const { state, battery = null, quality = null } = link;
  const words = [t(LINK_WORDS[state])];
  if (battery !== null) words.push(t("page-link-battery", { volts: battery.toFixed(1) }));
  const title = quality === null ? undefined : t("page-link-quality", { percent: Math.round(100 * quality) });
  return (
    <span class={`state link ${state}`} title={title}>
      {words.join(", ")}
    </span>
  );
}

function Extras() {
  const page = usePage();
  const { camera, drive } = preferences.value.layout;
  return (
    <>
      {camera && (
        <aside class="extra camera-place" aria-label={t("page-shell-camera")}>
          <IslandPlace load={() => loadCamera(page)} />
        </aside>
      )}
      {drive && (
        <aside class="extra drive-place" aria-label={t("page-shell-drive")}>
          <IslandPlace load={() => loadDrive(page)} />
        </aside>
      )}
    </>
  );
}

async function loadWorld({ context }: Page) {
  const { createWorld } = await import("../../views/world");
  return createWorld(context);
}

async function loadCamera({ context }: Page) {
  const { createCamera } = await import("../../views/output/camera");
  return createCamera(context);
}

async function loadDrive({ context }: Page) {
  const { createDrive } = await import("../../views/output/drive");
  return createDrive(context);
}
