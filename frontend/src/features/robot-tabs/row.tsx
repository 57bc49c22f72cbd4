/** The tabs of the project's programs, once it has several; the robot menu adds the first. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { areRobotsFixed } from "../../model/robot-tabs";
import type { Tab, TabRobot } from "../../protocol/messages";
import { IconButton } from "../../ui/button";
import { Icon, type IconName } from "../../ui/icons";
import { Menu } from "../../ui/menu";
import { navigateTabs } from "../../ui/tabs";
import "./row.css";

/** The panel that the tabs control. */
export const PROGRAM_PANEL = "program-panel";

export function RobotTabRow() {
  const { tabs } = usePage();
  if (tabs.tabs.value.length === 0) return null;
  return (
    <div class="robot-tabs" data-tour="robots">
      <div class="tabs" role="tablist" aria-label={t("page-tabs-label")} onKeyDown={navigateTabs}>
        {tabs.tabs.value.map((tab) => (
          <RobotTab key={tab.name} tab={tab} />
        ))}
      </div>
      <ShownRobot />
      <OpenTabButtons />
      <AddRobots />
    </div>
  );
}

function RobotTab({ tab }: { tab: Tab }) {
  const { project, tabs } = usePage();
  const selected = tab.name === tabs.open.value;
  const mark = markOf(tab);
  return (
    <button
      type="button"
      role="tab"
      id={selected ? "robot-tab" : undefined}
      aria-controls={PROGRAM_PANEL}
      aria-selected={selected}
      tabIndex={selected ? 0 : -1}
      title={project.robotTitle(tab.robot)}
      onClick={() => selected || tabs.show(tab.name)}
    >
      <span class="robot-color" style={{ background: tabs.colorOf(tab.name) }} />
      {tab.name}
      {tab.robots && <span class="robot-count">{t("page-tabs-times", { count: tab.robots.length })}</span>}
      {mark && (
        <span class={`robot-mark ${mark.icon}`}>
          <Icon name={mark.icon} />
          <span class="hidden">{mark.text}</span>
        </span>
      )}
    </button>
  );
}

/** What a tab shows of its program beside the name. */
function markOf({
  state,
  failed,
  mistakes = false,
}: TabRobot & { mistakes?: boolean }): { icon: IconName; text: string } | null {
  if (failed) return { icon: "error", text: t("page-tabs-failed") };
  if (state === "done") return { icon: "check", text: t("page-bar-state-done") };
  if (state === "input") return { icon: "help", text: t("page-bar-state-input") };
  if (state === "held" || state === "paused") return { icon: "pause", text: t(`page-bar-state-${state}`) };
  if (state === "running") return { icon: "run", text: t("page-bar-state-running") };
  return mistakes ? { icon: "warning", text: t("page-tabs-mistakes") } : null;
}

/** Of robots that share a program, the menu that chooses the one whose run is shown. */
function ShownRobot() {
  const { context, dialogs, tabs } = usePage();
  const robots = tabs.openTab?.robots;
  if (!robots) return null;
  const shown = tabs.shows.value;
  const items = robots.map((robot) => {
    const mark = markOf(robot);
    return {
      text: mark ? t("page-tabs-robot-state", { name: robot.name, state: mark.text }) : robot.name,
      icon: mark?.icon,
      checked: robot.name === shown,
      run: () => tabs.show(tabs.open.value, robot.name),
    };
  });
  const off = areRobotsFixed(context);
  const count = { text: t("page-tabs-count-menu"), icon: "robot", off, run: () => dialogs.show("robotCount") } as const;
  return (
    <Menu label={t("page-tabs-shown")} groups={[{ items }, { items: [count] }]}>
      {shown}
      <Icon name="down" />
    </Menu>
  );
}

function OpenTabButtons() {
  const { context, dialogs, tabs, toasts } = usePage();
  const off = areRobotsFixed(context);
  const close = () => {
    const name = tabs.open.value;
    tabs.close(name);
    const action = { text: t("page-tabs-reopen"), run: () => tabs.reopen() };
    toasts.show({ sort: "note", text: t("page-tabs-closed", { name }), action });
  };
  const values = { name: tabs.open.value };
  return (
    <>
      <IconButton
        icon="edit"
        word="page-tabs-rename"
        values={values}
        off={off}
        onClick={() => dialogs.show("renameRobot")}
      />
      {tabs.tabs.value.length > 1 && (
        <IconButton icon="close" word="page-tabs-close" values={values} off={off} onClick={close} />
      )}
    </>
  );
}

function AddRobots() {
  const { context, dialogs, tabs } = usePage();
  if (areRobotsFixed(context)) return null;
  return (
    <button
      type="button"
      class="button add-robot"
      title={t("page-tabs-add-help")}
      disabled={tabs.isFull.value}
      onClick={() => dialogs.show("addRobots")}
    >
      <Icon name="plus" />
      <span>{t("page-tabs-add-help")}</span>
    </button>
  );
}
