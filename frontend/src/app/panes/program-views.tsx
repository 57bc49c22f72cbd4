/** The three views of the program, and which of them are shown. */

import { Fragment } from "preact";

import { titleOf } from "../../features/block-sets/block-sets";
import { PROGRAM_PANEL, RobotTabRow } from "../../features/robot-tabs/row";
import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import { arrange, preferences } from "../../model/preferences";
import { VIEWS, type ViewIsland } from "../../model/views";
import type { View } from "../../protocol/messages";
import { IconButton } from "../../ui/button";
import { Icon } from "../../ui/icons";
import { IslandPlace } from "../../ui/island-place";
import { room } from "../../ui/screen";
import { Splitter } from "../../ui/splitter";
import { whenNeeded } from "./hidden-parts";
import { SameStep } from "./same-step";
import { StaleNote } from "./stale-note";

export function ProgramViews() {
  const { tabs, views } = usePage();
  const isPanel = tabs.tabs.value.length > 0;
  const panel = isPanel ? ({ id: PROGRAM_PANEL, role: "tabpanel", "aria-labelledby": "robot-tab" } as const) : {};
  const shown = VIEWS.filter((view) => views.shows(view));
  return (
    <div class={views.isSplit ? "region program-column split" : "region program-column"}>
      <RobotTabRow />
      <ProgramHead />
      <div class="views" hidden={shown.length === 0} data-tour="views" {...panel}>
        {VIEWS.map((view) => (
          <Fragment key={view}>
            {shown.indexOf(view) > 0 && <ViewSplitter before={shown[shown.indexOf(view) - 1] ?? view} after={view} />}
            <ViewPane view={view} />
          </Fragment>
        ))}
      </div>
      <SameStep />
    </div>
  );
}

/** The switches of the views, and what concerns the whole program. */
function ProgramHead() {
  const { views } = usePage();
  const isNarrow = room.value === "narrow";
  return (
    <div class="program-head" data-region="program">
      <ViewSwitch />
      {!isNarrow && (
        <IconButton icon="split" word="page-shell-split" pressed={views.isSplit} onClick={() => views.toggleSplit()} />
      )}
      <StaleNote />
      <ShownBlocks />
      <UndoButtons />
      {!isNarrow && views.shows("blocks") && <ZoomButtons />}
    </div>
  );
}

const VIEW_ICONS = { blocks: "blocks", blocktext: "blocktext", python: "python" } as const;

/** One program, so the views are joined by links. */
function ViewSwitch() {
  const { views } = usePage();
  return (
    <div role="group" aria-label={t("page-shell-shown")} class="areas" data-tour="areas">
      {VIEWS.map((view, index) => (
        <Fragment key={view}>
          {index > 0 && <Icon name="link" />}
          <button type="button" aria-pressed={views.shows(view)} onClick={() => views.toggle(view)}>
            <Icon name={VIEW_ICONS[view]} />
            {t(`page-shell-${view}`)}
          </button>
        </Fragment>
      ))}
    </div>
  );
}

function UndoButtons() {
  const { program } = usePage().context;
  const { canUndo, canRedo } = program.state.value;
  const readOnly = program.readOnly.value !== null;
  return (
    <div class="undo-buttons">
      <IconButton icon="undo" word="page-bar-undo" off={readOnly || !canUndo} onClick={() => program.undo()} />
      <IconButton icon="redo" word="page-bar-redo" off={readOnly || !canRedo} onClick={() => program.redo()} />
    </div>
  );
}

const ZOOM = { in: "plus", out: "minus", reset: "follow" } as const;

/** A phone has none: two fingers zoom. */
function ZoomButtons() {
  const { views } = usePage();
  return (
    <div role="group" class="zoom-buttons" aria-label={t("page-blocks-zoom")}>
      {(["out", "in", "reset"] as const).map((change) => (
        <IconButton
          key={change}
          icon={ZOOM[change]}
          word={`page-blocks-zoom-${change}`}
          onClick={() => views.zoomBlocks(change)}
        />
      ))}
    </div>
  );
}

/** Shows the chosen block set, unless all blocks are shown. */
function ShownBlocks() {
  const { dialogs, blockSets } = usePage();
  if (!blockSets.hidesSome.value) return null;
  const title = titleOf(blockSets.shown.value);
  const name = t("page-sets-button", { title });
  return (
    <button
      type="button"
      class="button shown-blocks"
      title={name}
      aria-label={name}
      onClick={() => dialogs.show("blockSets")}
    >
      <Icon name="blocks" />
      <span aria-hidden="true">{title}</span>
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

async function load(view: View, page: Page): Promise<ViewIsland> {
  const { context, views } = page;
  await whenNeeded(page, () => views.shows(view));
  if (view === "blocks") {
    const { createBlocks } = await import("../../views/blocks/blocks-view");
    return createBlocks(context);
  }
  const { createText } = await import("../../views/text/text-view");
  return createText(context, view);
}
