/** The three views of the program, and which of them are shown. */

import { Fragment } from "preact";

import { titleOf } from "../../blocksets/library";
import { t } from "../../i18n";
import type { View } from "../../messages";
import { arrange, preferences } from "../../preferences";
import { IslandPlace } from "../widgets/island";
import { usePage, type Page } from "../page";
import { room } from "../screen";
import { Splitter } from "../widgets/splitter";
import { StaleNote } from "./stalenote";
import { VIEWS, type Area, type ViewIsland } from "../views";

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

/** Where there is room for several views each is switched by itself, else one is chosen. */
function AreaButtons() {
  const { views } = usePage();
  const areas: readonly Area[] = room.value === "narrow" ? [...VIEWS, "world", "panel"] : VIEWS;
  return (
    <div class="area-buttons">
      <div role="group" aria-label={t("chrome.shown")} class="areas">
        {areas.map((area) => (
          <button type="button" key={area} aria-pressed={views.shows(area)} onClick={() => views.toggle(area)}>
            {t(`chrome.${area}`)}
          </button>
        ))}
      </div>
      <StaleNote />
      <ShownBlocks />
    </div>
  );
}

/** Says which blocks there are to choose from, where that is not all of them. */
function ShownBlocks() {
  const { blockSets, dialogs } = usePage();
  if (!blockSets.hidesSome.value) return null;
  return (
    <button type="button" class="button shown-blocks" onClick={() => dialogs.show("blockSets")}>
      {t("blocksets.button", { title: titleOf(blockSets.shown.value) })}
    </button>
  );
}

function ViewSplitter({ before, after }: { before: View; after: View }) {
  const { weights } = preferences.value.layout;
  return (
    <Splitter
      label={t("chrome.dividerViews", { before: t(`chrome.${before}`), after: t(`chrome.${after}`) })}
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
        {t(`chrome.${view}`)}
      </h2>
      <IslandPlace load={() => load(view, page)} ready={(island) => page.views.put(view, island)} />
    </section>
  );
}

async function load(view: View, { context }: Page): Promise<ViewIsland> {
  if (view === "blocks") {
    const { createBlocks } = await import("../../blocks");
    return createBlocks(context);
  }
  const { createText } = await import("../../text");
  return createText(context, view);
}
