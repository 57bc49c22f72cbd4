/** A text of the program with its numbered lines, the marked one, and the values beside them. */

import { usePage } from "../../model/page";
import type { Notation } from "../../protocol/messages";

interface Props {
  readonly notation: Notation;
  /** The block of the marked line. */
  readonly marked: string | null;
}

export function Texts({ notation, marked }: Props) {
  const { program, running } = usePage().context;
  const { places } = program.state.value;
  const lines = program.state.value[notation].trimEnd().split("\n");
  const column = notation === "blocktext" ? 1 : 3;
  const lineOf = (block: string | null) => Number(places.find(([id]) => id === block)?.[column] ?? 0);
  const now = lineOf(marked);
  const values = running.values.value.map(({ block, name, value }) => ({
    line: lineOf(block),
    text: name ? `${name} = ${value}` : value,
  }));
  return (
    <ol class="take-home-text">
      {lines.map((line, index) => (
        <li key={index} aria-current={index + 1 === now ? "step" : undefined}>
          <code>{line || " "}</code>
          {values
            .filter((one) => one.line === index + 1)
            .map(({ text }) => (
              <span key={text} class="take-home-value">
                {text}
              </span>
            ))}
        </li>
      ))}
    </ol>
  );
}
