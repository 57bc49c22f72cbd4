/** The values beside the lines and blocks of the program, at the moment that is shown. */

import { t } from "../i18n";
import type { ValueThere } from "../protocol/messages";

/** The longest value that is shown beside a line, in characters. */
const LONGEST = 40;
const OUTCOMES: Readonly<Record<string, string>> = { True: "page-timeline-true", False: "page-timeline-false" };

/** The values of each block, in words; they are translated when the language changes. */
export function valuesInWords(values: readonly ValueThere[]): ReadonlyMap<string, string> {
  const found = new Map<string, string>();
  for (const one of values) {
    const before = found.get(one.block);
    found.set(one.block, before ? `${before}${one.name ? ", " : " "}${describeValue(one)}` : describeValue(one));
  }
  return found;
}

/** A condition has no name, but an outcome. */
function describeValue({ name, value }: ValueThere): string {
  if (name) return `${name} = ${value.length > LONGEST ? `${value.slice(0, LONGEST - 1)}…` : value}`;
  return `→ ${t(OUTCOMES[value] ?? value)}`;
}
