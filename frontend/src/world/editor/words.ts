/** Things in words: for the list, and for those who do not see the plan. */

import type { WorldValues } from "../description";
import { hasPath, listOf, placeOf, type Ref } from "./things";
import { t } from "../../i18n";

/** What a thing is called: "Box "bench"", "Tag 3". */
export function nameOf(world: WorldValues, { sort, index }: Ref): string {
  const thing = listOf(world, sort)[index] ?? {};
  const name = sort === "tag" || sort === "visit" ? thing.id : (thing.name ?? thing.emotion ?? index + 1);
  const own = sort === "face" ? t(`world.emotion.${String(name)}`) : String(name);
  return t("editor.named", { sort: t(`editor.sort.${sort}`), name: own });
}

/** Its name, where it is and where it looks. */
export function thingInWords(world: WorldValues, ref: Ref): string {
  const [x, y] = placeOf(world, ref);
  const thing = listOf(world, ref.sort)[ref.index] ?? {};
  const place = t("editor.at", { name: nameOf(world, ref), x: Math.round(x), y: Math.round(y) });
  const heading = hasPath(thing) ? (thing.start as number[])[2] : thing.heading;
  return heading === undefined ? place : t("editor.looking", { place, degrees: Math.round(Number(heading)) });
}
