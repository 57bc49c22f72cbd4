/** The parts of a block's configuration that the form can change. */

/** Texts by upper-case language code. */
export type Words = Readonly<Record<string, string>>;

export interface Variable {
  readonly name: string;
  readonly type: string;
  readonly default?: unknown;
  readonly translate?: Words;
}

/** One block of a configuration; keys not named here are kept. */
export interface Configured {
  readonly type: string;
  readonly category: string;
  readonly name: string;
  readonly shape?: readonly string[];
  readonly languages?: Words;
  readonly tooltip?: Words;
  readonly variables?: readonly Variable[];
}

/** The blocks of a configuration; none if the JSON is not a valid configuration. */
export function blocksIn(configuration: string): readonly Configured[] {
  try {
    const found: unknown = JSON.parse(configuration);
    return (Array.isArray(found) ? found : [found]).filter(isBlock);
  } catch {
    // The user is still typing; the server reports the mistakes.
    return [];
  }
}

function isBlock(found: unknown): found is Configured {
  return typeof found === "object" && found !== null && typeof (found as Configured).name === "string";
}

/** The configuration with one block changed. */
export function withBlock(configuration: string, name: string, change: (block: Configured) => Configured): string {
  const blocks = blocksIn(configuration).map((block) => (block.name === name ? change(block) : block));
  return JSON.stringify(blocks, null, 2);
}

/** Texts with one of them set, or removed if it is empty. */
export function withWord(words: Words = {}, language: string, text: string): Words {
  const { [language]: _old, ...others } = words;
  return text ? { ...words, [language]: text } : others;
}

/** A block with one of its parameters changed. */
export function withVariable(block: Configured, name: string, change: (one: Variable) => Variable): Configured {
  return { ...block, variables: block.variables?.map((one) => (one.name === name ? change(one) : one)) ?? [] };
}

/** The languages of a block and those of the page, each once. */
export function languagesOf(
  { languages = {}, tooltip = {}, variables = [] }: Configured,
  own: readonly string[],
): string[] {
  const translated = variables.flatMap(({ translate = {} }) => Object.keys(translate));
  return [...new Set([...own, ...Object.keys(languages), ...Object.keys(tooltip), ...translated])];
}
