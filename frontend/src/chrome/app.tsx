/** The whole page. */

import { t } from "../i18n";
import { preferences, arrange } from "../preferences";
import { Announcements } from "./notes/announcements";
import { Bar } from "./bar/bar";
import { ConnectionBanner } from "./notes/banner";
import { DropPlace } from "./drop";
import { OpenedDialog } from "./dialogs/opened";
import { usePage } from "./page";
import { Panel } from "./panes/panel";
import { ProgramViews } from "./panes/programviews";
import { room } from "./screen";
import { SkipLinks } from "./skiplinks";
import { Splitter } from "./widgets/splitter";
import { ToastList } from "./notes/toastlist";
import { Tour } from "./tour";
import { WorldPane } from "./panes/worldpane";
import "./theme.css";
import "./controls.css";
import "./layout.css";

export function App() {
  return (
    <div class={`page ${room.value}`}>
      <SkipLinks />
      <Bar />
      <ConnectionBanner />
      <Main />
      <ToastList />
      <OpenedDialog />
      <Tour />
      <DropPlace />
      <Announcements />
    </div>
  );
}

function Main() {
  const { views } = usePage();
  const { columns } = preferences.value.layout;
  const beside = room.value !== "narrow";
  return (
    <main class="main">
      <ProgramViews weight={columns[0]} />
      {beside && (
        <Splitter
          label={t("chrome.dividerColumns")}
          orientation="vertical"
          sizes={columns}
          resize={(before, after) => arrange({ columns: [before, after] })}
        />
      )}
      <div class="robot-column" style={{ flexGrow: columns[1] }} hidden={!views.shows("world") && !views.shows("panel")}>
        <RobotColumn />
      </div>
    </main>
  );
}

function RobotColumn() {
  const { rows } = preferences.value.layout;
  return (
    <>
      <WorldPane weight={rows[0]} />
      {room.value !== "narrow" && (
        <Splitter
          label={t("chrome.dividerRows")}
          orientation="horizontal"
          sizes={rows}
          resize={(before, after) => arrange({ rows: [before, after] })}
        />
      )}
      <Panel weight={rows[1]} />
    </>
  );
}
