/** Numbers between 0 and 1 that look random and are the same in every run. */
export function numbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state * 48_271) % 2_147_483_647;
    return state / 2_147_483_647;
  };
}

/** One of some things. */
export function pick<T>(random: () => number, things: readonly T[]): T {
  return things[Math.floor(random() * things.length)] as T;
}

/** A text of some lines, made of few letters so that parts of it repeat. */
export function text(random: () => number, longest = 40): string {
  return Array.from({ length: Math.floor(random() * longest) }, () => pick(random, ["a", "b", " ", "\n"])).join("");
}
