/** What a lesson consists of, wherever it is shown: its place, text, task, goals and buttons. */

import { useComputed } from "@preact/signals";
import type { ComponentChildren, RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { LessonShown } from "../../protocol/messages";
import { IconButton } from "../../ui/button";
import { Icon } from "../../ui/icons";
import { Everywhere } from "./everywhere";
import { Goals } from "./goals";
import { HandInButton } from "./hand-in";
import { Hints } from "./hints";
import { inLanguage } from "./lessons";
import { Markdown } from "./markdown-later";
import { Puzzle } from "./puzzle";
import { CheckAnswer, Quiz, QuizResult } from "./quiz";
import { useRoomForResult } from "./room-for-result";

export function stepTitle({ steps = [], step = 1 }: LessonShown): string {
  return inLanguage(steps[step - 1]?.title);
}

export function Place({ shown }: { shown: LessonShown }) {
  const { step = 1, steps = [] } = shown;
  const phase = steps[step - 1]?.phase;
  return (
    <>
      <span class="lesson-level" title={inLanguage(shown.title)}>
        {t("page-lesson-level", { level: shown.level ?? 1 })}
      </span>
      <Segments shown={shown} />
      <span class="lesson-place">{t("page-lesson-step-of", { step, count: steps.length })}</span>
      {phase && <span class="lesson-phase dim">{t(`page-lesson-phase-${phase}`)}</span>}
    </>
  );
}

/** The steps as a row of bars: those whose stars are all earned, the current one, the others. */
export function Segments({ shown: { step: now = 1 } }: { shown: LessonShown }) {
  const { steps } = usePage().lessons;
  return (
    <span class="lesson-segments" aria-hidden="true">
      {steps.value.map(({ stars = 0, earned = 0 }, index) => {
        const look = index + 1 === now ? "now" : stars > 0 && earned >= stars ? "done" : "";
        return <i key={index} class={look} />;
      })}
    </span>
  );
}

/** The stars of the current step. */
export function Stars() {
  const { shown, steps } = usePage().lessons;
  const { stars = 0, earned = 0 } = steps.value[(shown.value?.step ?? 1) - 1] ?? {};
  if (stars === 0) return <span class="lesson-stars" />;
  return (
    <span class="lesson-stars" role="img" aria-label={t("page-lesson-stars", { earned, stars })}>
      {Array.from({ length: stars }, (_, index) => (
        <Icon key={index} name={index < earned ? "earned" : "star"} />
      ))}
    </span>
  );
}

export function Body({ shown }: { shown: LessonShown }) {
  const body = useRef<HTMLDivElement>(null);
  const { lessons } = usePage();
  const { name = "", step = 1, drawings = {} } = shown;
  // Only this matters here, of goals that change while a program runs.
  const hasResult = useComputed(() => lessons.goals.value.some(({ state }) => state === "failed"));
  useRoomForResult(body, `${name} ${step}`, (shown.goals?.length ?? 0) > 0, hasResult.value);
  return (
    <TextPlace shown={shown} place={body}>
      {shown.puzzle && <Puzzle key={`puzzle ${step}`} puzzle={shown.puzzle} drawings={drawings} />}
      <Hints />
      <Everywhere />
    </TextPlace>
  );
}

/** Only the text of the step. */
export function StepText({ shown }: { shown: LessonShown }) {
  return <TextPlace shown={shown} place={useRef<HTMLDivElement>(null)} />;
}

interface TextProps {
  readonly shown: LessonShown;
  readonly place: RefObject<HTMLDivElement | null>;
  readonly children?: ComponentChildren;
}

function TextPlace({ shown, place, children }: TextProps) {
  const { context } = usePage();
  const open = (program: string) => context.openExample(program);
  const { name = "", step = 1, text = "", drawings = {} } = shown;
  // A new step is read from its beginning.
  useEffect(() => {
    if (place.current) place.current.scrollTop = 0;
  }, [name, step]);
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: a keyboard user must be able to scroll it
    <div id="lesson-body" class="lesson-body" ref={place} tabIndex={0} role="group" aria-label={t("page-lesson-text")}>
      <Markdown key={`${name} ${step}`} text={inLanguage(text)} lesson={name} drawings={drawings} open={open} />
      {children}
    </div>
  );
}

