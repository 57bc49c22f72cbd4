/** Dialogs that ask one thing about the project. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import { Actions, Dialog } from "../widgets/dialog";
import { usePage } from "../page";

/** As the server takes it. */
const LONGEST_NAME = 100;

export function SaveAsDialog() {
  const { dialogs, project } = usePage();
  const name = useSignal(t("project.copyOf", { name: project.name.value }));
  const save = (event: SubmitEvent) => {
    event.preventDefault();
    dialogs.close();
    project.saveAs(name.value.trim());
  };
  return (
    <Dialog title={t("project.saveAsTitle")} close={() => dialogs.close()}>
      <form onSubmit={save}>
        <label class="field">
          {t("project.name")}
          <input
            required
            autofocus
            pattern=".*\S.*"
            maxLength={LONGEST_NAME}
            value={name.value}
            onInput={({ currentTarget }) => (name.value = currentTarget.value)}
          />
        </label>
        <p class="dim">{t("project.saveAsHelp")}</p>
        <Actions cancel={() => dialogs.close()}>
          <button type="submit" class="button filled">
            {t("project.saveCopy")}
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
    <Dialog title={t("project.deleteNamed", { name })} close={() => dialogs.close()}>
      <p>{t("project.deleteHelp")}</p>
      <Actions cancel={() => dialogs.close()}>
        <button type="button" class="button filled danger" onClick={remove}>
          {t("project.deleteNow")}
        </button>
      </Actions>
    </Dialog>
  );
}
