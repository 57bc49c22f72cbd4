/** The whole page. */

import { type ComponentChildren, Fragment } from "preact";

import { HostWorld, useHostWorld } from "../features/in-class/host-world";
import { ClassNotes } from "../features/in-class/notes";
import { LessonPane } from "../features/lessons/panel";
import { StartPage } from "../features/start/start-page";
import { TourOffer } from "../features/tour/offer";
import { Tour } from "../features/tour/tour";
import { t } from "../i18n";
import { usePage } from "../model/page";
import { arrange, preferences } from "../model/preferences";
import { type Room, room } from "../ui/screen";
import { Splitter } from "../ui/splitter";
import { Announcements } from "./announcements";
import { ConnectionBanner, ReadOnlyBanner } from "./banner";
import { Bar } from "./bar/bar";
import { DropPlace } from "./files/drop";
import { useOpening } from "./files/opening";
import { OpenedDialog } from "./opened-dialog";
import { Panel } from "./panes/panel";
import { ProgramViews } from "./panes/program-views";
import { SkipLinks } from "./skip-links";
import { ToastList } from "./toast-list";
import { WorldPane } from "./world/world-pane";
import "../ui/fonts.css";
import "../ui/theme.css";
import "../ui/controls.css";
import "./layout.css";

export function App() {
  const { project } = usePage();
  return (
    <div class={`page ${room.value}`}>
      {project.atStart.value ? <Start /> : <Work />}
      <ToastList />
      <ClassNotes />
      <OpenedDialog />
      <DropPlace />
      <Announcements />
    </div>
  );
}

/** The page without a project. */
function Start() {
  return (
    <>
      <ConnectionBanner />
      <ReadOnlyBanner />
      <StartPage openFiles={useOpening()} />
    </>
  );
}

/** The page with an open project. */
function Work() {
  return (
    <>
      <SkipLinks />
      <Bar />
      <TourOffer />
      <ConnectionBanner />
      <ReadOnlyBanner />
      <Main />
      <Tour />
    </>
  );
}

/** The order in which the regions are read and reached with Tab is that in which they are seen. */
const ORDERS: Readonly<Record<Room, readonly Region[]>> = {
  wide: ["program", "columns", "lesson", "world", "rows", "panel"],
  medium: ["world", "rows", "panel", "lesson", "program"],
  narrow: ["world", "lesson", "program", "panel"],
};

type Region = "program" | "columns" | "lesson" | "world" | "rows" | "panel";

function Main() {
  const hasPanel = usePage().views.shows("panel");
  const hasLesson = usePage().lessons.shown.value !== null;
  const isAway = useHostWorld();
  const regions: Readonly<Record<Region, ComponentChildren>> = {
    program: <ProgramViews key="program" />,
    columns: <ColumnSplitter key="columns" />,
    lesson: hasLesson && <LessonPane key="lesson" />,
    world: (
      <Fragment key="world">
        <WorldPane hidden={isAway} />
        {isAway && <HostWorld />}
      </Fragment>
    ),
    rows: hasPanel && <RowSplitter key="rows" />,
    panel: <Panel key="panel" />,
  };
  return (
    <main
      class={["main", hasPanel && "with-panel", hasLesson && "with-lesson"].filter(Boolean).join(" ")}
      style={sizes()}
    >
      {ORDERS[room.value].map((region) => regions[region])}
    </main>
  );
}

/** The shares of the regions, for the style sheet. */
function sizes() {
  const { columns, rows } = preferences.value.layout;
  return {
    "--program": `${columns[0]}fr`,
    "--robot": `${columns[1]}fr`,
    "--world": `${rows[0]}fr`,
    "--panel": `${rows[1]}fr`,
  };
}

function ColumnSplitter() {
  const { columns } = preferences.value.layout;
  return (
    <Splitter
      label={t("page-shell-divider-columns")}
      orientation="vertical"
      sizes={columns}
      resize={(before, after) => arrange({ columns: [before, after] })}
    />
  );
}

function RowSplitter() {
  const { rows } = preferences.value.layout;
  return (
    <Splitter
      label={t("page-shell-divider-rows")}
      orientation="horizontal"
      sizes={rows}
      resize={(before, after) => arrange({ rows: [before, after] })}
    />
  );
}
