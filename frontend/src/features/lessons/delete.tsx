/** The question whether a lesson of the user's shall be deleted. */

import { t } from "../../i18n";
import type { LessonDialogName } from "../../model/dialogs";
import { usePage } from "../../model/page";
import { Actions, Dialog } from "../../ui/dialog";

interface Props {
  readonly of: Extract<LessonDialogName, { deleteLesson: string }>;
}

export function DeleteLessonDialog({ of: { deleteLesson, title } }: Props) {
  const { dialogs, lessons } = usePage();
  const remove = () => {
    dialogs.close();
    lessons.delete(deleteLesson);
  };
  return (
    <Dialog title={t("page-lesson-delete", { title })} close={() => dialogs.close()}>
      <p>{t("page-lesson-delete-help")}</p>
      <Actions cancel={() => dialogs.close()}>
        <button type="button" class="button filled danger" onClick={remove}>
          {t("page-lesson-delete-now")}
        </button>
      </Actions>
    </Dialog>
  );
}
