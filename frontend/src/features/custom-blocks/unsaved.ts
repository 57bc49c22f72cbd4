/** Unsaved edits of blocks, kept by the browser while its tab is open. */

const KEY = "learnblock.ownblocks";

/** The editable parts of a custom block. */
export interface Written {
  /** The name of its file. */
  readonly name: string;
  readonly source: string;
  /** JSON; empty for the defaults. */
  readonly configuration: string;
}

type Kept = Readonly<Record<string, Written>>;

function all(): Kept {
  try {
    return JSON.parse(sessionStorage.getItem(KEY) ?? "{}") as Kept;
  } catch {
    // Storage is disabled or contains another program's value: there is nothing to restore.
    return {};
  }
}

/** The unsaved edit of a block by its saved name; a new block has the empty name. */
export function unsaved(saved: string): Written | null {
  return all()[saved] ?? null;
}

export function keep(saved: string, written: Written): void {
  sessionStorage.setItem(KEY, JSON.stringify({ ...all(), [saved]: written }));
}

export function drop(saved: string): void {
  const { [saved]: _dropped, ...others } = all();
  sessionStorage.setItem(KEY, JSON.stringify(others));
}
