/** The values that matter most to the program: pointed at, the world shows them; pressed, they or the camera are shown. */

import { type ReadonlySignal, useComputed } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { FOUND, type Measure, measuresOf, pastReadingsOf, readingsOf } from "../../model/measures";
import { Odometer } from "../../model/odometer";
import { usePage } from "../../model/page";
import { arrange } from "../../model/preferences";
import type { Sensor } from "../../protocol/messages";
import { Icon, type IconName } from "../../ui/icons";
import { foundInWords, valueInWords } from "./chip-values";

/** By the type of device. */
const ICONS: Readonly<Record<string, IconName>> = {
  DistanceSensors: "ruler",
  Heading: "compass",
  Driven: "trail",
  Camera: "camera",
};

export function Chips() {
  const { program, running } = usePage().context;
  const odometer = useMemo(() => new Odometer(), []);
  const readings = useComputed(() => {
    const { value: telemetry } = running.telemetry;
    const { value: past } = running.past;
    if (!telemetry) return [];
    return past ? pastReadingsOf(telemetry, running.wayUntil(past.time)) : readingsOf(telemetry, odometer);
  });
  // As a text, so that an edit that asks for nothing else draws nothing.
  const shown = useComputed(() => measuresOf(program.state.value.asked).join());
  return (
    <ul class="chips" aria-label={t("page-world-values")}>
      {shown.value.split(",").map((measure) => (
        <Chip key={measure} measure={measure} readings={readings} />
      ))}
    </ul>
  );
}

/** Nothing without a value. */
function Chip({ measure, readings }: { measure: Measure; readings: ReadonlySignal<readonly Sensor[]> }) {
  // As a text, so that values that look the same are not drawn 20 times a second.
  const { running } = usePage().context;
  const value = useComputed(() =>
    measure === FOUND ? foundInWords(running.telemetry.value?.found) : valueInWords(measure, readings.value),
  );
  return value.value && <ShownChip measure={measure} value={value.value} />;
}

function ShownChip({ measure, value }: { measure: Measure; value: string }) {
  const { views } = usePage();
  const [device = "", place = ""] = measure.split(":");
  const item = useRef<HTMLLIElement>(null);
  const point = (what: Measure | null) => views.world.value?.point(what);
  useEffect(() => () => point(null), []);
  useEffect(() => onlyInSight(item.current), []);
  return (
    <li ref={item}>
      <button
        type="button"
        class="chip value"
        title={t(measure === FOUND ? "page-shell-camera" : "page-world-plot")}
        onPointerEnter={() => point(measure)}
        onPointerLeave={() => point(null)}
        onFocus={() => point(measure)}
        onBlur={() => point(null)}
        onClick={() => (measure === FOUND ? arrange({ camera: true }) : views.plot(measure))}
      >
        <Icon name={ICONS[device] ?? "sense"} />
        {t("page-sensors-measure", { device, place })} <b>{value}</b>
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
