/** Asks for another name of the robot whose tab is open. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { robotNameFault } from "../../model/project-name";
import { LIMITS } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";
import { NameForm } from "../../ui/name-form";

export function RenameRobotDialog() {
  const { dialogs, tabs } = usePage();
  const close = () => dialogs.close();
  const name = tabs.open.value;
  return (
    <Dialog title={t("page-tabs-rename-title")} close={close}>
      <NameForm
        name={name}
        longest={LIMITS.RenameTab.new}
        help={t("page-tabs-rename-help")}
        action={t("page-tabs-rename-action")}
        fault={(to) => robotNameFault(to, name, tabs.tabs.value)}
        close={close}
        run={(to) => tabs.rename(name, to)}
      />
    </Dialog>
  );
}
