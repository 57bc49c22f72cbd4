/** The dialog in which a teacher makes or changes a lesson; what is in it is loaded when it is opened. */

import { useSignal } from "@preact/signals";
import type { FunctionComponent } from "preact";
import { useEffect } from "preact/hooks";
import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Dialog } from "../../ui/dialog";

export function LessonEditorDialog() {
  const making = usePage().lessonMaking;
  const loaded = useSignal<{ readonly Part: FunctionComponent } | null>(null);
  useEffect(() => {
    void import("./editor").then(({ LessonEditor }) => (loaded.value = { Part: LessonEditor }));
  }, []);
  const Part = loaded.value?.Part;
  const title = making.draft.value?.lesson ? "page-maker-change-title" : "page-maker-make-title";
  return (
    <Dialog title={t(title)} close={() => making.close()} size="whole">
      {Part && <Part />}
    </Dialog>
  );
}
