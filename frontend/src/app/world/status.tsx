/** What the run is doing, at the lower edge of the world. */

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { stateInWords } from "../../model/running";
import { Icon } from "../../ui/icons";

export function Status() {
  const { telemetry, state, scene, past, timeline, realSpeed } = usePage().context.running;
  const { variant = 0 } = scene.value ?? {};
  const factor = realSpeed.value;
  return (
    <div class="status">
      <span class="chip state" title={factor === null ? undefined : t("page-world-real-speed", { factor })}>
        {past.value
          ? t("page-timeline-looking-back", {
              seconds: past.value.time.toFixed(1),
              end: (timeline.value?.end ?? 0).toFixed(1),
            })
          : `${stateInWords(state.value)} · ${(telemetry.value?.time ?? 0).toFixed(1)} s`}
        {factor !== null && !past.value && ` · ${t("page-bar-times", { factor })}`}
      </span>
      {variant > 0 && <span class="chip state">{t("page-worlds-variant", { number: variant })}</span>}
      <Bump />
      <Link />
      {usePage().share.isFilming.value && (
        <span class="chip state filming">
          <Icon name="video" />
          {t("page-share-filming")}
        </span>
      )}
    </div>
  );
}

/** What the robot has just bumped into. */
function Bump() {
  const bump = usePage().context.running.bump.value;
  return bump && <span class="chip state bump">{t("page-world-bumped", { thing: say(bump.thing) })}</span>;
}

const LINK_WORDS = {
  disconnected: "page-link-disconnected",
  connected: "page-link-connected",
  weak: "page-link-weak",
  lost: "page-link-lost",
} as const;

/** The link to a real robot, with its battery if the robot reports it. */
function Link() {
  const link = usePage().context.running.link.value;
  if (!link || link.state === "simulated") return null;
  const { state, battery = null, quality = null } = link;
  const words = [t(LINK_WORDS[state])];
  if (battery !== null) words.push(t("page-link-battery", { volts: battery.toFixed(1) }));
  const title = quality === null ? undefined : t("page-link-quality", { percent: Math.round(100 * quality) });
  return (
    <span class={`chip state link ${state}`} title={title}>
      {words.join(", ")}
    </span>
  );
}
