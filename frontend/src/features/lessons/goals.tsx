/** The checks of a step as goals, whose stars change while the program runs. */

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import type { LessonGoal } from "../../protocol/messages";
import { Icon, type IconName } from "../../ui/icons";
import { sayWords } from "./lessons";

const ICONS: Readonly<Record<NonNullable<LessonGoal["state"]>, IconName>> = {
  open: "star",
  met: "earned",
  failed: "close",
};

export function Goals() {
  const { goals } = usePage().lessons;
  if (goals.value.length === 0) return null;
  return (
    <div class="lesson-goals">
      <h3 class="hidden">{t("page-lesson-goals")}</h3>
      <ul>
        {goals.value.map((goal, index) => (
          <Goal key={index} goal={goal} />
        ))}
      </ul>
    </div>
  );
}

function Goal({ goal }: { goal: LessonGoal }) {
  const { say: words, state = "open", optional, reason } = goal;
  return (
    <li class={`lesson-goal ${state}`}>
      <Icon name={ICONS[state]} />
      <span>
        {sayWords(words)}
        {optional && <span class="dim"> {t("page-lesson-optional")}</span>}
        <span class="hidden"> {t(`page-lesson-goal-${state}`)}</span>
        {state === "failed" && reason && <span class="lesson-reason">{say(reason)}</span>}
      </span>
      <Show goal={goal} />
      <Why goal={goal} />
    </li>
  );
}

/** Looks at where a goal was missed. */
function Show({ goal: { say: words, state, place } }: { goal: LessonGoal }) {
  const { views } = usePage();
  if (state !== "failed" || !place) return null;
  const name = `${t("page-lesson-show")} ${sayWords(words)}`;
  return (
    <button type="button" class="button bordered" aria-label={name} onClick={() => views.world.value?.lookAt(place)}>
      <Icon name="eye" />
      {t("page-lesson-show")}
    </button>
  );
}

/** Asks why a goal was missed, if there is a run that can tell. */
function Why({ goal: { say: words, ask = "", subject = "" } }: { goal: LessonGoal }) {
  const { askingWhy } = usePage();
  if (!ask || !askingWhy.isPossible) return null;
  const name = `${t("page-why-goal")} ${sayWords(words)}`;
  return (
    <button type="button" class="button bordered" aria-label={name} onClick={() => askingWhy.aboutCheck(ask, subject)}>
      <Icon name="why" />
      {t("page-why-goal")}
    </button>
  );
}
