/** How wide the tiles of a class are, so that all of them are on the screen. */

import { useSignal } from "@preact/signals";
import { useLayoutEffect } from "preact/hooks";

/** px between tiles, and below the last ones; as in `wall.css`. */
const GAP = 6;
const MARGIN = 8;
/** The height of a picture as a share of its width. */
const PICTURE = 226 / 332;
/** px below the picture: the state is beside the name, or in a tile narrower than `ONE_LINE` below it. */
const WORDS = 44;
const WORDS_BELOW = 56;
const ONE_LINE = 190;
/** px: in a narrower tile, the state could not be read. */
const NARROWEST = 112;

/** The fewest columns with which all tiles are in this area (px); undefined if they would be too narrow. */
export function columnsFor(count: number, width: number, height: number): number | undefined {
  for (let columns = 1; columns <= count; columns++) {
    const tile = (width + GAP) / columns - GAP;
    if (tile < NARROWEST) return undefined;
    const rows = Math.ceil(count / columns);
    const words = tile < ONE_LINE ? WORDS_BELOW : WORDS;
    if (rows * (tile * PICTURE + words + GAP) - GAP <= height) return columns;
  }
  return undefined;
}

/** The columns for so many tiles, in the window as it is now. */
export function useColumns(grid: { readonly current: HTMLElement | null }, count: number): number | undefined {
  const columns = useSignal<number | undefined>(undefined);
  useLayoutEffect(() => {
    const measure = () => {
      if (!grid.current) return;
      const { top, width } = grid.current.getBoundingClientRect();
      columns.value = columnsFor(count, width, innerHeight - (top + scrollY) - MARGIN);
    };
    const sizes = new ResizeObserver(measure);
    if (grid.current) sizes.observe(grid.current);
    addEventListener("resize", measure);
    measure();
    return () => {
      sizes.disconnect();
      removeEventListener("resize", measure);
    };
  }, [count]);
  return columns.value;
}
