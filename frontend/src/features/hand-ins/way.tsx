/** Where the robot drove in the run that is shown, in its world from above. */

import { t } from "../../i18n";
import type { ShownHandIn } from "../../protocol/classroom";
import type { WorldValues } from "../../views/world/scenery/description";
import { WorldPlan, wayPoints } from "../class-page/plan";

/** mm: the radius of the marks of start and end. */
const START = 34;
const END = 26;

export function DrivenWay({ shown: { world, checked }, label }: { shown: ShownHandIn; label: string }) {
  if (!world) return null;
  const points = wayPoints(checked?.way ?? []);
  const [first, last] = [points[0], points.at(-1)];
  return (
    <figure class="hand-in-way">
      <WorldPlan world={world as unknown as WorldValues} label={label}>
        <polyline class="way" points={points.join(" ")} />
        {first && <circle class="start" cx={first[0]} cy={first[1]} r={START} />}
        {last && <circle class="end" cx={last[0]} cy={last[1]} r={END} />}
      </WorldPlan>
      {checked && <figcaption>{t("page-handins-seconds", { seconds: checked.seconds ?? 0 })}</figcaption>}
    </figure>
  );
}
