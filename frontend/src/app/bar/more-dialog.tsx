/** What a project is rarely asked for, kept out of its menu. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Dialog } from "../../ui/dialog";
import { chooseFolder } from "../../ui/files";
import { useOpening } from "../files/opening";

interface Command {
  readonly text: string;
  readonly run: () => void;
}

export function MoreDialog() {
  const { dialogs, lessonMaking, lessons } = usePage();
  const open = useOpening();
  const close = () => dialogs.close();
  const commands: readonly Command[] = [
    { text: t("page-sets-menu"), run: () => dialogs.show("blockSets") },
    { text: t("page-custom-menu"), run: () => dialogs.show("customBlocks") },
    { text: t("page-libraries-menu"), run: () => dialogs.show("libraries") },
    { text: t("page-tags-menu"), run: () => dialogs.show("tags") },
    ...(lessons.teaches.value ? [{ text: t("page-maker-menu"), run: () => lessonMaking.make() }] : []),
    { text: t("page-share-open"), run: () => dialogs.show("openLink") },
    { text: t("page-project-upload-folder"), run: () => chooseFolder(open) },
  ];
  return (
    <Dialog title={t("page-project-more-title")} close={close}>
      <ul class="rows">
        {commands.map(({ text, run }, index) => (
          <li key={text}>
            <button
              type="button"
              class="row-main"
              autofocus={index === 0}
              onClick={() => {
                close();
                run();
              }}
            >
              <strong>{text}</strong>
            </button>
          </li>
        ))}
      </ul>
    </Dialog>
  );
}
