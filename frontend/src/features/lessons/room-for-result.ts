/** Keeps room in the lesson for what a run will say about its goals, so that nothing moves when it does. */

import type { RefObject } from "preact";
import { useLayoutEffect } from "preact/hooks";

/** A sentence about the run, and a missed goal's reason with its buttons, px. */
const ROOM = 62;
const LEAST = "--lesson-least";

/**
 * @param step the shown one, which has a height of its own.
 * @param hasGoals whether a run says anything about it.
 * @param hasResult whether a run has: its words are in the room that is kept for them.
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
    const content = body.current?.parentElement;
    if (!content || !paneOf(content) || !hasGoals || hasResult) return undefined;
    // The text, its pictures and drawn programs come one after the other.
    const watcher = new ResizeObserver(() => keepRoom(content));
    watcher.observe(content);
    return () => watcher.disconnect();
  }, [step, hasGoals, hasResult]);
}

function keepRoom(content: HTMLElement): void {
  const pane = paneOf(content);
  if (!pane) return;
  // Its own height, since the content fills what is kept.
  pane.style.removeProperty(LEAST);
  const below = Number.parseFloat(getComputedStyle(pane).paddingBlockEnd);
  pane.style.setProperty(LEAST, `${content.offsetTop + content.offsetHeight + below + ROOM}px`);
}

/** On a phone the lesson is a sheet, whose height nothing depends on. */
function paneOf(part: HTMLElement | null): HTMLElement | null {
  return part?.closest<HTMLElement>(".lesson-pane") ?? null;
}
