/** A line's path as a list of straight parts and curves. */

import { t } from "../../i18n";
import type { PartValues } from "../../views/world/scenery/description";
import { boundsOf } from "./fields";
import { numeric, smallButton } from "./inputs";
import type { TakeList } from "./updates";

const STRAIGHT: PartValues = { forward: 200, turn: null, radius: null };
const CURVE: PartValues = { forward: null, turn: 90, radius: 200 };

export function partList(parts: readonly PartValues[], take: TakeList<PartValues>): HTMLElement {
  const box = document.createElement("div");
  const list = document.createElement("ol");
  list.className = "points";
  list.append(...parts.map((_, i) => item(parts, i, take)));
  const straight = smallButton(t("page-editor-straight"), t("page-editor-add-straight"), () =>
    take((now) => [...now, STRAIGHT]),
  );
  const curve = smallButton(t("page-editor-curve"), t("page-editor-add-curve"), () => take((now) => [...now, CURVE]));
  const row = document.createElement("div");
  row.className = "row";
  row.append(straight, curve);
  box.append(list, row);
  return box;
}

function item(parts: readonly PartValues[], index: number, take: TakeList<PartValues>): HTMLElement {
  const part = parts[index] as PartValues;
  const keys = part.forward === null ? (["turn", "radius"] as const) : (["forward"] as const);
  const row = document.createElement("li");
  const sign = document.createElement("span");
  sign.ariaHidden = "true";
  sign.textContent = part.forward !== null ? "↑" : (part.turn ?? 0) < 0 ? "↶" : "↷";
  const inputs = keys.map((key) => {
    const [least, most] = PART_BOUNDS[key];
    const input = numeric(part[key], { least, most }, (text) =>
      take((now) => now.with(index, { ...(now[index] as PartValues), [key]: Number(text) })),
    );
    input.ariaLabel = input.title = t(`page-editor-part-${key}`, { number: index + 1 });
    input.dataset.key = `path.${index}.${key}`;
    return input;
  });
  const remove = smallButton("−", t("page-editor-remove-part", { number: index + 1 }), () =>
    take((now) => now.toSpliced(index, 1)),
  );
  remove.disabled = parts.length === 1;
  const insert = smallButton("+", t("page-editor-add-part", { number: index + 1 }), () =>
    take((now) => now.toSpliced(index + 1, 0, STRAIGHT)),
  );
  row.append(sign, ...inputs, insert, remove);
  return row;
}

const PART_BOUNDS = {
  forward: boundsOf("part", "forward"),
  turn: boundsOf("part", "turn"),
  radius: boundsOf("part", "radius"),
} as const;
