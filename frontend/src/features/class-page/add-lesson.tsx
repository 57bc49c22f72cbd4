/** Adds a lesson of the teacher's own to those that can be handed out. */

import { useSignal } from "@preact/signals";

import { type Phrase, say, t } from "../../i18n";
import type { LessonOffer } from "../../protocol/classroom";
import { sendFile, UNSENT } from "../../protocol/send-file";
import { chooseFile } from "../../ui/files";
import { Icon } from "../../ui/icons";
import { LARGEST, LESSON_FILES } from "../lessons/lesson-file";
import { inLanguage } from "../lessons/texts";

interface Props {
  readonly offers: readonly LessonOffer[];
  /** Called with the name of a lesson that was added; it is among the offers a moment later. */
  readonly choose: (name: string) => void;
}

export function AddLesson({ offers, choose }: Props) {
  const added = useSignal("");
  const problem = useSignal<Phrase | null>(null);
  const isBusy = useSignal(false);
  const lesson = offers.find(({ name }) => name === added.value);
  const add = async (file: File) => {
    added.value = "";
    isBusy.value = true;
    const { answer = "", refusal } = await sent(file);
    isBusy.value = false;
    added.value = answer;
    problem.value = answer ? null : (refusal ?? UNSENT);
    if (answer) choose(answer);
  };
  return (
    <>
      <button
        type="button"
        class="button bordered hand-out-add"
        disabled={isBusy.value}
        onClick={() => chooseFile(LESSON_FILES, (file) => void add(file))}
      >
        <Icon name="upload" />
        {t("page-class-add-lesson")}
      </button>
      <p role="status" class={lesson ? "dim" : "hidden"}>
        {lesson && t("page-lesson-imported", { title: inLanguage(lesson.title) })}
      </p>
      <p role="alert" class={problem.value ? "class-problem" : "hidden"}>
        {problem.value && say(problem.value)}
      </p>
    </>
  );
}

async function sent(file: File) {
  const { name, size } = file;
  if (size > LARGEST) return { refusal: { code: "page-lesson-too-large", values: { name } } };
  return sendFile<string>(`lessons?${new URLSearchParams({ filename: name })}`, file);
}
