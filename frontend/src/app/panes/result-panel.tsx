/** The result of the last run. */

import type { ComponentChildren } from "preact";
import { CustomBlockLink } from "../../features/custom-blocks/link";
import { Compared } from "../../features/share/compared";
import { say, t } from "../../i18n";
import { goalName } from "../../model/game-words";
import { usePage } from "../../model/page";
import { explained } from "../../model/run-error";
import { ending } from "../../model/run-result";
import type { Ended, GoalNow } from "../../protocol/messages";
import { TeamDot } from "../world/team";
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
      <Compared />
      <Hash ended={ended} />
    </div>
  );
}

function Hash({ ended }: { ended: Ended }) {
  if (ended.repeatable === false) return <p class="dim">{t("page-problems-not-repeatable")}</p>;
  if (!ended.trace_sha256) return null;
  return (
    <details>
      <summary>{t("page-problems-hash")}</summary>
      <p>{t("page-problems-hash-text")}</p>
      <p class="hash">{ended.trace_sha256}</p>
    </details>
  );
}

function Facts({ ended }: { ended: Ended }) {
  const { time = 0, distance, goals = [], emotions = [], no_effect = [] } = ended;
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
  const { askingWhy } = usePage();
  return (
    <ul>
      {goals.map((goal) => (
        <li key={goal.name} class={goal.state}>
          {goal.team && <TeamDot team={goal.team} />} {goalName(goal)}: {t(`page-problems-goal-${goal.state}`)}
          {goal.time !== null && ` (${goal.time.toFixed(1)} s)`}{" "}
          {goal.state !== "reached" && (
            <button type="button" class="button" onClick={() => askingWhy.aboutGoal(goal)}>
              {t("page-why-goal")}
            </button>
          )}
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
  const [kind = "", key = ""] = device.split(":");
  return t("page-problems-missing", { skill, device: say({ code: "check-device", values: { kind, key } }) });
}

const EMOTIONS = new Set(["joy", "sadness", "anger", "fear", "disgust", "surprise", "neutral"]);

function emotionName(emotion: string): string {
  return EMOTIONS.has(emotion) ? t(`page-problems-emotion-${emotion}`) : emotion;
}
