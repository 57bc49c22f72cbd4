/** A table that is updated often: changed cells flash, the others are not touched. */

import { element } from "./elements";

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

function makeRow([name, ...values]: Row): HTMLTableRowElement {
  const cells = values.map(() => element("td"));
  return element("tr", { "data-name": name }, element("th", { scope: "row" }, name), ...cells);
}

function sameRows(body: HTMLTableSectionElement, rows: readonly Row[]): boolean {
  return body.rows.length === rows.length && rows.every(([name], index) => body.rows[index]?.dataset.name === name);
}

export function createTable(): Table {
  const title = element("caption");
  const head = element("tr");
  const body = element("tbody");
  const dom = element("table", {}, title, element("thead", {}, head), body);

  function show(caption: string, columns: readonly string[], rows: readonly Row[], flashing = Infinity): void {
    dom.hidden = rows.length === 0;
    title.textContent = caption;
    if (head.textContent !== columns.join("")) {
      head.replaceChildren(...columns.map((column) => element("th", { scope: "col" }, column)));
    }
    if (!sameRows(body, rows)) body.replaceChildren(...rows.map(makeRow));
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
