/** The world, the chips and menus over its picture, and the run controls below it. */

import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";
import { GhostFindings, GhostLegend } from "../../features/ghost/ghost";
import { ReplayBar } from "../../features/replay/bar";
import { Legend } from "../../features/runs/legend";
import { ShownRun } from "../../features/runs/shown";
import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import { preferences } from "../../model/preferences";
import { IslandPlace } from "../../ui/island-place";
import { Chips } from "./chips";
import { EyeMenu } from "./eye-menu";
import { GameEnd } from "./game-end";
import { Goals } from "./goals";
import { Hud } from "./hud";
import { RunBar } from "./run-bar";
import { Said } from "./said";
import { Status } from "./status";
import { Timeline } from "./timeline";
import { WhyChip } from "./why-chip";
import { WorldMenu } from "./world-menu";
import "./world-pane.css";

/** A guest's page hides it, and shows the host's world in its place. */
export function WorldPane({ hidden }: { hidden: boolean }) {
  return (
    <section
      id="world"
      class="region world-pane"
      hidden={hidden}
      aria-labelledby="title-world"
      data-region="world"
      data-tour="world"
      tabIndex={-1}
    >
      <h2 id="title-world" class="hidden">
        {t("page-shell-world")}
      </h2>
      <WorldPlace>
        <Chips />
        <WorldMenu />
        <EyeMenu />
      </WorldPlace>
      <ShownRun />
      <GhostFindings />
      <RunBar />
    </section>
  );
}

interface PlaceProps {
  /** Whether the page is that of a guest, who starts no run. */
  readonly isGuests?: boolean;
  readonly children: ComponentChildren;
}

/** The world, with what the run tells over it; above all that, chips and menus. */
export function WorldPlace({ isGuests = false, children }: PlaceProps) {
  const page = usePage();
  // A lesson marks what its step asks for, which may be less than its world's goals.
  const missed = (page.lessons.shown.value ? page.lessons : page.context.running).missed.value;
  const world = page.views.world.value;
  useEffect(() => world?.showMissed(missed), [world, missed]);
  return (
    <div class="world-place">
      <IslandPlace load={() => loadWorld(page)} ready={(world) => (page.views.world.value = world)} />
      <div class="world-top">{children}</div>
      <Hud />
      <GameEnd isGuests={isGuests} />
      <div class="world-bottom">
        <Said />
        <Hint />
        <ReplayBar />
        <Timeline />
        <Status />
        <WhyChip />
        <Goals />
        <Legend />
        <GhostLegend />
      </div>
      <Extras />
    </div>
  );
}

/** What keys do in the world now. */
function Hint() {
  const hint = usePage().views.world.value?.hint.value;
  return hint ? <p class="world-hint">{hint}</p> : null;
}

function Extras() {
  const page = usePage();
  const { camera, drive } = preferences.value.layout;
  return (
    <>
      {camera && (
        // biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard has to reach it
        <aside class="extra camera-place" aria-label={t("page-shell-camera")} tabIndex={0}>
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