/** What the pupil has to do: it stays in sight while the text is scrolled. */
export function Task({ shown: { name = "", quiz, step = 1 } }: { shown: LessonShown }) {
  const { lessons, handIns } = usePage();
  // What came back says what was reached and missed in the goals' place.
  if ((!quiz && lessons.goals.value.length === 0) || handIns.back(name, step)) return null;
  return (
    <div class="lesson-task">
      {quiz && <Quiz key={step} quiz={quiz} />}
      <Goals />
    </div>
  );
}

export function Foot({ shown }: { shown: LessonShown }) {
  return (
    <div class="lesson-foot">
      <HintButton shown={shown} />
      <CheckButton shown={shown} />
      <HandInButton shown={shown} />
      {shown.quiz && <CheckAnswer quiz={shown.quiz} />}
      {shown.quiz && <QuizResult quiz={shown.quiz} />}
      <StepButtons shown={shown} />
    </div>
  );
}

/** Highlighted after a failed run. */
function HintButton({ shown }: { shown: LessonShown }) {
  const { lessons } = usePage();
  if (!shown.goals?.length) return null;
  return (
    <button
      type="button"
      class={lessons.failed.value ? "button bordered lesson-hint offered" : "button bordered lesson-hint"}
      onClick={() => lessons.takeHint()}
    >
      <Icon name="hint" />
      {t("page-lesson-hint")}
    </button>
  );
}

function CheckButton({ shown: { attempts = 0 } }: { shown: LessonShown }) {
  const { lessons, context } = usePage();
  const hasErrors = context.program.state.value.problems.some((one) => one.severity === "error");
  if (attempts < 2) return null;
  if (lessons.checked.value?.running) {
    return (
      <button type="button" class="button bordered" onClick={() => lessons.stopChecking()}>
        <Icon name="stop" />
        {t("page-lesson-everywhere-stop")}
      </button>
    );
  }
  return (
    <button
      type="button"
      class="button bordered"
      disabled={context.running.active.value || hasErrors}
      title={t("page-lesson-everywhere-help")}
      onClick={() => lessons.check()}
    >
      <Icon name="shuffle" />
      {t("page-lesson-everywhere")}
    </button>
  );
}

export function RestartButton({ shown }: { shown: LessonShown }) {
  const { lessons, context } = usePage();
  if (!shown.restarts) return null;
  return (
    <IconButton
      icon="restart"
      word="page-lesson-restart"
      off={context.running.active.value}
      onClick={() => lessons.restartStep()}
    />
  );
}

function StepButtons({ shown }: { shown: LessonShown }) {
  const { lessons, context } = usePage();
  const { step = 1 } = shown;
  const isActive = context.running.active.value;
  return (
    <div class="lesson-moves">
      <IconButton
        icon="previous"
        word="page-lesson-previous"
        off={step <= 1 || isActive}
        onClick={() => lessons.showStep(step - 1)}
      />
      <Forward shown={shown} />
    </div>
  );
}

/** To the next step, or from the last one back to the other lessons. */
export function Forward({ shown: { step = 1, steps = [] } }: { shown: LessonShown }) {
  const { lessons, context } = usePage();
  const isActive = context.running.active.value;
  // Until its question is answered, a step does not invite anyone to leave it.
  const look = lessons.hasStar ? "button filled" : lessons.isAsking ? "button dim" : "button bordered";
  if (step >= steps.length) return <Finish />;
  return (
    <button
      type="button"
      class={look}
      aria-disabled={isActive ? "true" : undefined}
      onClick={() => isActive || lessons.showStep(step + 1)}
    >
      {t("page-lesson-next")}
      <Icon name="next" />
    </button>
  );
}

/** After the last step: back to the other lessons. */
function Finish() {
  const { project, lessons } = usePage();
  const look = lessons.isFinished ? "button filled" : "button bordered";
  return (
    <button type="button" class={look} onClick={() => project.leave()}>
      {t("page-lesson-finish")}
    </button>
  );
}

/** A few stars that rise for a moment; none for those who want no motion. */
export function Party() {
  const { party } = usePage().lessons;
  if (party.value === 0) return null;
  return (
    <span key={party.value} class="lesson-party" aria-hidden="true">
      {["0", "1", "2", "3", "4", "5", "6"].map((star) => (
        <Icon key={star} name="earned" />
      ))}
    </span>
  );
}
