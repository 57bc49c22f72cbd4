/** Dialogs with one question about the project. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Actions, Dialog } from "../../ui/dialog";

/** The server's limit. */
const LONGEST_NAME = 100;

export function NewDialog() {
  const { dialogs, project } = usePage();
  return (
    <Dialog title={t("page-project-new-title")} close={() => dialogs.close()}>
      <NameForm
        name={t("page-project-new-name")}
        help={t("page-project-new-help")}
        action={t("page-project-new-now")}
        run={(name) => project.create(name)}
      />
    </Dialog>
  );
}

export function SaveAsDialog() {
  const { dialogs, project } = usePage();
  return (
    <Dialog title={t("page-project-save-as-title")} close={() => dialogs.close()}>
      <NameForm
        name={t("page-project-copy-of", { name: project.name.value })}
        help={t("page-project-save-as-help")}
        action={t("page-project-save-copy")}
        run={(name) => project.saveAs(name)}
      />
    </Dialog>
  );
}

export function RenameDialog() {
  const { dialogs, project } = usePage();
  return (
    <Dialog title={t("page-project-rename-title")} close={() => dialogs.close()}>
      <NameForm
        name={project.name.value}
        help={t("page-project-rename-help")}
        action={t("page-project-rename-now")}
        run={(name) => project.rename(name)}
      />
    </Dialog>
  );
}

interface NameFormProps {
  readonly name: string;
  readonly help: string;
  readonly action: string;
  readonly run: (name: string) => void;
}

/** Asks for a project's name, then closes the dialog. */
function NameForm({ name: first, help, action, run }: NameFormProps) {
  const { dialogs } = usePage();
  const name = useSignal(first);
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    dialogs.close();
    run(name.value.trim());
  };
  return (
    <form onSubmit={submit}>
      <label class="field">
        {t("page-project-name")}
        <input
          required
          autofocus
          pattern=".*\S.*"
          maxLength={LONGEST_NAME}
          value={name.value}
          onFocus={({ currentTarget }) => currentTarget.select()}
          onInput={({ currentTarget }) => (name.value = currentTarget.value)}
        />
      </label>
      <p class="dim">{help}</p>
      <Actions cancel={() => dialogs.close()}>
        <button type="submit" class="button filled">
          {action}
        </button>
      </Actions>
    </form>
  );
}

export function DeleteDialog({ name }: { name: string }) {
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
