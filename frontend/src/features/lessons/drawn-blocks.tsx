/** Blocks of a lesson's text, as a picture. */

import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { Workspace } from "../../protocol/messages";
import { IslandPlace } from "../../ui/island-place";
import type { Drawing } from "../../views/blocks/drawing";
import { isSameProgram } from "./same-program";

interface DrawnProps {
  readonly workspace: Workspace;
  readonly text: string;
  /** The block that is marked. */
  readonly marked?: string | null;
  /** Called with the block at which the picture is clicked; keys need another way. */
  readonly pick?: (block: string) => void;
}

export function DrawnBlocks({ workspace, text, marked = null, pick }: DrawnProps) {
  const drawing = useSignal<Drawing | null>(null);
  const shown = drawing.value;
  useEffect(() => shown?.mark(marked), [shown, marked]);
  const load = async () => {
    const [{ Drawing }, { prepare }] = await Promise.all([
      import("../../views/blocks/drawing"),
      import("../../views/blocks/prepare"),
    ]);
    prepare();
    return new Drawing(workspace, text);
  };
  const clicked = ({ clientX, clientY }: MouseEvent) => {
    const block = shown?.statementAt(clientX, clientY);
    if (block) pick?.(block);
  };
  return (
    // biome-ignore lint/a11y: beside it, a list of the lines does the same by keyboard
    <div class={pick ? "lesson-blocks picked" : "lesson-blocks"} onClick={pick && clicked}>
      <IslandPlace load={load} ready={(island) => (drawing.value = island)} />
    </div>
  );
}

interface ProgramProps {
  readonly workspace: Workspace;
  readonly text: string;
  /** What belongs to the picture. */
  readonly children?: ComponentChildren;
}

/** Blocks that a text speaks of; a sentence instead if they are the program, which is in sight already. */
export function DrawnProgram({ workspace, text, children }: ProgramProps) {
  const { context } = usePage();
  // An edit must not push the question away, so once it is a sentence, it stays one.
  const wasTheProgram = useRef(false);
  wasTheProgram.current ||= isSameProgram(text, context.program.state.value.blocktext);
  if (!wasTheProgram.current) {
    return (
      <>
        <DrawnBlocks workspace={workspace} text={text} />
        {children}
      </>
    );
  }
  return <p class="lesson-there">{t("page-lesson-program-there")}</p>;
}
