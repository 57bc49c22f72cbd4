/** A choice of values with their words, as the properties of a field. */

export type Option = readonly [value: string, words: string];

export function choice(options: readonly Option[]) {
  const words = new Map(options);
  return {
    shape: { kind: "choice", options: [...words.keys()] } as const,
    words: (option: string) => words.get(option) ?? option,
  };
}
