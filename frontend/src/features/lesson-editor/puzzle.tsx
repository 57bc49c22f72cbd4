/** The puzzle of a step: a program whose lines pupils put in order, and lines that don't belong to it. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { Path } from "../../ui/form/form";
import { Tick } from "../../ui/form/inputs";
import { Parts } from "../../ui/form/parts";
import { EMPTY_PROGRAM, type PuzzleContent, type StepContent } from "../lessons/lesson-edit";
import { ProgramText } from "./inputs";

const MOST = 10;

interface Props {
  readonly step: StepContent;
  readonly index: number;
}

export function Puzzle({ step, index }: Props) {
  const making = usePage().lessonMaking;
  const { puzzle } = step;
  const path = ["step", index, "puzzle"];
  const turn = (on: boolean) => {
    if (!on) return making.editStep(index, { puzzle: undefined });
    const program = making.addProgram("puzzle", making.openProgram() ?? EMPTY_PROGRAM);
    making.editStep(index, { puzzle: { program } });
  };
  const take = (changed: PuzzleContent) => making.editStep(index, { puzzle: changed });
  return (
    <section class="maker-group">
      <h3>{t("page-maker-puzzle")}</h3>
      <Tick text={t("page-maker-puzzle-on")} value={puzzle != null} take={turn} />
      {puzzle && (
        <div class="maker-beside">
          <ProgramText
            word="page-maker-puzzle-program"
            path={[...path, "program"]}
            text={making.draft.value?.programs[puzzle.program] ?? ""}
            take={(text) => making.editProgram(puzzle.program, text)}
          />
          <ProgramText
            word="page-maker-distractors"
            path={[...path, "distractors"]}
            help={t("page-maker-lines-help")}
            text={(puzzle.distractors ?? []).join("\n")}
            take={(text) => take({ ...puzzle, distractors: text.split("\n") })}
          />
        </div>
      )}
      {puzzle && <OtherOrders puzzle={puzzle} path={[...path, "also"]} take={take} />}
    </section>
  );
}

interface OrdersProps {
  readonly puzzle: PuzzleContent;
  readonly path: Path;
  readonly take: (puzzle: PuzzleContent) => void;
}

/** Other orders of the same lines that are as right. */
function OtherOrders({ puzzle, path, take }: OrdersProps) {
  const making = usePage().lessonMaking;
  return (
    <Parts
      values={puzzle.also ?? []}
      take={(also) => take({ ...puzzle, also })}
      title={(number) => t("page-maker-puzzle-also", { number: number + 1 })}
      add={t("page-maker-add-order")}
      fresh={() => making.draft.value?.programs[puzzle.program] ?? ""}
      most={MOST}
    >
      {(order, takeOrder, at) => (
        <ProgramText word="page-maker-puzzle-also-program" path={[...path, at]} text={order} take={takeOrder} />
      )}
    </Parts>
  );
}
