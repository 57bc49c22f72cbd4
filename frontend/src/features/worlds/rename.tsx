import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Actions, Dialog } from "../../ui/dialog";
import { useWorlds } from "./worlds";

/** The server's limit. */
const LONGEST_TITLE = 100;

export function RenameWorldDialog() {
  const { context, dialogs, project } = usePage();
  const worlds = useWorlds();
  const name = context.running.world.value;
  const title = useSignal(project.worldTitle(name));
  const rename = (event: SubmitEvent) => {
    event.preventDefault();
    dialogs.close();
    worlds.rename(name, title.value.trim());
  };
  return (
    <Dialog title={t("page-worlds-rename-title")} close={() => dialogs.close()}>
      <form onSubmit={rename}>
        <label class="field">
          {t("page-project-name")}
          <input
            required
            autofocus
            pattern=".*\S.*"
            maxLength={LONGEST_TITLE}
            value={title.value}
            onInput={({ currentTarget }) => (title.value = currentTarget.value)}
          />
        </label>
        <p class="dim">{t("page-worlds-rename-help", { name })}</p>
        <Actions cancel={() => dialogs.close()}>
          <button type="submit" class="button filled">
            {t("page-worlds-rename-now")}
          </button>
        </Actions>
      </form>
    </Dialog>
  );
}
