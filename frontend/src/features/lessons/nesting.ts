/** How deep the pieces of a puzzle are inside of others, in the order in which a pupil has put them. */

/** Begins a part of the program of its own. */
const TOP = /^(main:|def |when )/;
/** Belongs to the block that was opened before it. */
const MIDDLE = /^(elif |else:)/;

/** The depth of each piece; a block is open until an `end`, or until the next part of the program. */
export function depths(pieces: readonly string[]): readonly number[] {
  let open = 0;
  return pieces.map((piece) => {
    if (TOP.test(piece)) open = 0;
    else if (piece === "end" || MIDDLE.test(piece)) open = Math.max(0, open - 1);
    const depth = open;
    if (piece.endsWith(":")) open += 1;
    return depth;
  });
}
