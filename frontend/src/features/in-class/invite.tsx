/** Chooses a classmate whose program is to drive the second robot. */

import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { Classmate } from "../../protocol/classroom";
import { Dialog } from "../../ui/dialog";
import { ChooseClassmate } from "./choose-classmate";

export function InviteDialog() {
  const { dialogs, pairs } = usePage();
  useEffect(() => pairs.ask(), []);
  const close = () => dialogs.close();
  const invite = ({ id }: Classmate) => {
    close();
    pairs.invite(id);
  };
  return (
    <Dialog title={t("page-pair-title")} close={close}>
      <p>{t("page-pair-how")}</p>
      <ChooseClassmate classmates={pairs.classmates.value} none={t("page-pair-none-here")} choose={invite} />
    </Dialog>
  );
}
