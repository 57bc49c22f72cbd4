/** The speed of the simulated world, from slow motion to as fast as the computer can. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Icon } from "../../ui/icons";
import "../../ui/slider.css";

/** Times real time; null is as fast as possible. */
const SPEEDS: readonly (number | null)[] = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, null];

export function SpeedSlider() {
  const { context, controls } = usePage();
  const { speed } = context.running.state.value;
  const at = SPEEDS.indexOf(speed === undefined ? 1 : speed);
  const text = describeSpeed(SPEEDS[at] ?? null);
  return (
    <label class="speed">
      <Icon name="turtle" />
      <input
        class="slider"
        type="range"
        min={0}
        max={SPEEDS.length - 1}
        value={at}
        aria-label={t("page-bar-speed")}
        aria-valuetext={text}
        style={{ "--share": at / (SPEEDS.length - 1) }}
        onInput={({ currentTarget }) => controls.setSpeed(SPEEDS[Number(currentTarget.value)] ?? null)}
      />
      <Icon name="rabbit" />
      <output class="speed-number" aria-hidden="true">
        {text}
      </output>
    </label>
  );
}

function describeSpeed(speed: number | null): string {
  return speed === null ? t("page-bar-free") : t("page-bar-times", { factor: speed });
}
