/** Dialogs with one question about the project. */

import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import type { ProjectDialogName } from "../../model/dialogs";
import { usePage } from "../../model/page";
import { projectNameFault, renameFault } from "../../model/project-name";
import { LIMITS } from "../../protocol/messages";
import { Actions, Dialog } from "../../ui/dialog";
import { NameForm } from "../../ui/name-form";

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
        help={t("page-project-copy-help")}
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
