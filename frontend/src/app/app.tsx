/** The whole page. */

import { Tour } from "../features/tour/tour";
import { t } from "../i18n";
import { usePage } from "../model/page";
import { arrange, preferences } from "../model/preferences";
import { room } from "../ui/screen";
import { Splitter } from "../ui/splitter";
import { Announcements } from "./announcements";
import { ConnectionBanner, ReadOnlyBanner } from "./banner";
import { Bar } from "./bar/bar";
import { DropPlace } from "./files/drop";
import { OpenedDialog } from "./opened-dialog";
import { Panel } from "./panes/panel";
import { ProgramViews } from "./panes/program-views";
import { WorldPane } from "./panes/world-pane";
import { SkipLinks } from "./skip-links";
import { ToastList } from "./toast-list";
import "../ui/theme.css";
import "../ui/controls.css";
import "./layout.css";

export function App() {
  return (
    <div class={`page ${room.value}`}>
      <SkipLinks />
      <Bar />
      <ConnectionBanner />
      <ReadOnlyBanner />
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
          label={t("page-shell-divider-columns")}
          orientation="vertical"
          sizes={columns}
          resize={(before, after) => arrange({ columns: [before, after] })}
        />
      )}
      <div
        class="robot-column"
        style={{ flexGrow: columns[1] }}
        hidden={!views.shows("world") && !views.shows("panel")}
      >
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
          label={t("page-shell-divider-rows")}
          orientation="horizontal"
          sizes={rows}
          resize={(before, after) => arrange({ rows: [before, after] })}
        />
      )}
      <Panel weight={rows[1]} />
    </>
  );
}
