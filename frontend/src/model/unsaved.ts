/** The edits that the server has not saved yet. */

import type { View, Workspace } from "../protocol/messages";

export type Content = string | Workspace;

/** What the user has made of a view since it was saved. */
export interface UnsavedView {
  readonly view: View;
  /** The view as it was saved, and after edits of which the server may know some; the last is the newest. */
  readonly steps: readonly Content[];
}

interface Step {
  /** The number of the edit that led to it; 0 for what is saved. */
  readonly number: number;
  readonly content: Content;
}

/** More edits than the server leaves unsaved if all is well. */
const MOST_STEPS = 32;

export class Unsaved {
  private readonly views = new Map<View, readonly Step[]>();

  get drafts(): readonly UnsavedView[] {
    return [...this.views].map(([view, steps]) => ({ view, steps: kept(steps).map(({ content }) => content) }));
  }

  /** Add an edit; `before` is the view before it. */
  add(number: number, view: View, content: Content, before: Content): void {
    const [saved, ...edits] = this.views.get(view) ?? [{ number: 0, content: before }];
    if (saved) this.views.set(view, [saved, ...edits.slice(-MOST_STEPS), { number, content }]);
  }

  /** The server has saved all edits up to a number. */
  saved(number: number): void {
    for (const [view, steps] of this.views) {
      const saved = steps.filter((step) => step.number <= number).length;
      if (saved === steps.length) this.views.delete(view);
      else this.views.set(view, steps.slice(saved - 1));
    }
  }

  /** The server has answered all edits: with them, but maybe also an undo, a view shows this. */
  answered(view: View, content: Content): void {
    const steps = this.views.get(view);
    const last = steps?.at(-1);
    if (steps && last) this.views.set(view, [...steps.slice(0, -1), { number: last.number, content }]);
  }

  clear(): void {
    this.views.clear();
  }
}

/** Blocks are large, and edits of them few: what was saved and the newest are enough. */
function kept(steps: readonly Step[]): readonly Step[] {
  return typeof steps[0]?.content === "string" ? steps : [...steps.slice(0, 1), ...steps.slice(-1)];
}

/** An edit to repeat, and what it is based on. */
export interface Repeated {
  readonly view: View;
  readonly base: Content;
  readonly content: Content;
}

/**
 * A draft as an edit of the step that differs least from what the server has now, of equal ones the first.
 *
 * The server may know later edits than those that it has told the page to be saved, and may have edits of others.
 */
export function repeated({ view, steps }: UnsavedView, now: Content): Repeated {
  const distances = steps.map((step) => distance(step, now));
  const base = steps[distances.indexOf(Math.min(...distances))];
  return { view, base: base ?? now, content: steps.at(-1) ?? now };
}

/** How many lines differ, wherever they are; of blocks, whether any does. */
function distance(one: Content, other: Content): number {
  if (typeof one !== "string" || typeof other !== "string")
    return Number(JSON.stringify(one) !== JSON.stringify(other));
  const counts = new Map<string, number>();
  for (const line of one.split("\n")) counts.set(line, (counts.get(line) ?? 0) + 1);
  for (const line of other.split("\n")) counts.set(line, (counts.get(line) ?? 0) - 1);
  return [...counts.values()].reduce((sum, count) => sum + Math.abs(count), 0);
}
