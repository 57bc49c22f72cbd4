/** The values that matter most to a driver: pointed at, the world shows them; pressed, they are plotted. */

import { useComputed } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { lengthOf, type Measure, measures } from "../../model/measures";
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
      <Chip measure="front" icon="ruler" name={t("page-world-front")} value={front.value} />
      <Chip measure="heading" icon="compass" name={t("page-world-heading")} value={heading.value} />
      <Chip measure="driven" icon="trail" name={t("page-world-driven")} value={driven.value} />
    </ul>
  );
}

/** Nothing without a value. */
function Chip(props: { measure: Measure; icon: IconName; name: string; value: string | null }) {
  return props.value && <ShownChip {...props} value={props.value} />;
}

function ShownChip({ measure, icon, name, value }: { measure: Measure; icon: IconName; name: string; value: string }) {
  const { views } = usePage();
  const item = useRef<HTMLLIElement>(null);
  const point = (what: Measure | null) => views.world.value?.point(what);
  useEffect(() => () => point(null), []);
  useEffect(() => onlyInSight(item.current), []);
  return (
    <li ref={item}>
      <button
        type="button"
        class="chip value"
        title={t("page-world-plot")}
        onPointerEnter={() => point(measure)}
        onPointerLeave={() => point(null)}
        onFocus={() => point(measure)}
        onBlur={() => point(null)}
        onClick={() => views.plot(measure)}
      >
        <Icon name={icon} />
        {name} <b>{value}</b>
      </button>
    </li>
  );
}

/** Let an item take part only while its row has room for it; return how to end that. */
function onlyInSight(item: HTMLElement | null): (() => void) | undefined {
  if (!item) return;
  const watcher = new IntersectionObserver(
    ([entry]) => entry && item.classList.toggle("left-out", !entry.isIntersecting),
    { root: item.parentElement, threshold: 0.9 },
  );
  watcher.observe(item);
  return () => watcher.disconnect();
}

/** The nearest reading of the sensors that look ahead; null without such sensors. */
function frontInWords(sensors: readonly Sensor[]): string | null {
  const [first, ...others] = sensors.filter((sensor) => measures("front", sensor));
  if (!first) return null;
  const nearest = others.reduce((least, one) => (Number(one.value) < Number(least.value) ? one : least), first);
  const value = Number(nearest.value);
  const isBeyond = nearest.highest !== undefined && value >= nearest.highest;
  return t(isBeyond ? "page-world-over-mm" : "page-world-mm", { mm: Math.round(value) });
}

function drivenInWords(way: number | null): string | null {
  return way === null ? null : t("page-world-mm", { mm: Math.round(way) });
}

function headingInWords(heading: number | undefined): string | null {
  // Not -0.
  return heading === undefined ? null : t("page-world-degrees", { degrees: Math.round(heading) + 0 });
}
