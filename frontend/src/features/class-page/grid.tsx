/** The tiles of the wall. It is one stop of the Tab key; arrows and letters lead from tile to tile. */

import { type Signal, useSignal } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import type { Seat, Wall } from "../../protocol/classroom";
import { useColumns } from "./fitting";
import type { Drawing } from "./small-world";
import type { ClassStream } from "./stream";
import { Tile } from "./tile";

export interface GridProps {
  readonly stream: ClassStream;
  readonly drawing: Drawing;
  readonly wall: Wall;
  /** In their order. */
  readonly seats: readonly Seat[];
  /** Whether the teacher is at the tiles, which then keep their places. */
  readonly isBusy: Signal<boolean>;
  readonly hint: (pupil: string) => void;
  readonly handOut: (pupil: string) => void;
  readonly remove: (seats: readonly Seat[]) => void;
}

export function Grid({ stream, drawing, wall, seats, isBusy, hint, handOut, remove }: GridProps) {
  const current = useSignal("");
  const grid = useRef<HTMLDivElement>(null);
  // A filter does not change the size of the tiles.
  const pupils = wall.pupils?.length ?? seats.length;
  const columns = useColumns(grid, pupils);
  const isThere = seats.some(({ id }) => id === current.value);
  const first = isThere ? current.value : (seats[0]?.id ?? "");
  const pressed = (event: KeyboardEvent) => {
    const tile = tileAt(event.target);
    const seat = seats.find(({ id }) => id === tile?.dataset.pupil);
    if (tile && seat && grid.current && press(grid.current, tile, event, () => hint(seat.id))) event.preventDefault();
  };
  const look = () => {
    isBusy.value = grid.current?.matches(":hover, :focus-within") ?? false;
  };
  useLayoutEffect(look, []);
  return (
    <div
      ref={grid}
      {...tilesFor(pupils, columns)}
      role="grid"
      aria-label={t("page-class-pupils")}
      aria-describedby="wall-keys"
      data-wall-region
      onKeyDown={pressed}
      onFocusIn={({ target }) => {
        const tile = tileAt(target);
        if (tile) current.value = tile.dataset.pupil ?? "";
        look();
      }}
      onFocusOut={() => queueMicrotask(look)}
      onPointerEnter={look}
      onPointerLeave={look}
    >
      {seats.map((seat) => (
        <Tile
          key={seat.id}
          stream={stream}
          drawing={drawing}
          seat={seat}
          scale={pupils <= LARGE ? 2 : 1}
          isProjected={wall.projected === seat.id}
          isCurrent={seat.id === first}
          hint={() => hint(seat.id)}
          handOut={() => handOut(seat.id)}
          remove={() => remove([seat])}
        />
      ))}
    </div>
  );
}

/** The most tiles in a row for which few pupils get large ones, by their number. */
const FEW = [1, 2, 3, 2, 3, 3, 4, 4, 5, 5, 4, 4] as const;

/** For so many pupils the pictures are drawn twice as large. */
const LARGE = 6;

/** As large as the screen allows; so many that they would be too small go on below it. */
function tilesFor(count: number, fitting: number | undefined): { readonly class: string; readonly style?: string } {
  const columns = FEW[count - 1];
  if (!columns) return fitting ? { class: "tiles fitting", style: `--columns: ${fitting}` } : { class: "tiles" };
  return {
    class: count > LARGE ? "tiles few" : "tiles few large",
    style: `--columns: ${columns}; --rows: ${Math.ceil(count / columns)}`,
  };
}

function tileAt(target: EventTarget | null): HTMLElement | null {
  return target instanceof Element ? target.closest<HTMLElement>(".tile") : null;
}

/** Do what a key does at a tile; return whether it does something. */
function press(grid: HTMLElement, tile: HTMLElement, event: KeyboardEvent, hint: () => void): boolean {
  const { key } = event;
  if (event.target !== tile) {
    if (key === "Escape") tile.focus();
    return false;
  }
  if (event.ctrlKey || event.altKey || event.metaKey) return false;
  if (key === "Enter") open(tile, "a");
  else if (key === "ContextMenu" || (key === "F10" && event.shiftKey)) open(tile, ".menu > button");
  else if (key.toLowerCase() === "h") hint();
  else return move(grid, tile, key);
  return true;
}

function open(tile: HTMLElement, button: string): void {
  tile.querySelector<HTMLElement>(button)?.click();
}

/** Move to another tile by a key; return whether the key does so. */
function move(grid: HTMLElement, tile: HTMLElement, key: string): boolean {
  const tiles = [...grid.querySelectorAll<HTMLElement>(".tile")];
  const at = tiles.indexOf(tile);
  const columns = Math.max(1, tiles.filter(({ offsetTop }) => offsetTop === tiles[0]?.offsetTop).length);
  const targets: Readonly<Record<string, number>> = {
    ArrowRight: at + 1,
    ArrowLeft: at - 1,
    ArrowDown: at + columns,
    ArrowUp: at - columns,
    Home: 0,
    End: tiles.length - 1,
  };
  const target = key in targets ? tiles[targets[key]!] : named(tiles, at, key);
  target?.focus();
  return key in targets || target !== undefined;
}

/** The next tile whose name begins with a letter. */
function named(tiles: readonly HTMLElement[], at: number, key: string): HTMLElement | undefined {
  if ([...key].length !== 1 || key === " ") return undefined;
  const begins = (tile: HTMLElement) =>
    tile.querySelector(".tile-name")?.textContent?.toLowerCase().startsWith(key.toLowerCase());
  return [...tiles.slice(at + 1), ...tiles.slice(0, at)].find(begins);
}
