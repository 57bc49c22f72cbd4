/** Where the robot drove in the run that is shown, in its world from above. */

import { useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { theme } from "../../model/preferences";
import type { ShownHandIn } from "../../protocol/classroom";
import { planOf } from "../../views/world/plan/plan";
import type { WorldValues } from "../../views/world/scenery/description";

/** mm: the margin around the floor, and the radius of the marks of start and end. */
const MARGIN = 30;
const START = 34;
const END = 26;

export function DrivenWay({ shown: { world, checked, line } }: { shown: ShownHandIn }) {
  const things = useRef<SVGGElement>(null);
  const values = world as WorldValues | null | undefined;
  useLayoutEffect(() => {
    if (values) things.current?.replaceChildren(...planOf(values));
  }, [values, theme.value]);
  if (!values) return null;
  const [width, depth] = values.floor.size;
  const size = [width + 2 * MARGIN, depth + 2 * MARGIN] as const;
  const points = pairs(checked?.way ?? []);
  const [first, last] = [points[0], points.at(-1)];
  return (
    <figure class="hand-in-way">
      <svg
        class="world-plan"
        role="img"
        aria-label={t("page-handins-way", { name: line.name })}
        viewBox={`${-size[0] / 2} ${-size[1] / 2} ${size[0]} ${size[1]}`}
      >
        <g ref={things} />
        <polyline class="way" points={points.map((point) => point.join(",")).join(" ")} />
        {first && <circle class="start" cx={first[0]} cy={first[1]} r={START} />}
        {last && <circle class="end" cx={last[0]} cy={last[1]} r={END} />}
      </svg>
      {checked && <figcaption>{t("page-handins-seconds", { seconds: checked.seconds ?? 0 })}</figcaption>}
    </figure>
  );
}

/** Points in the picture, in which y grows downwards. */
function pairs(way: readonly number[]): readonly (readonly [number, number])[] {
  const found: [number, number][] = [];
  for (let i = 0; i + 1 < way.length; i += 2) found.push([way[i]!, -way[i + 1]!]);
  return found;
}
