/** Blocks of a lesson's text, as a picture. */

import type { Workspace } from "../../protocol/messages";
import { IslandPlace } from "../../ui/island-place";

export function DrawnBlocks({ workspace, text }: { workspace: Workspace; text: string }) {
  const load = async () => {
    const { Drawing } = await import("./drawing");
    return new Drawing(workspace, text);
  };
  return (
    <div class="lesson-blocks">
      <IslandPlace load={load} />
    </div>
  );
}
