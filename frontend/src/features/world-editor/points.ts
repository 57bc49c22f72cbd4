/** The corners of a wall or of a straight-edged line, as numbers. */

import { t } from "../../i18n";
import type { XY } from "../../views/world/scenery/description";
import { numeric, smallButton } from "./inputs";
import type { TakeList } from "./updates";

const BOUNDS = { least: -5000, most: 5000 };
/** A line has at least two ends. */
const FEWEST = 2;

export function pointList(points: readonly XY[], take: TakeList<XY>): HTMLElement {
  const list = document.createElement("ol");
  list.className = "points";
  list.append(...points.map((_, i) => item(points, i, take)));
  return list;
}

function item(points: readonly XY[], index: number, take: TakeList<XY>): HTMLElement {
  const point = points[index] as XY;
  const row = document.createElement("li");
  const inputs = ([0, 1] as const).map((axis) => {
    const set = (text: string): void =>
      take((now) => now.with(index, (now[index] as XY).with(axis, Number(text)) as XY));
    const input = numeric(point[axis], BOUNDS, set);
    input.ariaLabel = input.title = t(axis ? "page-editor-corner-north" : "page-editor-corner-east", {
      number: index + 1,
    });
    input.dataset.key = `points.${index}.${axis}`;
    return input;
  });
  const remove = smallButton("−", t("page-editor-remove-corner", { number: index + 1 }), () =>
    take((now) => now.toSpliced(index, 1)),
  );
  remove.disabled = points.length <= FEWEST;
  const insert = smallButton("+", t("page-editor-add-corner", { number: index + 1 }), () =>
    take((now) => now.toSpliced(index + 1, 0, amid(now, index))),
  );
  row.append(...inputs, insert, remove);
  return row;
}

function amid(points: readonly XY[], index: number): XY {
  const [x, y] = points[index] as XY;
  const [nextX, nextY] = points[index + 1] ?? [x + 200, y];
  return [Math.round((x + nextX) / 2), Math.round((y + nextY) / 2)];
}
