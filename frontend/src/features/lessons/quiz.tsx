/** A question with answers to choose from; the server knows which are right. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { LessonQuiz } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { inLanguage } from "./lessons";

export function Quiz({ quiz: { question, choices, several = false } }: { quiz: LessonQuiz }) {
  const { lessons } = usePage();
  const chosen = lessons.chosen.value;
  const judged = lessons.quiz.value;
  const choose = (index: number, on: boolean) => {
    const others = several ? chosen.filter((one) => one !== index) : [];
    lessons.choose(on ? [...others, index] : others);
  };
  return (
    <form
      class="lesson-quiz"
      onSubmit={(event) => {
        event.preventDefault();
        lessons.answerQuiz();
      }}
    >
      <fieldset>
        <legend>{inLanguage(question)}</legend>
        <div class="lesson-choices">
          {choices.map((choice, index) => (
            <label key={index} class={chosen.includes(index) ? "lesson-choice chosen" : "lesson-choice"}>
              <input
                type={several ? "checkbox" : "radio"}
                name="lesson-quiz"
                checked={chosen.includes(index)}
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
        </div>
      </fieldset>
    </form>
  );
}

/** Checks the chosen answer. */
export function CheckAnswer({ quiz: { solved = false } }: { quiz: LessonQuiz }) {
  const { lessons } = usePage();
  return (
    <button
      type="button"
      class={lessons.quiz.value || solved ? "button bordered" : "button filled"}
      disabled={lessons.chosen.value.length === 0}
      onClick={() => lessons.answerQuiz()}
    >
      {t("page-lesson-answer")}
    </button>
  );
}

/** Says whether the checked answer is right. */
export function QuizResult({ quiz: { solved = false } }: { quiz: LessonQuiz }) {
  const judged = usePage().lessons.quiz.value;
  return <Judged right={judged ? (judged.right ?? false) : solved ? true : null} />;
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
