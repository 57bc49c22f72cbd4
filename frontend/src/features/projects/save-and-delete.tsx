/** Dialogs with one question about the project. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Actions, Dialog } from "../../ui/dialog";

/** The server's limit. */
const LONGEST_NAME = 100;

export function SaveAsDialog() {
  const { dialogs, project } = usePage();
  const name = useSignal(t("page-project-copy-of", { name: project.name.value }));
  const save = (event: SubmitEvent) => {
    event.preventDefault();
    dialogs.close();
    project.saveAs(name.value.trim());
  };
  return (
    <Dialog title={t("page-project-save-as-title")} close={() => dialogs.close()}>
      <form onSubmit={save}>
        <label class="field">
          {t("page-project-name")}
          <input
            required
            autofocus
            pattern=".*\S.*"
            maxLength={LONGEST_NAME}
            value={name.value}
            onInput={({ currentTarget }) => (name.value = currentTarget.value)}
          />
        </label>
        <p class="dim">{t("page-project-save-as-help")}</p>
        <Actions cancel={() => dialogs.close()}>
          <button type="submit" class="button filled">
            {t("page-project-save-copy")}
          </button>
        </Actions>
      </form>
    </Dialog>
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
