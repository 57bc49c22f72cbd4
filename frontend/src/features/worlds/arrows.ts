/** Moves the focus among cards with the arrow keys, in two dimensions and across groups. */

interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** Sideways distance counts more, so that a column is kept. */
const ASIDE = 3;
const KEYS: Readonly<Record<string, (from: Box, to: Box) => number>> = {
  ArrowRight: (from, to) => (inRow(from, to) ? to.left - from.left : 0),
  ArrowLeft: (from, to) => (inRow(from, to) ? from.left - to.left : 0),
  ArrowDown: (from, to) => away(to.top - from.top, from, to),
  ArrowUp: (from, to) => away(from.top - to.top, from, to),
};

/** Move the focus from a card to its neighbour; return whether there is one. */
export function moveAmong(cards: readonly HTMLElement[], from: Element | null, key: string): boolean {
  const boxes = cards.map((card) => card.getBoundingClientRect());
  const target = cards[neighbour(boxes, cards.indexOf(from as HTMLElement), key)];
  target?.focus();
  return target !== undefined;
}

/** The number of the nearest box in the direction of a key; -1 if there is none. */
export function neighbour(boxes: readonly Box[], at: number, key: string): number {
  const [distance, from] = [KEYS[key], boxes[at]];
  if (!distance || !from) return -1;
  const distances = boxes.map((box, i) => (i === at ? 0 : distance(from, box)));
  const least = Math.min(...distances.filter((one) => one > 0));
  return distances.indexOf(least);
}

function inRow(from: Box, to: Box): boolean {
  return to.top < from.bottom && to.bottom > from.top;
}

function away(distance: number, from: Box, to: Box): number {
  // Cards of a row may differ in height by a pixel.
  return distance > 2 ? distance + ASIDE * Math.abs(to.left - from.left) : 0;
}
