/** What came of the last run. */

import type { ComponentChildren } from "preact";

import { t } from "../../i18n";
import type { Ended, GoalNow } from "../../messages";
import { explained } from "../../runerror";
import { said } from "../../sentences";
import { usePage } from "../page";
import { ending } from "../result";
import { OwnBlockLink } from "./ownblocklink";
import "./problems.css";

export function Result() {
  const ended = usePage().context.running.ended.value;
  if (!ended) {
    return (
      <div class="result">
        <p class="dim">{t("problems.noResult")}</p>
      </div>
    );
  }
  return (
    <div class="result">
      <p class={ended.ended === "error" ? "headline failed" : "headline"}>{ending(ended.ended)}</p>
      {ended.message && <p>{explained(ended.message)}</p>}
      <OwnBlockLink ended={ended} />
      <Facts ended={ended} />
    </div>
  );
}

function Facts({ ended }: { ended: Ended }) {
  const { time = 0, distance, goals = [], emotions = [], no_effect = [], trace_sha256 } = ended;
  return (
    <dl>
      <Fact name={t("problems.time")}>{time.toFixed(2)} s</Fact>
      {distance != null && <Fact name={t("problems.distance")}>{distance.toFixed(0)} mm</Fact>}
      {goals.length > 0 && <Fact name={t("problems.goals")}><Goals goals={goals} /></Fact>}
      {emotions.length > 0 && <Fact name={t("problems.emotions")}>{emotions.map(emotionName).join(", ")}</Fact>}
      {no_effect.length > 0 && <Fact name={t("problems.noEffect")}><NoEffect skills={no_effect} /></Fact>}
      {trace_sha256 && (
        <Fact name={t("problems.trace")}>
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
          {said(goal.name)}: {t(`problems.goal_${goal.state}`)}
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
  if (device === "Detector:emotions") return t("problems.emotionsOff", { skill });
  return t("problems.missing", { skill, device: device.replace(":", " ") });
}

const EMOTIONS = new Set(["joy", "sadness", "anger", "fear", "disgust", "surprise", "neutral"]);

function emotionName(emotion: string): string {
  return EMOTIONS.has(emotion) ? t(`problems.emotion_${emotion}`) : emotion;
}
