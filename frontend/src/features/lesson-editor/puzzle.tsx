/** The puzzle of a step: a program whose lines pupils put in order, and lines that don't belong to it. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { EMPTY_PROGRAM, type PuzzleContent, type StepContent } from "../lessons/lesson-edit";
import type { Path } from "../lessons/making";
import { Add, Field, Part, Tick } from "./inputs";

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
          <Field word="page-maker-puzzle-program" path={[...path, "program"]}>
            {(id, described) => (
              <textarea
                id={id}
                class="maker-code"
                rows={8}
                spellcheck={false}
                value={making.draft.value?.programs[puzzle.program] ?? ""}
                onInput={({ currentTarget }) => making.editProgram(puzzle.program, currentTarget.value)}
                {...described}
              />
            )}
          </Field>
          <Field word="page-maker-distractors" path={[...path, "distractors"]} help="page-maker-lines-help">
            {(id, described) => (
              <textarea
                id={id}
                class="maker-code"
                rows={8}
                spellcheck={false}
                value={(puzzle.distractors ?? []).join("\n")}
                onInput={({ currentTarget }) => take({ ...puzzle, distractors: currentTarget.value.split("\n") })}
                {...described}
              />
            )}
          </Field>
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
  const { also = [] } = puzzle;
  const takeAll = (orders: readonly string[]) => take({ ...puzzle, also: orders });
  return (
    <>
      {also.map((order, at) => (
        <Part
          key={at}
          title={t("page-maker-puzzle-also", { number: at + 2 })}
          remove={() => takeAll(also.toSpliced(at, 1))}
        >
          <Field word="page-maker-puzzle-also-program" path={[...path, at]}>
            {(id, described) => (
              <textarea
                id={id}
                class="maker-code"
                rows={8}
                spellcheck={false}
                value={order}
                onInput={({ currentTarget }) => takeAll(also.with(at, currentTarget.value))}
                {...described}
              />
            )}
          </Field>
        </Part>
      ))}
      <Add
        word="page-maker-add-order"
        off={also.length >= MOST}
        onClick={() => takeAll([...also, making.draft.value?.programs[puzzle.program] ?? ""])}
      />
    </>
  );
}
