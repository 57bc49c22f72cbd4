/** The goal of the world in words; of several, the next one, and how many have been reached. */

import { t } from "../../i18n";
import { goalName, goalsOf } from "../../model/game-words";
import { usePage } from "../../model/page";
import type { GoalNow } from "../../protocol/messages";
import { Icon } from "../../ui/icons";

export function Goals() {
  const { context, askingWhy } = usePage();
  const { robots, goals: all = [], game } = context.running.telemetry.value ?? {};
  const goals = goalsOf(robots?.[0]?.name, all, game);
  if (goals.length === 0) return <FreePlay />;
  const reached = goals.filter(({ state }) => state === "reached").length;
  const done = reached === goals.length;
  const look = done ? "chip goals reached" : "chip goals";
  const title = all.map(goalName).join("\n");
  const goal = goalNow(goals);
  const inside = (
    <>
      <Icon name={done ? "check" : "star"} />
      {goal && goalInWords(goalName(goal), reached, goals.length)}
    </>
  );
  if (!goal || !askingWhy.isPossible) {
    return (
      <p class={look} title={title}>
        {inside}
      </p>
    );
  }
  return (
    <button
      type="button"
      class={`${look} asks`}
      title={`${title}\n${t("page-why-goal")}`}
      onClick={() => askingWhy.aboutGoal(goal)}
    >
      {inside}
      <Icon name="why" />
    </button>
  );
}

/** A world without goals says so, once it is there; a lesson has its own tasks. */
function FreePlay() {
  const { context, lessons } = usePage();
  if (!context.running.scene.value || lessons.shown.value) return null;
  return (
    <p class="chip goals" title={t("page-world-free-play-help")}>
      <Icon name="examples" />
      {t("page-world-free-play")}
    </p>
  );
}

/** A single goal has no number; once all are reached, none is named. */
function goalInWords(goal: string, reached: number, all: number): string {
  if (all === 1) return t("page-world-goal", { goal });
  if (reached === all) return t("page-problems-goals-reached", { reached, all });
  return t("page-world-goal-of", { number: reached + 1, all, goal });
}

/** The goal to reach now; once there is none left, the first one. */
function goalNow(goals: readonly GoalNow[]): GoalNow | undefined {
  return goals.find(({ state }) => state === "open") ?? goals[0];
}
