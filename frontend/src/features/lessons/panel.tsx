/** The lesson of the open project: the step's instructions, its goals, hints and questions. */

import { useComputed, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { LessonShown } from "../../protocol/messages";
import { IconButton } from "../../ui/button";
import { Dialog } from "../../ui/dialog";
import { Icon } from "../../ui/icons";
import { room } from "../../ui/screen";
import { Everywhere } from "./everywhere";
import { Goals } from "./goals";
import { BackLine, HandedIn, HandInButton } from "./hand-in";
import { Hints } from "./hints";
import { inLanguage } from "./lessons";
import type { MarkdownPart } from "./markdown";
import { Puzzle } from "./puzzle";
import { Quiz, QuizAnswer } from "./quiz";
import { useRoomForResult } from "./room-for-result";
import "./lessons.css";

export function LessonPane() {
  const shown = usePage().lessons.shown.value;
  if (!shown) return null;
  return room.value === "narrow" ? <Line shown={shown} /> : <Pane shown={shown} />;
}

/** Beside the program, above the world; or, on a tablet, between them. */
function Pane({ shown }: { shown: LessonShown }) {
  const folded = useSignal(false);
  return (
    <section
      id="lesson"
      class={folded.value ? "region lesson-pane folded" : "region lesson-pane"}
      aria-labelledby="title-lesson"
      data-region="lesson"
      tabIndex={-1}
    >
      <div class="lesson-head">
        <Place shown={shown} />
        <Stars />
        <RestartButton shown={shown} />
        <button
          type="button"
          class="button"
          aria-expanded={!folded.value}
          aria-controls="lesson-body"
          aria-label={t("page-lesson-fold")}
          title={t("page-lesson-fold")}
          onClick={() => (folded.value = !folded.value)}
        >
          <Icon name={folded.value ? "down" : "up"} />
        </button>
      </div>
      <h2 id="title-lesson" class="lesson-title">
        {stepTitle(shown)}
      </h2>
      {!folded.value && (
        <div class="lesson-content">
          <Body shown={shown} />
          <Task shown={shown} />
          <HandedIn shown={shown} />
          <Foot shown={shown} />
        </div>
      )}
      <Party />
    </section>
  );
}

/** On a phone: a line with the question or the goals; the line opens everything as a sheet. */
function Line({ shown }: { shown: LessonShown }) {
  const open = useSignal(false);
  const { context, askingWhy } = usePage();
  // The world has to be seen while the program runs, and then the answer to a question about it.
  const isActive = context.running.active.value;
  const answer = askingWhy.answer.value;
  useEffect(() => {
    if (isActive || answer) open.value = false;
  }, [isActive, answer]);
  const close = () => (open.value = false);
  return (
    <section id="lesson" class="region lesson-line" aria-labelledby="title-lesson" data-region="lesson">
      <button type="button" class="lesson-open" aria-haspopup="dialog" onClick={() => (open.value = true)}>
        <Segments shown={shown} />
        <h2 id="title-lesson">{stepTitle(shown)}</h2>
        <Stars />
        <Icon name="up" />
      </button>
      {!open.value && <BackLine shown={shown} open={() => (open.value = true)} />}
      {!open.value && <Task shown={shown} />}
      {!open.value && <ShortFoot shown={shown} />}
      {open.value && (
        <Dialog title={stepTitle(shown)} close={close} size="large">
          <div class="lesson-sheet">
            <div class="lesson-head">
              <Place shown={shown} />
              <Stars />
              <RestartButton shown={shown} />
            </div>
            <Body shown={shown} />
            <Task shown={shown} />
            <HandedIn shown={shown} />
            <Foot shown={shown} />
          </div>
        </Dialog>
      )}
      <Party />
    </section>
  );
}

function stepTitle({ steps = [], step = 1 }: LessonShown): string {
  return inLanguage(steps[step - 1]?.title);
}

function Place({ shown }: { shown: LessonShown }) {
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
function Segments({ shown: { step: now = 1 } }: { shown: LessonShown }) {
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
function Stars() {
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

function Body({ shown }: { shown: LessonShown }) {
  const body = useRef<HTMLDivElement>(null);
  const markdown = useSignal<{ readonly Part: MarkdownPart } | null>(null);
  useEffect(() => {
    void import("./markdown").then(({ Markdown }) => (markdown.value = { Part: Markdown }));
  }, []);
  const { context, lessons } = usePage();
  const open = (program: string) => context.openExample(program);
  const { name = "", step = 1, text = "", drawings = {} } = shown;
  // A new step is read from its beginning.
  useEffect(() => {
    if (body.current) body.current.scrollTop = 0;
  }, [name, step]);
  const Part = markdown.value?.Part;
  // Only this matters here, of goals that change while a program runs.
  const hasResult = useComputed(() => lessons.goals.value.some(({ state }) => state === "failed"));
  useRoomForResult(body, `${name} ${step}`, (shown.goals?.length ?? 0) > 0, hasResult.value);
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: a keyboard user must be able to scroll it
    <div id="lesson-body" class="lesson-body" ref={body} tabIndex={0} role="group" aria-label={t("page-lesson-text")}>
      {Part && <Part key={`${name} ${step}`} text={inLanguage(text)} lesson={name} drawings={drawings} open={open} />}
      {shown.puzzle && <Puzzle key={`puzzle ${step}`} puzzle={shown.puzzle} drawings={drawings} />}
      <Hints />
      <Everywhere />
    </div>
  );
}

/** What the pupil has to do: it stays in sight while the text is scrolled. */
function Task({ shown: { name = "", quiz, step = 1 } }: { shown: LessonShown }) {
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

function Foot({ shown }: { shown: LessonShown }) {
  return (
    <div class="lesson-foot">
      <HintButton shown={shown} />
      <CheckButton shown={shown} />
      <HandInButton shown={shown} />
      {shown.quiz && <QuizAnswer quiz={shown.quiz} />}
      <StepButtons shown={shown} />
    </div>
  );
}

/** Below the task on a phone: only what belongs to it now. */
function ShortFoot({ shown }: { shown: LessonShown }) {
  const { lessons } = usePage();
  const isDone = (lessons.steps.value[(shown.step ?? 1) - 1]?.earned ?? 0) > 0;
  if (!shown.quiz && !isDone) return null;
  return (
    <div class="lesson-foot">
      {shown.quiz && <QuizAnswer quiz={shown.quiz} />}
      {isDone && <StepButtons shown={shown} />}
    </div>
  );
}

/** It stands out after a run that has failed. */
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

function RestartButton({ shown }: { shown: LessonShown }) {
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

function StepButtons({ shown: { step = 1, steps = [] } }: { shown: LessonShown }) {
  const { lessons } = usePage();
  const isActive = usePage().context.running.active.value;
  const hasStar = (lessons.steps.value[step - 1]?.earned ?? 0) > 0;
  // Until its question is answered, a step does not invite anyone to leave it.
  const look = hasStar ? "button filled" : lessons.isAsking ? "button dim" : "button bordered";
  return (
    <div class="lesson-moves">
      <IconButton
        icon="previous"
        word="page-lesson-previous"
        off={step <= 1 || isActive}
        onClick={() => lessons.showStep(step - 1)}
      />
      {step < steps.length ? (
        <button
          type="button"
          class={look}
          aria-disabled={isActive ? "true" : undefined}
          onClick={() => isActive || lessons.showStep(step + 1)}
        >
          {t("page-lesson-next")}
          <Icon name="next" />
        </button>
      ) : (
        <Finish />
      )}
    </div>
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
function Party() {
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
