/** One hand-in: the program beside its run, the checks, why, and the teacher's note and mark. */

import { type Signal, useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { language, t } from "../../i18n";
import type { CheckSummary, NotedLine, ShownHandIn } from "../../protocol/classroom";
import { IconButton } from "../../ui/button";
import { Dialog } from "../../ui/dialog";
import { Icon } from "../../ui/icons";
import { linesToNote, notedLine, numberIn, type ShowLine } from "../in-class/noted-line";
import { DrawnBlocks } from "../lessons/drawn-blocks";
import { inLanguage } from "../lessons/texts";
import { Stars } from "./list";
import type { HandInStream } from "./stream";
import { DrivenWay } from "./way";

export function ShownWork({ stream }: { stream: HandInStream }) {
  const shown = stream.shown.value;
  if (!shown || shown.line.pupil !== stream.pupil.value) return <section class="hand-in empty" />;
  return <HandIn key={shown.line.pupil} stream={stream} shown={shown} />;
}

interface HandInProps {
  readonly stream: HandInStream;
  readonly shown: ShownHandIn;
}

function HandIn({ stream, shown }: HandInProps) {
  const isNameless = useSignal(false);
  const { line } = shown;
  const noted = useSignal<NotedLine | null>(line.line ?? null);
  /** The line that an answer to "why" is about. */
  const answered = useSignal(0);
  useEffect(() => {
    answered.value = 0;
  }, [noted.value]);
  const time = new Date(line.at * 1000).toLocaleString(language.value, { dateStyle: "short", timeStyle: "short" });
  return (
    <section class="hand-in" aria-labelledby="hand-in-name">
      <header class="hand-in-head">
        <h2 id="hand-in-name">
          <bdi>{line.name}</bdi>
        </h2>
        <Stars line={line} />
        <span class="dim">
          {t(line.collected ? "page-handins-collected-at" : "page-handins-at", { tries: line.tries ?? 0, time })}
        </span>
        <a class="button bordered" href={`p/${line.pupil}/record`}>
          {t("page-record-of-pupil")}
        </a>
        <a class="button bordered" href={`p/${line.pupil}/`} target="_blank" rel="noopener opener">
          {t("page-class-open")}
        </a>
        <IconButton icon="projector" word="page-handins-nameless" onClick={() => (isNameless.value = true)} />
        <IconButton icon="previous" word="page-handins-previous" onClick={() => stream.move(-1)} />
        <IconButton icon="next" word="page-handins-next" onClick={() => stream.move(1)} />
      </header>
      <Work shown={shown} noted={noted} answered={answered.value}>
        <RunPlace stream={stream} shown={shown} showLine={(number) => (answered.value = number)} />
      </Work>
      <Why shown={shown} />
      <Answer stream={stream} shown={shown} noted={noted} />
      {isNameless.value && <Nameless shown={shown} close={() => (isNameless.value = false)} />}
    </section>
  );
}

/** Shows a hand-in to the class on the whole screen: without the name, the note and the mark. */
function Nameless({ shown, close }: { shown: ShownHandIn; close: () => void }) {
  return (
    <div class="nameless">
      <Dialog title={t("page-handins-nameless-title", { step: shown.step })} size="whole" close={close}>
        <Work shown={shown}>
          <DrivenWay shown={shown} label={t("page-class-world-shown")} />
        </Work>
      </Dialog>
    </div>
  );
}

interface WorkProps {
  readonly shown: ShownHandIn;
  /** Where the robot drove. */
  readonly children: ComponentChildren;
  /** The line that the note is about; undefined where no note is written. */
  readonly noted?: Signal<NotedLine | null>;
  /** The line to mark instead of that; 0 for none. */
  readonly answered?: number;
}

/** The program, where the robot drove, and what the checks say. */
function Work({ shown, children, noted, answered = 0 }: WorkProps) {
  const { line, program, checked, blocktext, blocks } = shown;
  const pick = (block: string) => {
    const number = shown.lines?.[block];
    if (noted && number) noted.value = notedLine(textOf(shown), number);
  };
  return (
    <div class="hand-in-body">
      <div>
        {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a keyboard user must be able to scroll it */}
        <div class="hand-in-program" role="group" tabIndex={0} aria-label={t("page-handins-program")}>
          {blocks ? (
            <DrawnBlocks
              key={`${line.pupil} ${line.at}`}
              workspace={blocks}
              text={blocktext ?? ""}
              marked={blockAt(shown, answered || lineOf(shown, noted?.value))}
              pick={noted && pick}
            />
          ) : (
            <pre>{program.text}</pre>
          )}
        </div>
        {checked && <Checks checks={checked.checks ?? []} runs={checked.runs} />}
      </div>
      {children}
    </div>
  );
}

/** Where the robot drove, from above; or in 3D, by the page that pupils have, which is loaded only then. */
function RunPlace({ stream, shown, showLine }: HandInProps & { readonly showLine: (number: number) => void }) {
  const { line, lesson, step } = shown;
  const frame = useRef<HTMLIFrameElement>(null);
  useEffect(() => {
    const listen = ({ source, data }: MessageEvent<Partial<ShowLine> | null>) => {
      if (source && source === frame.current?.contentWindow) showLine(Number(data?.showLine) || 0);
    };
    addEventListener("message", listen);
    return () => removeEventListener("message", listen);
  }, []);
  const sees = stream.seesRuns.value;
  const query = new URLSearchParams({ pupil: line.pupil, lesson, step: String(step) });
  return (
    <div class="hand-in-run-place">
      {sees ? (
        <iframe
          ref={frame}
          // What was handed in again runs again.
          key={`${line.at} ${language.value}`}
          src={`p/hand-ins/?${query}`}
          title={t("page-handins-run-of", { name: line.name })}
        />
      ) : (
        <DrivenWay shown={shown} label={t("page-handins-way", { name: line.name })} />
      )}
      {shown.world && (
        <button type="button" class="button bordered" onClick={() => (stream.seesRuns.value = !sees)}>
          <Icon name={sees ? "top" : "run"} />
          {t(sees ? "page-handins-run-hide" : "page-handins-run-show")}
        </button>
      )}
    </div>
  );
}

/** The text in which lines are counted. */
function textOf({ blocktext, program }: ShownHandIn): string {
  return blocktext || program.text;
}

function lineOf(shown: ShownHandIn, line: NotedLine | null | undefined): number {
  return line ? numberIn(textOf(shown), line) : 0;
}

function blockAt({ lines = {} }: ShownHandIn, number: number): string | null {
  return Object.entries(lines).find(([, at]) => at === number)?.[0] ?? null;
}

function Checks({ checks, runs }: { checks: readonly CheckSummary[]; runs: number }) {
  return (
    <ul class="hand-in-checks" aria-label={t("page-handins-checks")}>
      {checks.map((check, index) => {
        const isMet = check.met === runs;
        return (
          <li key={index} class={isMet ? "met" : "failed"}>
            <Icon name={isMet ? "check" : "close"} />
            <span>
              {inLanguage(check.say)} <span class="dim">{t("page-handins-met", { met: check.met, runs })}</span>
              {check.reason && <span class="hand-in-reason">{inLanguage(check.reason)}</span>}
            </span>
          </li>
        );
      })}
    </ul>
  );
}

/** Why a check was missed, as far as the lesson's rules can tell. */
function Why({ shown: { checked } }: { shown: ShownHandIn }) {
  if (!checked) return <p class="hand-in-why">{t("page-handins-check-first")}</p>;
  const reason = inLanguage(checked.reason);
  const { hints = [] } = checked;
  if (!reason && hints.length === 0) return null;
  return (
    <div class="hand-in-why">
      <h3>
        <Icon name="why" />
        {t("page-handins-why")}
      </h3>
      {reason && <p>{reason}</p>}
      {hints.map((hint, index) => (
        <p key={index}>
          {inLanguage(hint.because)} {inLanguage(hint.says)}
        </p>
      ))}
    </div>
  );
}

interface AnswerProps extends HandInProps {
  readonly noted: Signal<NotedLine | null>;
}

/** The note and the mark are the teacher's own: empty at first, never computed, on any scale. */
function Answer({ stream, shown, noted }: AnswerProps) {
  const { line, back = [] } = shown;
  const note = useSignal(line.note ?? "");
  const mark = useSignal(line.mark ?? "");
  const field = useRef<HTMLTextAreaElement>(null);
  useLayoutEffect(() => {
    if (!stream.staysInList) field.current?.focus({ preventScroll: true });
  }, [stream.focused.value]);
  const keep = () => {
    const about = note.peek().trim() ? noted.peek() : null;
    const isOther = JSON.stringify(about) !== JSON.stringify(line.line ?? null);
    if (note.peek() !== (line.note ?? "") || mark.peek() !== (line.mark ?? "") || isOther)
      stream.mark(line.pupil, note.peek().trim(), mark.peek().trim(), about);
  };
  useEffect(keep, [noted.value]);
  const handBack = (event: Event) => {
    event.preventDefault();
    keep();
    stream.handBack([line.pupil]);
    stream.moveOn();
  };
  const keys = (event: KeyboardEvent) => {
    if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) handBack(event);
    if (event.key === "Escape") stream.toList();
  };
  const isBack = line.state === "handed back" || line.state === "improving";
  return (
    <form class="hand-in-answer" onSubmit={handBack} onKeyDown={keys}>
      <label class="field">
        <span>
          {t("page-handins-note")} <bdi>{line.name}</bdi>
        </span>
        <textarea
          ref={field}
          rows={2}
          maxLength={1000}
          value={note.value}
          onInput={({ currentTarget }) => (note.value = currentTarget.value)}
          onBlur={keep}
        />
      </label>
      <label class="field">
        {t("page-handins-your-mark")}
        <input
          maxLength={20}
          size={5}
          value={mark.value}
          onInput={({ currentTarget }) => (mark.value = currentTarget.value)}
          onBlur={keep}
        />
      </label>
      <button type="submit" class="button filled" disabled={isBack && !note.value && !mark.value}>
        <Icon name="move" />
        {t(isBack ? "page-handins-back-again" : "page-handins-back")}
      </button>
      <About shown={shown} noted={noted} />
      <LastNotes stream={stream} choose={(text) => (note.value = text)} />
      {back.length > 0 && <p class="dim">{earlier(back.map((one) => one.mark ?? ""))}</p>}
    </form>
  );
}

