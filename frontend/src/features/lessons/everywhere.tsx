/** What became of the program in all variants of the world and on all robots. */

import { useEffect, useRef } from "preact/hooks";

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import type { LessonAttempt } from "../../protocol/messages";
import { Icon } from "../../ui/icons";

export function Everywhere() {
  const { checked } = usePage().lessons;
  const told = checked.value;
  const place = useRef<HTMLDivElement>(null);
  const isRunning = told?.running ?? false;
  useEffect(() => {
    if (isRunning) place.current?.scrollIntoView({ block: "start" });
  }, [isRunning]);
  const attempts = told?.attempts ?? [];
  if (!told || attempts.length === 0) return null;
  const passed = attempts.filter((one) => one.passed).length;
  const done = attempts.filter((one) => one.passed != null).length;
  const count = attempts.length;
  return (
    <div class="lesson-everywhere" ref={place}>
      <h3>{t("page-lesson-everywhere-title")}</h3>
      {told.running && (
        <progress value={done} max={count} aria-label={t("page-lesson-everywhere-progress", { done, count })} />
      )}
      <p>{t("page-lesson-everywhere-passed", { passed, count })}</p>
      {told.problem && <p class="lesson-reason">{say(told.problem)}</p>}
      <ul>
        {attempts.map((one) => (
          <Attempt key={`${one.robot} ${one.variant ?? 0}`} attempt={one} />
        ))}
      </ul>
    </div>
  );
}

function Attempt({ attempt }: { attempt: LessonAttempt }) {
  const { lessons, project, context } = usePage();
  const { robot, variant = 0, passed = null, reasons = [] } = attempt;
  const state = passed === null ? "open" : passed ? "met" : "failed";
  const where = t("page-lesson-attempt", { robot: project.robotTitle(robot), variant });
  return (
    <li class={`lesson-goal ${state}`}>
      <Icon name={passed === null ? "star" : passed ? "check" : "close"} />
      <span>
        {where} <span class="hidden">{t(`page-lesson-goal-${state}`)}</span>
        {reasons.map((reason) => (
          <span key={say(reason)} class="lesson-reason">
            {say(reason)}
          </span>
        ))}
      </span>
      {state === "failed" && (
        <button
          type="button"
          class="button bordered"
          disabled={context.running.active.value}
          aria-label={t("page-lesson-replay-of", { where })}
          onClick={() => lessons.replay(attempt)}
        >
          <Icon name="run" />
          {t("page-lesson-replay")}
        </button>
      )}
    </li>
  );
}
