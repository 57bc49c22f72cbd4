/** The palette of objects for a world. */

import { effect } from "@preact/signals";
import { t } from "../../i18n";
import type { Island } from "../../ui/island";
import type { Draft } from "./drafts";
import type { Sort } from "./sorts";
import { svg } from "./svg";
import { missing } from "./things";

/** In the order in which worlds are usually built. */
const OFFERED: readonly Sort[] = [
  "wall",
  "box",
  "cylinder",
  "line",
  "tag",
  "face",
  "light",
  "start",
  "reach",
  "follow",
  "visit",
];

const PICTURES: Readonly<Record<Sort, string>> = {
  wall: "M3 17V8h18v9zM3 12.5h18M9 8v4.500M15 12.500V17",
  box: "M4 8l8-4 8 4v8l-8 4-8-4zM4 8l8 4 8-4M12 12v8",
  cylinder: "M5 6.500C5 4.500 19 4.500 19 6.500S5 8.500 5 6.500V17.500C5 19.500 19 19.500 19 17.500V6.500",
  line: "M3 18c7 0 4-12 9-12s3 8 9 8",
  tag: "M4 4h16v16H4zM8 8h3v3H8zM13 8h3M13 11v2h3M8 13v3h3M14 16h2",
  face: "M12 4a8 8 0 1 0 0 16 8 8 0 0 0 0-16M9 10v.5M15 10v.5M8.500 14c2 2.500 5 2.500 7 0",
  light: "M9 17h6M10 20h4M8 13a5 5 0 1 1 8 0c-1 1-1 2-1 3H9c0-1 0-2-1-3",
  start: "M12 4a8 8 0 1 0 0 16 8 8 0 0 0 0-16M9 8l7 4-7 4 2-4z",
  reach: "M7 21V4M7 5h10l-3 3.500L17 12H7",
  follow: "M3 20c6 0 3-7 8-7h2M13 15V4h7l-2 2.500L20 9h-7",
  visit: "M3 8h8v8H3zM6 11h2v2H6M15 20V6h6l-2 2.500 2 2.500h-6",
};

export class Palette implements Island {
  readonly dom = document.createElement("div");
  private readonly endings: (() => void)[] = [];

  /** @param add called with the sort of object to add. */
  constructor(
    private readonly draft: Draft,
    private readonly add: (sort: Sort) => void,
  ) {
    this.dom.className = "editor-palette";
    this.dom.role = "group";
    this.endings.push(
      effect(() => {
        this.dom.ariaLabel = t("page-editor-palette");
      }),
    );
    this.dom.append(...OFFERED.map((sort) => this.button(sort)));
  }

  destroy(): void {
    for (const end of this.endings) end();
    this.dom.remove();
  }

  private button(sort: Sort): HTMLButtonElement {
    const button = document.createElement("button");
    const words = document.createElement("span");
    button.type = "button";
    button.dataset.sort = sort;
    button.append(
      svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, svg("path", { d: PICTURES[sort] })),
      words,
    );
    button.addEventListener("click", () => this.add(sort));
    this.endings.push(effect(() => this.label(button, words, sort)));
    return button;
  }

  private label(button: HTMLButtonElement, words: HTMLElement, sort: Sort): void {
    const world = this.draft.world.value;
    const lacks = world && missing(world, sort);
    words.textContent = t(`page-editor-sort-${sort}`);
    button.disabled = !world || lacks !== null;
    button.title = lacks ? t(`page-editor-needs-${lacks}`) : t("page-editor-add", { sort: words.textContent });
  }
}