/** What the note is about, for keys too: a click on a block chooses the same. */
function About({ shown, noted }: { shown: ShownHandIn; noted: Signal<NotedLine | null> }) {
  const text = textOf(shown);
  const lines = linesToNote(text);
  const about = noted.value;
  const number = lineOf(shown, about);
  const isGone = about !== null && !lines.some((line) => line.number === number);
  const choose = (value: string) => {
    if (value) noted.value = Number(value) > 0 ? notedLine(text, Number(value)) : null;
  };
  return (
    <label class="hand-in-about">
      {t("page-handins-about")}
      <select value={isGone ? "" : String(number)} onChange={({ currentTarget }) => choose(currentTarget.value)}>
        <option value="0">{t("page-handins-about-all")}</option>
        {isGone && <option value="">{t("page-handins-about-gone", { line: about.text })}</option>}
        {lines.map((line) => (
          <option key={line.number} value={line.number}>
            {line.number} · {line.text}
          </option>
        ))}
      </select>
    </label>
  );
}

function earlier(marks: readonly string[]): string {
  return t("page-handins-earlier", { marks: marks.map((mark) => mark || "–").join(" → ") });
}

/** The teacher's own last notes, to use again. */
function LastNotes({ stream, choose }: { stream: HandInStream; choose: (text: string) => void }) {
  const notes = stream.list.value?.notes ?? [];
  if (notes.length === 0) return null;
  return (
    <div class="hand-in-notes">
      {notes.map((text) => (
        <button key={text} type="button" class="button" onClick={() => choose(text)}>
          {text}
        </button>
      ))}
    </div>
  );
}
