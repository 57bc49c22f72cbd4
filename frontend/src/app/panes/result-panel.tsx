/** The result of the last run. */

import type { ComponentChildren } from "preact";
import { CustomBlockLink } from "../../features/custom-blocks/link";
import { t, worldName } from "../../i18n";
import { usePage } from "../../model/page";
import { explained } from "../../model/run-error";
import { ending } from "../../model/run-result";
import type { Ended, GoalNow } from "../../protocol/messages";
import "./problems.css";

export function Result() {
  const ended = usePage().context.running.ended.value;
  if (!ended) {
    return (
      <div class="result">
        <p class="dim">{t("page-problems-no-result")}</p>
      </div>
    );
  }
  return (
    <div class="result">
      <p class={ended.ended === "error" ? "headline failed" : "headline"}>{ending(ended.ended)}</p>
      {ended.message && <p>{explained(ended.message)}</p>}
      <CustomBlockLink ended={ended} />
      <Facts ended={ended} />
    </div>
  );
}

function Facts({ ended }: { ended: Ended }) {
  const { time = 0, distance, goals = [], emotions = [], no_effect = [], trace_sha256 } = ended;
  return (
    <dl>
      <Fact name={t("page-problems-time")}>{time.toFixed(2)} s</Fact>
      {distance != null && <Fact name={t("page-problems-distance")}>{distance.toFixed(0)} mm</Fact>}
      {goals.length > 0 && (
        <Fact name={t("page-problems-goals")}>
          <Goals goals={goals} />
        </Fact>
      )}
      {emotions.length > 0 && <Fact name={t("page-problems-emotions")}>{emotions.map(emotionName).join(", ")}</Fact>}
      {no_effect.length > 0 && (
        <Fact name={t("page-problems-no-effect")}>
          <NoEffect skills={no_effect} />
        </Fact>
      )}
      {trace_sha256 && (
        <Fact name={t("page-problems-trace")}>
          <span class="hash">{trace_sha256}</span>
        </Fact>
      )}
    </dl>
  );
}

function Fact({ name, children }: { name: string; children: ComponentChildren }) {
  return (
    <>
      <dt>{name}</dt>
      <dd>{children}</dd>
    </>
  );
}

function Goals({ goals }: { goals: readonly GoalNow[] }) {
  return (
    <ul>
      {goals.map((goal) => (
        <li key={goal.name} class={goal.state}>
          {worldName(goal.name)}: {t(`page-problems-goal-${goal.state}`)}
          {goal.time !== null && ` (${goal.time.toFixed(1)} s)`}
        </li>
      ))}
    </ul>
  );
}

function NoEffect({ skills }: { skills: readonly (readonly [string, string])[] }) {
  return (
    <ul>
      {skills.map(([skill, device]) => (
        <li key={`${skill} ${device}`}>{reason(skill, device)}</li>
      ))}
    </ul>
  );
}

function reason(skill: string, device: string): string {
  if (device === "Detector:emotions") return t("page-problems-emotions-off", { skill });
  return t("page-problems-missing", { skill, device: device.replace(":", " ") });
}

const EMOTIONS = new Set(["joy", "sadness", "anger", "fear", "disgust", "surprise", "neutral"]);

function emotionName(emotion: string): string {
  return EMOTIONS.has(emotion) ? t(`page-problems-emotion-${emotion}`) : emotion;
}
