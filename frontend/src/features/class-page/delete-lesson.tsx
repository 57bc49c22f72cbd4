/** Deletes a lesson that the teacher has added. */

import { useSignal } from "@preact/signals";

import { type Phrase, say, t } from "../../i18n";
import type { LessonOffer } from "../../protocol/classroom";
import { deleteFile } from "../../protocol/send-file";
import { Actions, Dialog } from "../../ui/dialog";
import { inLanguage } from "../lessons/texts";

const UNSENT: Phrase = { code: "page-shell-unsent" };

interface Props {
  readonly lesson: LessonOffer;
  readonly close: () => void;
  /** Called when it is deleted. */
  readonly done: () => void;
}

export function DeleteLesson({ lesson: { name, title }, close, done }: Props) {
  const problem = useSignal<Phrase | null>(null);
  const remove = async () => {
    const { answer, refusal } = await deleteFile<string>(`lessons?${new URLSearchParams({ name })}`);
    if (answer) done();
    else problem.value = refusal ?? UNSENT;
  };
  return (
    <Dialog title={t("page-lesson-delete", { title: inLanguage(title) })} close={close}>
      <p>{t("page-class-delete-lesson-text")}</p>
      <p role="alert" class={problem.value ? "class-problem" : "hidden"}>
        {problem.value && say(problem.value)}
      </p>
      <Actions cancel={close}>
        <button type="button" class="button filled danger" onClick={() => void remove()}>
          {t("page-lesson-delete-now")}
        </button>
      </Actions>
    </Dialog>
  );
}
