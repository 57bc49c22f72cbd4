/** The teacher's hints of a step, each with up to three levels. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { HintContent, StepContent } from "../lessons/lesson-edit";
import { kindWords } from "./fields";
import { Add, ChoiceInput, Part, TextInput } from "./inputs";

const LEVELS = [0, 1, 2] as const;
const MOST = 30;

export function Hints({ step, index }: { step: StepContent; index: number }) {
  const making = usePage().lessonMaking;
  const { hint: hints = [], check: checks = [] } = step;
  const take = (hint: readonly HintContent[]) => making.editStep(index, { hint });
  const names = new Set(checks.map((one) => String(one.name ?? one.kind)));
  if (checks.length === 0 && hints.length === 0) return null;
  return (
    <section class="maker-group">
      <h3>{t("page-maker-hints")}</h3>
      <p class="dim">{t("page-maker-hints-help")}</p>
      {hints.map((rule, at) => (
        <Part key={at} title={t("page-maker-hint", { number: at + 1 })} remove={() => take(hints.toSpliced(at, 1))}>
          <Rule
            rule={rule}
            path={["step", index, "hint", at]}
            names={[...names]}
            take={(changed) => take(hints.with(at, changed))}
          />
        </Part>
      ))}
      <Add word="page-maker-add-hint" off={hints.length >= MOST} onClick={() => take([...hints, { say: [{}] }])} />
    </section>
  );
}

interface RuleProps {
  readonly rule: HintContent;
  readonly path: readonly (string | number)[];
  /** What hints call the checks of the step. */
  readonly names: readonly string[];
  readonly take: (rule: HintContent) => void;
}

function Rule({ rule, path, names, take }: RuleProps) {
  const { check = "", say } = rule;
  const all = check && !names.includes(check) ? [...names, check] : names;
  const choose = (chosen: string) => {
    const { check: _old, ...others } = rule;
    take(chosen ? { ...others, check: chosen } : others);
  };
  return (
    <>
      <ChoiceInput
        word="page-maker-hint-check"
        path={[...path, "check"]}
        value={check}
        options={[["", t("page-maker-any-check")], ...all.map((one) => [one, kindWords(one)] as const)]}
        take={choose}
      />
      {LEVELS.map((level) => (
        <TextInput
          key={level}
          word={`page-maker-hint-level-${level + 1}`}
          path={[...path, "say", level]}
          text={say[level]}
          take={(text) => take({ ...rule, say: LEVELS.map((one) => (one === level ? text : (say[one] ?? {}))) })}
        />
      ))}
    </>
  );
}
