/** A program of a step: what pupils begin with, or the teacher's solution. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { WrittenProgram } from "../../protocol/messages";
import { choice } from "../../ui/form/choice";
import { FormField } from "../../ui/form/field";
import { EMPTY_PROGRAM } from "../lessons/lesson-edit";
import { ProgramText } from "./inputs";

const MOST_ROWS = 16;

interface Props {
  /** The index of the step. */
  readonly index: number;
  readonly which: "program" | "solution";
}

type Source = "none" | "blocktext" | "python";

export function ProgramInput({ index, which }: Props) {
  const making = usePage().lessonMaking;
  const program = making.draft.value?.steps[index]?.[which] ?? null;
  const take = (changed: WrittenProgram | null) => making.editPrograms(index, { [which]: changed });
  const open = making.openProgram();
  const source: Source = program === null ? "none" : (program.notation ?? "blocktext");
  const choose = (chosen: string) => {
    const { text } = program ?? EMPTY_PROGRAM;
    take(chosen === "none" ? null : { text, notation: chosen as "blocktext" | "python" });
  };
  const none =
    which === "solution" ? "page-maker-no-solution" : index > 0 ? "page-maker-as-before" : "page-maker-empty";
  const path = ["step", index, which];
  return (
    <div class="maker-program">
      <FormField
        label={t(`page-maker-${which}`)}
        path={[...path, "notation"]}
        value={source}
        {...choice([
          ["none", t(none)],
          ["blocktext", t("page-maker-in-blocktext")],
          ["python", t("page-maker-in-python")],
        ])}
        take={choose}
      />
      {open && open.text !== program?.text && (
        <button type="button" class="button bordered" onClick={() => take(open)}>
          {t(`page-maker-take-${which}`)}
        </button>
      )}
      {program && (
        <ProgramText
          word={`page-maker-${which}-text`}
          path={path}
          rows={Math.min(MOST_ROWS, program.text.split("\n").length + 1)}
          text={program.text}
          take={(text) => take({ ...program, text })}
        />
      )}
    </div>
  );
}
