/** Adds robots: with a new program, or with the program of a tab. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import { MOST_ROBOTS } from "../../model/robot-tabs";
import { robotGroups, robotTitle } from "../../model/robots";
import { Actions, Dialog } from "../../ui/dialog";
import { CountField } from "./count";
import { canShare } from "./sharing";

/** The choice of a new program; no tab can have this name. */
const NEW = "/";

export function AddRobotsDialog() {
  const page = usePage();
  const { context, dialogs, tabs } = page;
  const program = useSignal(NEW);
  const robot = useSignal(context.running.robot.value);
  const count = useSignal(1);
  const isNew = program.value === NEW;
  const close = () => dialogs.close();
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    close();
    if (isNew) tabs.add(robot.value, count.value);
    else tabs.setCount(program.value, count.value + tabs.countOf(program.value));
  };
  const most = isNew && !canShare(page, robot.value) ? 1 : MOST_ROBOTS - tabs.count.value;
  return (
    <Dialog title={t("page-tabs-add-title")} close={close}>
      <form onSubmit={submit}>
        <label class="field">
          {t("page-tabs-program")}
          <select
            autofocus
            value={program.value}
            onChange={({ currentTarget }) => (program.value = currentTarget.value)}
          >
            <option value={NEW}>{t("page-tabs-new-program")}</option>
            {sharedPrograms(page).map(({ tab, title }) => (
              <option key={tab} value={tab}>
                {t("page-tabs-same-program", { name: title })}
              </option>
            ))}
          </select>
        </label>
        {isNew && <KindOfRobot value={robot.value} choose={(name) => (robot.value = name)} />}
        <CountField
          label={t("page-tabs-add-count")}
          value={count.value}
          most={most}
          set={(value) => (count.value = value)}
        />
        <p class="dim">{t(isNew ? "page-tabs-new-program-help" : "page-tabs-same-program-help")}</p>
        <Actions cancel={close}>
          <button type="submit" class="button filled">
            {t("page-tabs-add-action")}
          </button>
        </Actions>
      </form>
    </Dialog>
  );
}

/** The programs that more robots can run, each with the name of its tab; a single program has none. */
function sharedPrograms(page: Page): readonly { tab: string; title: string }[] {
  const { context, project, tabs } = page;
  const single = { name: "", robot: context.running.robot.value };
  const all = tabs.tabs.value.length > 0 ? tabs.tabs.value : [single];
  return all
    .filter(({ robot }) => canShare(page, robot))
    .map(({ name }) => ({ tab: name, title: name || project.name.value }));
}

function KindOfRobot({ value, choose }: { value: string; choose: (name: string) => void }) {
  const { project } = usePage();
  return (
    <label class="field">
      {t("page-bar-robot")}
      <select value={value} onChange={({ currentTarget }) => choose(currentTarget.value)}>
        {robotGroups(project.welcome.value?.robots ?? []).map(({ name, robots }) => (
          <optgroup key={name} label={t(`page-bar-robots-${name}`)}>
            {robots.map((robot) => (
              <option key={robot.name} value={robot.name}>
                {robotTitle(robot)}
              </option>
            ))}
          </optgroup>
        ))}
      </select>
    </label>
  );
}
