/** Deletes a lesson that the teacher has added. */

import { useSignal } from "@preact/signals";

import { type Phrase, say, t } from "../../i18n";
import type { LessonOffer } from "../../protocol/classroom";
import { deleteFile, UNSENT } from "../../protocol/send-file";
import { Actions, Dialog } from "../../ui/dialog";
import { Icon } from "../../ui/icons";
import { inLanguage } from "../lessons/texts";

interface Props {
  readonly lesson: LessonOffer;
  /** Called when it is deleted. */
  readonly done: () => void;
}

/** The button, and the question that it asks. */
export function DeleteLesson({ lesson, done }: Props) {
  const isAsking = useSignal(false);
  const close = () => (isAsking.value = false);
  return (
    <>
      <button type="button" class="button bordered" aria-haspopup="dialog" onClick={() => (isAsking.value = true)}>
        <Icon name="trash" />
        {t("page-lesson-delete-menu")}
      </button>
      {isAsking.value && <Question lesson={lesson} close={close} done={done} />}
    </>
  );
}

function Question({ lesson: { name, title }, close, done }: Props & { readonly close: () => void }) {
  const problem = useSignal<Phrase | null>(null);
  const remove = async () => {
    const { answer, refusal } = await deleteFile<string>(`lessons?${new URLSearchParams({ name })}`);
    if (answer) {
      close();
      done();
    } else problem.value = refusal ?? UNSENT;
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
