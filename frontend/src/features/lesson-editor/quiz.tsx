/** The question of a step, with answers to choose from. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Problems } from "../../ui/form/field";
import { Tick } from "../../ui/form/inputs";
import { Parts } from "../../ui/form/parts";
import type { ChoiceContent, StepContent } from "../lessons/lesson-edit";
import { Translated } from "./inputs";

const MOST = 8;
const NEW = { question: {}, choices: [{ text: {}, right: true }, { text: {} }] };

export function Quiz({ step, index }: { step: StepContent; index: number }) {
  const making = usePage().lessonMaking;
  const { quiz } = step;
  const path = ["step", index, "quiz"];
  const take = (changed: StepContent["quiz"]) => making.editStep(index, { quiz: changed });
  return (
    <section class="maker-group">
      <h3>{t("page-maker-quiz")}</h3>
      <Tick text={t("page-maker-quiz-on")} value={quiz != null} take={(on) => take(on ? NEW : undefined)} />
      {quiz && (
        <>
          <Translated
            word="page-maker-question"
            path={[...path, "question"]}
            text={quiz.question}
            take={(question) => take({ ...quiz, question })}
          />
          <Parts
            values={quiz.choices}
            take={(choices) => take({ ...quiz, choices })}
            title={(number) => t("page-maker-answer", { number })}
            add={t("page-maker-add-answer")}
            fresh={(): ChoiceContent => ({ text: {} })}
            most={MOST}
          >
            {(answer, takeAnswer, at) => (
              <>
                <Translated
                  word="page-maker-answer-text"
                  path={[...path, "choices", at, "text"]}
                  text={answer.text}
                  take={(text) => takeAnswer({ ...answer, text })}
                />
                <Tick
                  text={t("page-maker-answer-right")}
                  value={answer.right === true}
                  take={(right) => takeAnswer({ ...answer, right })}
                />
                <Translated
                  word="page-maker-because"
                  path={[...path, "choices", at, "because"]}
                  text={answer.because}
                  take={(because) => takeAnswer({ ...answer, because })}
                />
              </>
            )}
          </Parts>
          {making.problemsAt(path).some((one) => one.path.length <= path.length + 1) && <Problems path={path} />}
        </>
      )}
    </section>
  );
}
