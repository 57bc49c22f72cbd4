/** Chooses a classmate who is to see a program. */

import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import type { ShowDialogName } from "../../model/dialogs";
import { usePage } from "../../model/page";
import { Dialog } from "../../ui/dialog";
import { ChooseClassmate } from "./choose-classmate";

export function ShowClassmateDialog({ of: { showLink } }: { of: ShowDialogName }) {
  const { dialogs, shownPrograms } = usePage();
  useEffect(() => shownPrograms.ask(), []);
  const close = () => dialogs.close();
  return (
    <Dialog title={t("page-show-title")} close={close}>
      <p>{t("page-show-how")}</p>
      <ChooseClassmate
        classmates={shownPrograms.viewers.value}
        none={t("page-show-none-here")}
        choose={({ id }) => {
          close();
          shownPrograms.show(id, showLink);
        }}
      />
    </Dialog>
  );
}
