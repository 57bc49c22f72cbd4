/** The three views of the program, and which of them are shown. */

import { Fragment } from "preact";

import { titleOf, useBlockSets } from "../../features/block-sets/block-sets";
import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import { arrange, preferences } from "../../model/preferences";
import { type Area, VIEWS, type ViewIsland } from "../../model/views";
import type { View } from "../../protocol/messages";
import { IslandPlace } from "../../ui/island-place";
import { room } from "../../ui/screen";
import { Splitter } from "../../ui/splitter";
import { StaleNote } from "./stale-note";

export function ProgramViews({ weight }: { weight: number }) {
  const { views } = usePage();
  const shown = VIEWS.filter((view) => views.shows(view));
  return (
    <div class="program-column" style={{ flexGrow: weight }}>
      <AreaButtons />
      <div class="views" hidden={shown.length === 0} data-tour="views">
        {VIEWS.map((view) => (
          <Fragment key={view}>
            {shown.indexOf(view) > 0 && <ViewSplitter before={shown[shown.indexOf(view) - 1] ?? view} after={view} />}
            <ViewPane view={view} />
          </Fragment>
        ))}
      </div>
    </div>
  );
}

/** On a wide screen each view has its own switch; on others, one view is chosen. */
function AreaButtons() {
  const { views } = usePage();
  const areas: readonly Area[] = room.value === "narrow" ? [...VIEWS, "world", "panel"] : VIEWS;
  return (
    <div class="area-buttons">
      <div role="group" aria-label={t("page-shell-shown")} class="areas">
        {areas.map((area) => (
          <button type="button" key={area} aria-pressed={views.shows(area)} onClick={() => views.toggle(area)}>
            {t(`page-shell-${area}`)}
          </button>
        ))}
      </div>
      <StaleNote />
      <ShownBlocks />
    </div>
  );
}

/** Shows the chosen block set, unless all blocks are shown. */
function ShownBlocks() {
  const { dialogs } = usePage();
  const blockSets = useBlockSets();
  if (!blockSets.hidesSome.value) return null;
  return (
    <button type="button" class="button shown-blocks" onClick={() => dialogs.show("blockSets")}>
      {t("page-sets-button", { title: titleOf(blockSets.shown.value) })}
    </button>
  );
}

function ViewSplitter({ before, after }: { before: View; after: View }) {
  const { weights } = preferences.value.layout;
  return (
    <Splitter
      label={t("page-shell-divider-views", { before: t(`page-shell-${before}`), after: t(`page-shell-${after}`) })}
      orientation="vertical"
      sizes={[weights[before], weights[after]]}
      resize={(first, second) => arrange({ weights: { ...weights, [before]: first, [after]: second } })}
    />
  );
}

function ViewPane({ view }: { view: View }) {
  const page = usePage();
  const { weights } = preferences.value.layout;
  return (
    <section
      id={view}
      class="pane"
      style={{ flexGrow: weights[view] }}
      hidden={!page.views.shows(view)}
      aria-labelledby={`title-${view}`}
      data-region={view}
      data-tour={view}
      tabIndex={-1}
    >
      <h2 id={`title-${view}`} class="pane-title">
        {t(`page-shell-${view}`)}
      </h2>
      <IslandPlace load={() => load(view, page)} ready={(island) => page.views.put(view, island)} />
    </section>
  );
}

async function load(view: View, { context }: Page): Promise<ViewIsland> {
  if (view === "blocks") {
    const { createBlocks } = await import("../../views/blocks");
    return createBlocks(context);
  }
  const { createText } = await import("../../views/text");
  return createText(context, view);
}
