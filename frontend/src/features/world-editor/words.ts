/** Descriptions of objects, for the list and for screen readers. */

import { t } from "../../i18n";
import type { Sort, Thing } from "../../views/world/plan/sorts";
import { listOf, type Ref } from "../../views/world/plan/sorts";
import type { WorldValues } from "../../views/world/scenery/description";
import { defaultsOf } from "./fields";
import { hasPath, placeOf } from "./things";

/** The name of an object: "Box 2", "Box 3: bench", "Face 1: joy". */
export function nameOf(world: WorldValues, { sort, index }: Ref): string {
  const thing = listOf(world, sort)[index] ?? {};
  const numbered = t("page-editor-numbered", { sort: t(`page-editor-sort-${sort}`), number: index + 1 });
  const own = ownNameOf(sort, thing);
  return own ? t("page-editor-named", { sort: numbered, name: own }) : numbered;
}

/** The detail that distinguishes it from others of its sort. */
function ownNameOf(sort: Sort, thing: Thing): string {
  if (sort === "face") return t(`page-world-emotion-${String(thing.emotion)}`);
  if (sort === "prop" || sort === "collectable") return t(`page-world-kind-${String(thing.kind)}`);
  if (sort === "tag" || sort === "visit") return t("page-editor-number", { number: Number(thing.id) });
  return thing.name === undefined || thing.name === defaultsOf(sort).name ? "" : String(thing.name);
}

/** Its name, position and heading. */
export function thingInWords(world: WorldValues, ref: Ref): string {
  const [x, y] = placeOf(world, ref);
  const thing = listOf(world, ref.sort)[ref.index] ?? {};
  const place = t("page-editor-at", { name: nameOf(world, ref), x: Math.round(x), y: Math.round(y) });
  const heading = hasPath(thing) ? (thing.start as number[])[2] : thing.heading;
  return heading === undefined || heading === null
    ? place
    : t("page-editor-looking", { place, degrees: Math.round(Number(heading)) });
}
