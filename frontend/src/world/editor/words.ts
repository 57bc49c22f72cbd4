/** Things in words: for the list, and for those who do not see the plan. */

import type { WorldValues } from "../description";
import { defaultsOf } from "./fields";
import { hasPath, listOf, placeOf, type Ref, type Sort, type Thing } from "./things";
import { t } from "../../i18n";

/** What a thing is called: "Box 2", "Box 3: bench", "Face 1: joy". */
export function nameOf(world: WorldValues, { sort, index }: Ref): string {
  const thing = listOf(world, sort)[index] ?? {};
  const numbered = t("editor.numbered", { sort: t(`editor.sort.${sort}`), number: index + 1 });
  const own = ownNameOf(sort, thing);
  return own ? t("editor.named", { sort: numbered, name: own }) : numbered;
}

/** What tells it from others of its sort. */
function ownNameOf(sort: Sort, thing: Thing): string {
  if (sort === "face") return t(`world.emotion.${String(thing.emotion)}`);
  if (sort === "tag" || sort === "visit") return t("editor.number", { number: Number(thing.id) });
  return thing.name === undefined || thing.name === defaultsOf(sort).name ? "" : String(thing.name);
}

/** Its name, where it is and where it looks. */
export function thingInWords(world: WorldValues, ref: Ref): string {
  const [x, y] = placeOf(world, ref);
  const thing = listOf(world, ref.sort)[ref.index] ?? {};
  const place = t("editor.at", { name: nameOf(world, ref), x: Math.round(x), y: Math.round(y) });
  const heading = hasPath(thing) ? (thing.start as number[])[2] : thing.heading;
  return heading === undefined ? place : t("editor.looking", { place, degrees: Math.round(Number(heading)) });
}
