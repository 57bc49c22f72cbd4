/** The palette of objects for a world. */

import { effect, type ReadonlySignal } from "@preact/signals";
import { t } from "../../i18n";
import { theme } from "../../model/preferences";
import { Cleanup } from "../../ui/cleanup";
import type { Island } from "../../ui/island";
import type { Sort } from "../../views/world/plan/sorts";
import { svg } from "../../views/world/plan/svg";
import type { WorldValues } from "../../views/world/scenery/description";
import { colourOf, legible } from "../../views/world/scenery/floor-colours";
import { paletteOf } from "../../views/world/scenery/palette";
import { type Carried, carries } from "./carrying";
import { missing } from "./creating";
import { GROUPS, isSameOffer, type Offer, wordOf } from "./offers";
import { PIXELS, Portraits } from "./portraits";
import type { WorldEdit } from "./world-edit";

const PICTURES: Readonly<Record<Sort, string>> = {
  wall: "M3 17V8h18v9zM3 12.5h18M9 8v4.500M15 12.500V17",
  box: "M4 8l8-4 8 4v8l-8 4-8-4zM4 8l8 4 8-4M12 12v8",
  cylinder: "M5 6.500C5 4.500 19 4.500 19 6.500S5 8.500 5 6.500V17.500C5 19.500 19 19.500 19 17.500V6.500",
  prop: "M12 3 6.500 11H9l-4 6h14l-4-6h2.500zM12 17v4",
  line: "M3 18c7 0 4-12 9-12s3 8 9 8",
  tag: "M4 4h16v16H4zM8 8h3v3H8zM13 8h3M13 11v2h3M8 13v3h3M14 16h2",
  face: "M12 4a8 8 0 1 0 0 16 8 8 0 0 0 0-16M9 10v.5M15 10v.5M8.500 14c2 2.500 5 2.500 7 0",
  light: "M9 17h6M10 20h4M8 13a5 5 0 1 1 8 0c-1 1-1 2-1 3H9c0-1 0-2-1-3",
  start: "M12 4a8 8 0 1 0 0 16 8 8 0 0 0 0-16M9 8l7 4-7 4 2-4z",
  reach: "M7 21V4M7 5h10l-3 3.500L17 12H7",
  follow: "M3 20c6 0 3-7 8-7h2M13 15V4h7l-2 2.500L20 9h-7",
  visit: "M3 8h8v8H3zM6 11h2v2H6M15 20V6h6l-2 2.500 2 2.500h-6",
  tour: "M5 19a2 2 0 1 0 .1 0M7 17l4-6M12 10a2 2 0 1 0-.1 0M14 9l4 6M19 19a2 2 0 1 0-.1 0",
  stop: "M8 3h8l5 5v8l-5 5H8l-5-5V8zM9 9h6v6H9z",
  show: "M12 4a8 8 0 1 0 0 16 8 8 0 0 0 0-16M9 10v.5M15 10v.5M8.500 14h7",
  collect: "M12 3l2.500 6 6.500.500-5 4 1.600 6.500-5.600-3.500L6.400 20 8 13.500l-5-4 6.500-.500z",
  gates: "M4 20V6h16v14M4 10h16M9 20v-6h6v6",
  score: "M4 6h16v12H4zM8 10v4M12 10v4h3M15 10h-3",
  zone: "M12 6c5 0 9 2.500 9 6s-4 6-9 6-9-2.500-9-6 4-6 9-6",
  switch: "M12 9c4 0 7 1.500 7 3.500S16 16 12 16s-7-1.500-7-3.500S8 9 12 9M12 5v4",
  gate: "M5 20V5h14v15M5 9h14",
  door: "M6 20V4h12v16zM14 12v1",
  mover: "M12 5a7 7 0 1 0 .1 0M9 10v1M15 10v1",
  collectable: "M12 3l2.500 6 6.500.500-5 4 1.600 6.500-5.600-3.500L6.400 20 8 13.500l-5-4 6.500-.500z",
  avoid: "M14 9h7v7h-7zM3 20c9 0 1-14 9-15M10 3l3 2-2 3",
};

