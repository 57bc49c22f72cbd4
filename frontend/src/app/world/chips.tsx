/** The values that matter most to a driver: the distance ahead, the heading and the way driven. */

import { useComputed } from "@preact/signals";
import { useMemo } from "preact/hooks";

import { t } from "../../i18n";
import { Odometer } from "../../model/odometer";
import { usePage } from "../../model/page";
import type { Sensor } from "../../protocol/messages";
import { Icon, type IconName } from "../../ui/icons";

export function Chips() {
  const { running } = usePage().context;
  const { telemetry } = running;
  // As texts, so that values that look the same are not drawn 20 times a second.
  const front = useComputed(() => frontInWords(telemetry.value?.sensors ?? []));
  const heading = useComputed(() => headingInWords(telemetry.value?.robots[0]?.heading));
  const odometer = useMemo(() => new Odometer(), []);
  const driven = useComputed(() => {
    const past = running.past.value;
    return drivenInWords(past ? lengthOf(running.wayUntil(past.time)) : odometer.read(telemetry.value));
  });
  return (
    <ul class="chips" aria-label={t("page-world-values")}>
      {front.value && <Chip icon="ruler" name={t("page-world-front")} value={front.value} />}
      {heading.value && <Chip icon="compass" name={t("page-world-heading")} value={heading.value} />}
      {driven.value && <Chip icon="trail" name={t("page-world-driven")} value={driven.value} />}
    </ul>
  );
}

function Chip({ icon, name, value }: { icon: IconName; name: string; value: string }) {
  return (
    <li class="chip">
      <Icon name={icon} />
      {name} <b>{value}</b>
    </li>
  );
}

/** The nearest reading of the sensors that look ahead; null without such sensors. */
function frontInWords(sensors: readonly Sensor[]): string | null {
  const ahead = sensors.filter(({ device, place }) => device === "DistanceSensors" && place === "front");
  const [first, ...others] = ahead;
  if (!first) return null;
  const nearest = others.reduce((least, one) => (Number(one.value) < Number(least.value) ? one : least), first);
  const value = Number(nearest.value);
  const isBeyond = nearest.highest !== undefined && value >= nearest.highest;
  return t(isBeyond ? "page-world-over-mm" : "page-world-mm", { mm: Math.round(value) });
}

function lengthOf(way: readonly (readonly [number, number])[]): number {
  return way.slice(1).reduce((sum, [x, y], index) => {
    const [fromX, fromY] = way[index] ?? [x, y];
    return sum + Math.hypot(x - fromX, y - fromY);
  }, 0);
}

function drivenInWords(way: number | null): string | null {
  return way === null ? null : t("page-world-mm", { mm: Math.round(way) });
}

function headingInWords(heading: number | undefined): string | null {
  // Not -0.
  return heading === undefined ? null : t("page-world-degrees", { degrees: Math.round(heading) + 0 });
}
