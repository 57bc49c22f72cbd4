/** The edits that the server has not saved yet. */

import type { View, Workspace } from "../protocol/messages";

export type Content = string | Workspace;

/** What the user has made of a view. */
export interface Draft {
  readonly view: View;
  /** The view as the server has saved it. */
  readonly base: Content;
  readonly content: Content;
}

interface Edit {
  readonly number: number;
  readonly content: Content;
}

interface Edited {
  base: Content;
  edits: Edit[];
}

export class Unsaved {
  private readonly views = new Map<View, Edited>();

  /** The last edit of each view. */
  get drafts(): readonly Draft[] {
    return [...this.views].map(([view, { base, edits }]) => ({ view, base, content: last(edits).content }));
  }

  /** Add an edit; `base` is the view before it. */
  add(number: number, view: View, content: Content, base: Content): void {
    const edited = this.views.get(view) ?? { base, edits: [] };
    edited.edits.push({ number, content });
    this.views.set(view, edited);
  }

  /** The server has saved all edits up to a number. */
  saved(number: number): void {
    for (const [view, edited] of this.views) {
      const saved = edited.edits.filter((edit) => edit.number <= number);
      if (saved.length === edited.edits.length) this.views.delete(view);
      else if (saved.length > 0)
        this.views.set(view, { base: last(saved).content, edits: edited.edits.slice(saved.length) });
    }
  }

  /** The server has answered all edits: with them, but maybe also an undo, a view shows this. */
  answered(view: View, content: Content): void {
    const edited = this.views.get(view);
    if (edited) edited.edits = [{ number: last(edited.edits).number, content }];
  }

  clear(): void {
    this.views.clear();
  }
}

function last(edits: readonly Edit[]): Edit {
  const edit = edits.at(-1);
  if (!edit) throw new Error("a view without edits is saved");
  return edit;
}