/** Goals that are nothing in the world: their sign is their picture. */
const SIGNS: ReadonlySet<Sort> = new Set(["show", "avoid", "collect", "gates", "score"]);

export class ThingPalette implements Island {
  readonly dom = document.createElement("div");
  private readonly cleanup = new Cleanup();
  private readonly portraits = new Map<HTMLButtonElement, Offer>();
  private painter: Portraits | null = null;

  /**
   * @param chosen is what is about to be put into the world.
   * @param choose is called with what to add.
   * @param carried is called when a button is dragged.
   */
  constructor(
    private readonly draft: WorldEdit,
    private readonly chosen: ReadonlySignal<Offer | null>,
    private readonly choose: (offer: Offer) => void,
    private readonly carried: (offer: Offer) => Carried,
  ) {
    this.dom.className = "editor-palette";
    this.dom.role = "group";
    this.cleanup.add(
      effect(() => {
        this.dom.ariaLabel = t("page-editor-palette");
      }),
    );
    for (const [group, offers] of Object.entries(GROUPS)) this.dom.append(...this.group(group, offers));
    this.cleanup.add(effect(() => this.paint(this.draft.world.value?.theme, theme.value)));
  }

  focus(offer: Offer): void {
    for (const [button, other] of this.portraits) if (isSameOffer(offer, other)) button.focus();
  }

  destroy(): void {
    this.cleanup.dispose();
    this.painter?.destroy();
    this.dom.remove();
  }

  private group(name: string, offers: readonly Offer[]): HTMLElement[] {
    const title = document.createElement("h3");
    const tiles = document.createElement("div");
    tiles.append(...offers.map((offer) => this.button(offer)));
    this.cleanup.add(
      effect(() => {
        title.textContent = t(`page-editor-group-${name}`);
      }),
    );
    return [title, tiles];
  }

  private button(offer: Offer): HTMLButtonElement {
    const button = document.createElement("button");
    const words = document.createElement("span");
    const { sort, kind } = offer;
    button.type = "button";
    button.dataset.sort = kind ?? sort;
    button.append(
      svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, svg("path", { d: PICTURES[sort] })),
      words,
    );
    this.portraits.set(button, offer);
    carries(button, this.carried(offer));
    button.addEventListener("click", () => this.choose(offer));
    this.cleanup.add(effect(() => this.label(button, words, offer)));
    return button;
  }

  private label(button: HTMLButtonElement, words: HTMLElement, offer: Offer): void {
    const world = this.draft.world.value;
    const lacks = world && missing(world, offer.sort);
    words.textContent = t(wordOf(offer));
    button.ariaPressed = String(isSameOffer(this.chosen.value, offer));
    button.disabled = !world || lacks !== null;
    button.title = lacks ? t(`page-editor-needs-${lacks}`) : t("page-editor-add", { sort: words.textContent });
  }

  /** Draw everything in the colours of a world's theme, if the browser can. */
  private paint(..._colours: readonly unknown[]): void {
    this.painter?.destroy();
    this.painter = null;
    const world = this.draft.world.peek();
    if (!world) return;
    this.dom.style.setProperty("--floor", floorColour(world));
    try {
      this.painter = new Portraits(world);
    } catch (error) {
      console.warn(error);
      return;
    }
    for (const [button, offer] of this.portraits) {
      if (!SIGNS.has(offer.sort)) this.painter.draw(offer, canvasOf(button));
    }
  }
}

/** The colour of the floor on which everything is shown: black lines are legible on it. */
function floorColour({ theme: place, floor }: WorldValues): string {
  const palette = legible(paletteOf(place, theme.peek()), [{ colour: "black" }]);
  return colourOf({ ...floor, colour: "white" }, palette);
}

/** The canvas in a button, which replaces its sign when it is drawn on. */
function canvasOf(button: HTMLButtonElement): HTMLCanvasElement {
  const before = button.querySelector("canvas");
  if (before) return before;
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = PIXELS;
  canvas.ariaHidden = "true";
  button.querySelector("svg")?.replaceWith(canvas);
  return canvas;
}
