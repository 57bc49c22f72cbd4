/** Blocks that were edited and not saved: kept by the browser while its tab is open. */

const KEY = "learnblock.ownblocks";

/** What a person writes of a block. */
export interface Written {
  /** Of its file. */
  readonly name: string;
  readonly source: string;
  /** JSON, or empty for nothing. */
  readonly configuration: string;
}

type Kept = Readonly<Record<string, Written>>;

function all(): Kept {
  try {
    return JSON.parse(sessionStorage.getItem(KEY) ?? "{}") as Kept;
  } catch {
    // A browser that keeps nothing, or somebody else's value: there is nothing to go on with.
    return {};
  }
}

/** What was left of the block that is saved under a name, or of a new one where that is empty. */
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
