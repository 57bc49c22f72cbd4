/** Where the robot drove in the run that is shown, in its world from above. */

import { t } from "../../i18n";
import type { ShownHandIn } from "../../protocol/classroom";
import type { WorldValues } from "../../views/world/scenery/description";
import { WorldPlan, wayPoints } from "../class-page/plan";

/** mm: the radius of the marks of start and end. */
const START = 34;
const END = 26;
/** mm around the way that are seen: what was missed is there, too. */
const AROUND = 500;

export function DrivenWay({ shown: { world, checked }, label }: { shown: ShownHandIn; label: string }) {
  if (!world) return null;
  const values = world as unknown as WorldValues;
  const points = wayPoints(checked?.way ?? []);
  const [first, last] = [points[0], points.at(-1)];
  return (
    <figure class="hand-in-way">
      <WorldPlan world={values} label={label} area={areaAround(points, values)}>
        <polyline class="way" points={points.join(" ")} />
        {first && <circle class="start" cx={first[0]} cy={first[1]} r={START} />}
        {last && <circle class="end" cx={last[0]} cy={last[1]} r={END} />}
      </WorldPlan>
      {checked && <figcaption>{t("page-handins-seconds", { seconds: checked.seconds ?? 0 })}</figcaption>}
    </figure>
  );
}

/** The square around a way; undefined if the whole floor is hardly larger. */
export function areaAround(points: readonly (readonly [number, number])[], { floor }: WorldValues): string | undefined {
  const ends = [0, 1].map((axis) => {
    const values = points.map((point) => point[axis]!);
    return [Math.min(...values), Math.max(...values)] as const;
  });
  const side = 2 * AROUND + Math.max(...ends.map(([least, most]) => most - least));
  if (points.length === 0 || side > 0.8 * Math.min(...floor.size)) return undefined;
  const corner = ends.map(([least, most], axis) => {
    const edge = floor.size[axis]! / 2;
    return Math.min(Math.max((least + most - side) / 2, -edge), edge - side);
  });
  return `${corner.join(" ")} ${side} ${side}`;
}
