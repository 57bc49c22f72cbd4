/** A table that is updated often: changed cells flash, the others are not touched. */

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
  if (jumping) cells.push(element("td", { class: "jumps" }, jumper(-1, name, jumping), jumper(1, name, jumping)));
  const head = element("th", { scope: "row" }, asking ? asker(name, asking) : name);
  return element("tr", { "data-name": name }, head, ...cells);
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

export function createTable(asking: Asking | null = null, jumping: Jumping | null = null): Table {
  const title = element("caption");
  const head = element("tr");
  const body = element("tbody");
  const dom = element("table", {}, title, element("thead", {}, head), body);

  function show(caption: string, named: readonly string[], rows: readonly Row[], flashing = Infinity): void {
    const columns = jumping ? [...named, jumping.heading()] : named;
    dom.hidden = rows.length === 0;
    title.textContent = caption;
    if (head.textContent !== columns.join("")) {
      head.replaceChildren(...columns.map((column) => element("th", { scope: "col" }, column)));
    }
    if (!sameRows(body, rows)) body.replaceChildren(...rows.map((row) => makeRow(row, asking, jumping)));
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
