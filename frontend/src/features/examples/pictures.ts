/** Pictures of the examples, each of its own world and run; `scripts/pictures` takes them. */

const ADDRESSES = import.meta.glob<string>("./pictures/*.webp", { eager: true, query: "?url", import: "default" });

/** The address of an example's picture; undefined for an example of a plugin. */
export function pictureOf(example: string): string | undefined {
  return ADDRESSES[`./pictures/${example}.webp`];
}
