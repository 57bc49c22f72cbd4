/** The teacher's hints of a step, each with up to three levels. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { choice } from "../../ui/form/choice";
import { FormField } from "../../ui/form/field";
import { Parts } from "../../ui/form/parts";
import type { HintContent, StepContent } from "../lessons/lesson-edit";
import { kindWords } from "./fields";
import { Translated } from "./inputs";

const LEVELS = [0, 1, 2] as const;
const MOST = 30;

export function Hints({ step, index }: { step: StepContent; index: number }) {
  const making = usePage().lessonMaking;
  const { hint: hints = [], check: checks = [] } = step;
  const names = new Set(checks.map((one) => String(one.name ?? one.kind)));
  if (checks.length === 0 && hints.length === 0) return null;
  return (
    <section class="maker-group">
      <h3>{t("page-maker-hints")}</h3>
      <p class="dim">{t("page-maker-hints-help")}</p>
      <Parts
        values={hints}
        take={(hint) => making.editStep(index, { hint })}
        title={(number) => t("page-maker-hint", { number })}
        add={t("page-maker-add-hint")}
        fresh={() => ({ say: [{}] })}
        most={MOST}
      >
        {(rule, take, at) => <Rule rule={rule} path={["step", index, "hint", at]} names={[...names]} take={take} />}
      </Parts>
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
      <FormField
        label={t("page-maker-hint-check")}
        path={[...path, "check"]}
        value={check}
        {...choice([["", t("page-maker-any-check")], ...all.map((name) => [name, kindWords(name)] as const)])}
        take={choose}
      />
      {LEVELS.map((level) => (
        <Translated
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
