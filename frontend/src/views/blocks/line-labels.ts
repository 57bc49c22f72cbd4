/** A sentence in the palette, in as many lines as it needs: Blockly's labels have one. */

/** The kind of a label that another line follows; `lines.ts` says how far apart they are. */
export const LINE = "lb_line";

/** Letters in a line of the narrowest palette. */
const LONGEST = 30;

/** The labels of a sentence, one for each line. */
export function labelsOf(sentence: string): { kind: string; text: string }[] {
  const lines = linesOf(sentence);
  // The last one keeps its distance from the blocks below it.
  return lines.map((text, at) => ({ kind: at + 1 < lines.length ? LINE : "label", text }));
}

function linesOf(sentence: string): string[] {
  const lines: string[] = [];
  for (const word of sentence.split(" ")) {
    const longer = `${lines.at(-1) ?? ""} ${word}`;
    if (lines.length && longer.length <= LONGEST) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}
