/** The question of a step, with answers to choose from. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { ChoiceContent, StepContent } from "../lessons/lesson-edit";
import { Add, Part, Problems, TextInput, Tick } from "./inputs";

const MOST = 8;
const NEW = { question: {}, choices: [{ text: {}, right: true }, { text: {} }] };

export function Quiz({ step, index }: { step: StepContent; index: number }) {
  const making = usePage().lessonMaking;
  const { quiz } = step;
  const path = ["step", index, "quiz"];
  const take = (changed: StepContent["quiz"]) => making.editStep(index, { quiz: changed });
  const takeChoices = (choices: readonly ChoiceContent[]) => quiz && take({ ...quiz, choices });
  return (
    <section class="maker-group">
      <h3>{t("page-maker-quiz")}</h3>
      <Tick text={t("page-maker-quiz-on")} value={quiz != null} take={(on) => take(on ? NEW : undefined)} />
      {quiz && (
        <>
          <TextInput
            word="page-maker-question"
            path={[...path, "question"]}
            text={quiz.question}
            take={(question) => take({ ...quiz, question })}
          />
          {quiz.choices.map((choice, at) => (
            <Part
              key={at}
              title={t("page-maker-answer", { number: at + 1 })}
              remove={() => takeChoices(quiz.choices.toSpliced(at, 1))}
            >
              <TextInput
                word="page-maker-answer-text"
                path={[...path, "choices", at, "text"]}
                text={choice.text}
                take={(text) => takeChoices(quiz.choices.with(at, { ...choice, text }))}
              />
              <Tick
                text={t("page-maker-answer-right")}
                value={choice.right === true}
                take={(right) => takeChoices(quiz.choices.with(at, { ...choice, right }))}
              />
              <TextInput
                word="page-maker-because"
                path={[...path, "choices", at, "because"]}
                text={choice.because}
                take={(because) => takeChoices(quiz.choices.with(at, { ...choice, because }))}
              />
            </Part>
          ))}
          <Add
            word="page-maker-add-answer"
            off={quiz.choices.length >= MOST}
            onClick={() => takeChoices([...quiz.choices, { text: {} }])}
          />
          {making.problemsAt(path).some((one) => one.path.length <= path.length + 1) && <Problems path={path} />}
        </>
      )}
    </section>
  );
}
