/** Colours as #rrggbb and as the numbers of red, green and blue. */

/** The numbers of a colour #rrggbb, 0 to 255. */
export function partsOf(colour: string): number[] {
  return [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16));
}

/** The colour #rrggbb of three numbers, which may be out of range; null if one is not known. */
export function colourOf(parts: readonly (number | null)[]): string | null {
  const known = parts.filter((part) => part !== null);
  if (known.length < parts.length) return null;
  const digits = known.map((part) => {
    const whole = Math.round(Math.min(255, Math.max(0, part)));
    return whole.toString(16).padStart(2, "0");
  });
  return `#${digits.join("")}`;
}
