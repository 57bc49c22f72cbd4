/** Blocks of a lesson's text, as a picture. */

import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { Workspace } from "../../protocol/messages";
import { IslandPlace } from "../../ui/island-place";
import { isSameProgram } from "./same-program";

export function DrawnBlocks({ workspace, text }: { workspace: Workspace; text: string }) {
  const load = async () => {
    const [{ Drawing }, { prepare }] = await Promise.all([
      import("../../views/blocks/drawing"),
      import("../../views/blocks/prepare"),
    ]);
    prepare();
    return new Drawing(workspace, text);
  };
  return (
    <div class="lesson-blocks">
      <IslandPlace load={load} />
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
