/** A table that is updated often: changed cells flash, the others are not touched. */

import { t } from "../../i18n";
import { icon } from "../../ui/icons";
import { button, element } from "./elements";

export type Row = readonly [name: string, ...values: string[]];

export interface Table {
  readonly dom: HTMLTableElement;
  /** Changes in `flashing` columns, from 1, make cells flash; by default all. */
  show(caption: string, columns: readonly string[], rows: readonly Row[], flashing?: number): void;
}

function flash(cell: HTMLElement): void {
  cell.classList.remove("changed");
  // The animation restarts only if the browser has rendered without the class.
  void cell.offsetWidth;
  cell.classList.add("changed");
}

function write(cell: HTMLElement, text: string, flashes: boolean): void {
  if (cell.textContent === text) return;
  const before = cell.textContent;
  cell.textContent = text;
  cell.title = text;
  if (before && flashes) flash(cell);
}

/** What a click on a row's name does. */
export interface Asking {
  readonly title: () => string;
  ask(name: string): void;
}

/** Buttons that go to where a row changed, before and after the moment that is shown. */
export interface Jumping {
  readonly title: (by: -1 | 1, name: string) => string;
  /** The heading of their column. */
  readonly heading: () => string;
  go(by: -1 | 1, name: string): void;
}

function makeRow([name, ...values]: Row, asking: Asking | null, jumping: Jumping | null): HTMLTableRowElement {
  const cells = values.map(() => element("td"));
  const isPart = partOf(name) !== "";
  if (jumping) {
    const jumps = isPart ? [] : [jumper(-1, name, jumping), jumper(1, name, jumping)];
    cells.push(element("td", { class: "jumps" }, ...jumps));
  }
  const head = element("th", { scope: "row" }, asking && !isPart ? asker(name, asking) : lastName(name));
  head.style.setProperty("--depth", `${name.split(".").length - 1}`);
  return element("tr", { "data-name": name }, head, ...cells);
}

/** The object that a row is a part of: `driver` for `driver.speed`; empty for a variable. */
function partOf(name: string): string {
  return name.slice(0, Math.max(0, name.lastIndexOf(".")));
}

function lastName(name: string): string {
  return name.slice(name.lastIndexOf(".") + 1);
}

function asker(name: string, asking: Asking): HTMLButtonElement {
  const made = button("ask", () => asking.ask(name));
  made.append(name, icon("why"));
  made.title = asking.title();
  return made;
}

function jumper(by: -1 | 1, name: string, jumping: Jumping): HTMLButtonElement {
  const made = button("jump", () => jumping.go(by, name));
  made.append(icon(by < 0 ? "lineBefore" : "lineAfter"));
  made.title = made.ariaLabel = jumping.title(by, name);
  return made;
}

function sameRows(body: HTMLTableSectionElement, rows: readonly Row[]): boolean {
  return body.rows.length === rows.length && rows.every(([name], index) => body.rows[index]?.dataset.name === name);
}

/** Shows and hides the rows of an object's parts. */
class Parts {
  private readonly opened = new Set<string>();

  constructor(private readonly body: HTMLTableSectionElement) {}

  show(): void {
    for (const row of this.body.rows) {
      const name = row.dataset.name ?? "";
      row.hidden = !this.isShown(name);
      row.querySelector(".open-object")?.setAttribute("aria-expanded", `${this.opened.has(name)}`);
    }
  }

  /** A button that opens an object, or closes it. */
  opener(name: string): HTMLButtonElement {
    const made = button("open-object", () => {
      if (!this.opened.delete(name)) this.opened.add(name);
      this.show();
    });
    made.append(icon("lineAfter"));
    made.title = made.ariaLabel = t("page-variables-open", { name });
    return made;
  }

  private isShown(name: string): boolean {
    const object = partOf(name);
    return !object || (this.opened.has(object) && this.isShown(object));
  }
}

export function createTable(asking: Asking | null = null, jumping: Jumping | null = null): Table {
  const title = element("caption");
  const head = element("tr");
  const body = element("tbody");
  const dom = element("table", {}, title, element("thead", {}, head), body);
  const parts = new Parts(body);

  function makeRows(rows: readonly Row[]): void {
    const objects = new Set(rows.map(([name]) => partOf(name)));
    const made = rows.map((row) => {
      const [name] = row;
      const one = makeRow(row, asking, jumping);
      if (objects.has(name)) one.cells[0]?.prepend(parts.opener(name));
      return one;
    });
    body.replaceChildren(...made);
    parts.show();
  }

  function show(caption: string, named: readonly string[], rows: readonly Row[], flashing = Infinity): void {
    const columns = jumping ? [...named, jumping.heading()] : named;
    dom.hidden = rows.length === 0;
    title.textContent = caption;
    if (head.textContent !== columns.join("")) {
      head.replaceChildren(...columns.map((column) => element("th", { scope: "col" }, column)));
    }
    if (!sameRows(body, rows)) makeRows(rows);
    rows.forEach(([, ...values], index) => {
      const cells = body.rows[index]?.cells;
      values.forEach((value, column) => {
        const cell = cells?.[column + 1];
        if (cell) write(cell, value, column < flashing);
      });
    });
  }

  return { dom, show };
}
