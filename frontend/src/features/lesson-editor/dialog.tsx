/** The dialog in which a teacher makes or changes a lesson; what is in it is loaded when it is opened. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Dialog } from "../../ui/dialog";
import { loadedLater } from "../../ui/loaded-later";

const LessonEditor = loadedLater(async () => (await import("./editor")).LessonEditor);

export function LessonEditorDialog() {
  const making = usePage().lessonMaking;
  const title = making.draft.value?.lesson ? "page-maker-change-title" : "page-maker-make-title";
  return (
    <Dialog title={t(title)} close={() => making.close()} size="whole">
      <LessonEditor />
    </Dialog>
  );
}
