/** Keeps room in the lesson for what a run will say about its goals, so that nothing moves when it does. */

import type { RefObject } from "preact";
import { useLayoutEffect } from "preact/hooks";

/** The height of a sentence about the run and of a missed goal's reason with its buttons, px. */
const ROOM = 62;
const LEAST = "--lesson-least";

/**
 * @param step the step shown; each has its own height.
 * @param hasGoals whether a run is judged.
 * @param hasResult whether the last run has missed a goal: its words then use the room.
 */
export function useRoomForResult(
  body: RefObject<HTMLElement | null>,
  step: string,
  hasGoals: boolean,
  hasResult: boolean,
): void {
  useLayoutEffect(() => {
    const pane = paneOf(body.current);
    return () => pane?.style.removeProperty(LEAST);
  }, [step, hasGoals]);
  useLayoutEffect(() => {
    const content = body.current?.parentElement ?? null;
    const pane = paneOf(content);
    if (!content || !pane || !hasGoals || hasResult) return undefined;
    // The text, its pictures and drawn programs come one after the other.
    const watcher = new ResizeObserver(() => keepRoom(pane, content));
    watcher.observe(content);
    return () => watcher.disconnect();
  }, [step, hasGoals, hasResult]);
}

function keepRoom(pane: HTMLElement, content: HTMLElement): void {
  // Measure without the kept room, which the content would fill.
  pane.style.removeProperty(LEAST);
  const below = Number.parseFloat(getComputedStyle(pane).paddingBlockEnd);
  pane.style.setProperty(LEAST, `${content.offsetTop + content.offsetHeight + below + ROOM}px`);
}

/** On a phone the lesson is a sheet, whose height nothing depends on. */
function paneOf(part: HTMLElement | null): HTMLElement | null {
  return part?.closest<HTMLElement>(".lesson-pane") ?? null;
}
