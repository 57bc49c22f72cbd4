/** A question with answers to choose from; the server knows which are right. */

import { useSignal } from "@preact/signals";
import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { LessonQuiz } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { inLanguage } from "./lessons";

export function Quiz({ quiz: { question, choices, several = false, solved = false } }: { quiz: LessonQuiz }) {
  const { lessons } = usePage();
  const chosen = useSignal<readonly number[]>([]);
  const judged = lessons.quiz.value;
  const choose = (index: number, on: boolean) => {
    lessons.quiz.value = null;
    const others = several ? chosen.value.filter((one) => one !== index) : [];
    chosen.value = on ? [...others, index] : others;
  };
  return (
    <form
      class="lesson-quiz"
      onSubmit={(event) => {
        event.preventDefault();
        if (chosen.value.length > 0) lessons.answerQuiz(chosen.value);
      }}
    >
      <fieldset>
        <legend>{inLanguage(question)}</legend>
        {choices.map((choice, index) => (
          <label key={index} class="lesson-choice">
            <input
              type={several ? "checkbox" : "radio"}
              name="lesson-quiz"
              checked={chosen.value.includes(index)}
              onChange={({ currentTarget }) => choose(index, currentTarget.checked)}
            />
            <span>
              {inLanguage(choice)}
              {judged?.because?.[index] !== undefined && (
                <span class="lesson-reason">{inLanguage(judged.because[index])}</span>
              )}
            </span>
          </label>
        ))}
      </fieldset>
      <div class="lesson-answer">
        <button type="submit" class="button bordered" disabled={chosen.value.length === 0}>
          {t("page-lesson-answer")}
        </button>
        <Judged right={judged ? (judged.right ?? false) : solved ? true : null} />
      </div>
    </form>
  );
}

/** Whether the answer is right; null before it is known. */
export function Judged({ right }: { right: boolean | null }) {
  return (
    <p role="status" class={right ? "lesson-judged right" : "lesson-judged"}>
      {right !== null && (
        <>
          <Icon name={right ? "earned" : "close"} />
          {t(right ? "page-lesson-right" : "page-lesson-wrong")}
        </>
      )}
    </p>
  );
}
