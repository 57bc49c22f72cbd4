/** Dialogs with one question about the project. */

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import type { ProjectDialogName } from "../../model/dialogs";
import { usePage } from "../../model/page";
import { prefer, preferences } from "../../model/preferences";
import type { Project } from "../../model/project";
import { projectNameFault, renameFault } from "../../model/project-name";
import { LIMITS } from "../../protocol/messages";
import { Actions, Dialog } from "../../ui/dialog";
import { NameForm } from "../../ui/name-form";

/** The world without anything in it. */
const EMPTY = "empty";

/** Asks for the name, the robot and the world, which are those of the last new project at first. */
export function NewDialog() {
  const { dialogs, project } = usePage();
  const robot = useSignal(chosenRobot(project));
  const world = useSignal(project.worlds.value.find(({ name }) => name === preferences.value.world)?.name ?? EMPTY);
  const create = (name: string) => {
    prefer({ robot: robot.value, world: world.value });
    project.create(name, null, world.value);
  };
  return (
    <Dialog title={t("page-project-new-title")} close={() => dialogs.close()}>
      <NameForm
        name={t("page-project-new-name")}
        longest={LIMITS.New.name}
        help={t("page-project-new-help")}
        action={t("page-project-new-now")}
        fault={projectNameFault}
        close={() => dialogs.close()}
        run={create}
      >
        <label class="field">
          {t("page-bar-robot")}
          <select value={robot.value} onChange={({ currentTarget }) => (robot.value = currentTarget.value)}>
            {(project.welcome.value?.robots ?? []).map(({ name }) => (
              <option key={name} value={name}>
                {project.robotTitle(name)}
              </option>
            ))}
          </select>
        </label>
        <label class="field">
          {t("page-bar-world")}
          <select value={world.value} onChange={({ currentTarget }) => (world.value = currentTarget.value)}>
            {project.worlds.value.map(({ name }) => (
              <option key={name} value={name}>
                {project.worldTitle(name)}
              </option>
            ))}
          </select>
        </label>
      </NameForm>
    </Dialog>
  );
}

/** The user's robot; of one that is not known here, its twin, or the first one. */
function chosenRobot({ welcome }: Project): string {
  const robots = welcome.value?.robots ?? [];
  const { robot } = preferences.value;
  const known = [robot, `sim-${robot}`].find((name) => robots.some((one) => one.name === name));
  return known ?? welcome.value?.robots.find(({ name }) => name.startsWith("sim-"))?.name ?? "";
}

export function SaveAsDialog() {
  const { dialogs, project } = usePage();
  return (
    <Dialog title={t("page-project-save-as-title")} close={() => dialogs.close()}>
      <NameForm
        name={t("page-project-copy-of", { name: project.name.value })}
        longest={LIMITS.SaveAs.name}
        help={t("page-project-save-as-help")}
        action={t("page-project-save-copy")}
        fault={projectNameFault}
        close={() => dialogs.close()}
        run={(name) => project.saveAs(name)}
      />
    </Dialog>
  );
}

export function RenameDialog() {
  const { project } = usePage();
  return <Rename name={project.name.value} run={(wish) => project.rename(wish)} />;
}

/** A question about a project that need not be open. */
export function ProjectDialog({ of }: { of: ProjectDialogName }) {
  if ("delete" in of) return <DeleteDialog name={of.delete} />;
  return "rename" in of ? <RenameOtherDialog name={of.rename} /> : <CopyDialog name={of.copy} />;
}

function RenameOtherDialog({ name }: { name: string }) {
  const { project } = usePage();
  return <Rename name={name} run={(wish) => project.renameOther(name, wish)} />;
}

interface RenameProps {
  readonly name: string;
  readonly run: (wish: string) => void;
}

function Rename({ name, run }: RenameProps) {
  const { dialogs, project } = usePage();
  // Which names are taken.
  useEffect(() => project.list(), []);
  return (
    <Dialog title={t("page-project-rename-title")} close={() => dialogs.close()}>
      <NameForm
        name={name}
        longest={LIMITS.RenameProject.name}
        help={t("page-project-rename-help")}
        action={t("page-project-rename-now")}
        fault={(wish) => renameFault(wish, name, project.entries.value)}
        close={() => dialogs.close()}
        run={run}
      />
    </Dialog>
  );
}

function CopyDialog({ name }: { name: string }) {
  const { dialogs, project } = usePage();
  return (
    <Dialog title={t("page-project-copy-title", { name })} close={() => dialogs.close()}>
      <NameForm
        name={t("page-project-copy-of", { name })}
        longest={LIMITS.CopyProject.name}
        help={t("page-project-new-help")}
        action={t("page-project-copy-now")}
        fault={projectNameFault}
        close={() => dialogs.close()}
        run={(wish) => project.copy(name, wish)}
      />
    </Dialog>
  );
}

function DeleteDialog({ name }: { name: string }) {
  const { dialogs, project } = usePage();
  const remove = () => {
    dialogs.close();
    project.delete(name);
  };
  return (
    <Dialog title={t("page-project-delete-named", { name })} close={() => dialogs.close()}>
      <p>{t("page-project-delete-help")}</p>
      <Actions cancel={() => dialogs.close()}>
        <button type="button" class="button filled danger" onClick={remove}>
          {t("page-project-delete-now")}
        </button>
      </Actions>
    </Dialog>
  );
}
