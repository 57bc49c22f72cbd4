/**
 * The timeline over the world: any moment of the run again, in the world, the program and its variables.
 *
 * Its place is kept before the first run, so that nothing moves when it appears.
 */

import { useSignalEffect } from "@preact/signals";

import { t } from "../../i18n";
import { STEPS } from "../../model/looking-back";
import { type Page, usePage } from "../../model/page";
import type { Timeline as Recorded, TimeMark } from "../../protocol/messages";
import { IconButton } from "../../ui/button";
import { Menu, type MenuGroup } from "../../ui/menu";
import "../../ui/slider.css";
import "./timeline.css";

/** Seconds between two moments of the slider. */
const STEP = 0.01;
/** Milliseconds between two readings of the timeline of a program that runs. */
const PERIOD = 500;

export function Timeline() {
  const page = usePage();
  useGrowth(page);
  const timeline = page.context.running.timeline.value;
  return <div class="timeline-place">{timeline?.end ? <Bar timeline={timeline} /> : null}</div>;
}

function Bar({ timeline: { begin = 0, end, marks = [] } }: { timeline: Recorded }) {
  const page = usePage();
  const { context, lookingBack } = page;
  const { running } = context;
  const past = running.past.value;
  const time = Math.min(past?.time ?? end, end);
  const step = lookingBack.stepTo.value;
  const shareOf = (moment: number) => (moment - begin) / Math.max(end - begin, STEP);
  return (
    <div class="timeline" role="group" aria-label={t("page-timeline-title")}>
      <IconButton icon="markBefore" word="page-timeline-mark-before" onClick={() => lookingBack.toMark(-1)} />
      <IconButton icon="lineBefore" word={`page-timeline-${step}-before`} onClick={() => lookingBack.step(-1)} />
      <div class="timeline-bar">
        <div class="timeline-marks" aria-hidden="true">
          {marks.map((mark) => (
            <MarkTick key={`${mark.time} ${mark.sort} ${mark.text}`} mark={mark} share={shareOf(mark.time)} />
          ))}
        </div>
        <input
          class="slider"
          type="range"
          min={begin}
          max={end}
          step={STEP}
          value={time}
          aria-label={t("page-timeline-time")}
          aria-valuetext={valueText(time, marks)}
          style={{ "--share": shareOf(time) }}
          aria-keyshortcuts="Shift+ArrowLeft Shift+ArrowRight Control+ArrowLeft Control+ArrowRight Escape"
          onInput={({ currentTarget }) => lookingBack.look(Number(currentTarget.value))}
          onKeyDown={(event) => travel(event, page)}
        />
      </div>
      <IconButton icon="lineAfter" word={`page-timeline-${step}-after`} onClick={() => lookingBack.step(1)} />
      <IconButton icon="markAfter" word="page-timeline-mark-after" onClick={() => lookingBack.toMark(1)} />
      <output class="timeline-time" aria-hidden="true">
        {t("page-timeline-seconds", { seconds: time.toFixed(2) })}
      </output>
      <span class="timeline-none" role="status">
        {past?.found === false && t("page-timeline-none")}
      </span>
      <StepMenu marks={marks} />
      <IconButton icon="present" word="page-timeline-present" off={!past} onClick={() => running.leavePast()} />
    </div>
  );
}

/** Let the timeline grow while the program runs. */
function useGrowth({ context, lookingBack }: Page): void {
  useSignalEffect(() => {
    if (context.running.state.value.state !== "running") return undefined;
    const timer = setInterval(() => document.hidden || lookingBack.readTimeline(), PERIOD);
    return () => clearInterval(timer);
  });
}

/** What the buttons step to, and which marks they go to. */
function StepMenu({ marks }: { marks: readonly TimeMark[] }) {
  const { stepTo, markSort } = usePage().lookingBack;
  const sorts = ["", ...new Set(marks.map(({ sort }) => sort))] as const;
  const groups: readonly MenuGroup[] = [
    {
      title: t("page-timeline-steps"),
      items: STEPS.map((step) => ({
        text: t(`page-timeline-step-${step}`),
        checked: stepTo.value === step,
        run: () => (stepTo.value = step),
      })),
    },
    {
      title: t("page-timeline-marks"),
      items: sorts.map((sort) => ({
        text: t(`page-timeline-marks-${sort || "all"}`),
        checked: markSort.value === sort,
        run: () => (markSort.value = sort),
      })),
    },
  ];
  return <Menu label={t("page-timeline-menu")} icon="more" groups={groups} side="right" />;
}

/** The keys of the slider besides those that every slider has. */
function travel(event: KeyboardEvent, { lookingBack, context }: Page): void {
  const by = ({ ArrowLeft: -1, ArrowRight: 1 } as const)[event.key];
  if (event.key === "Escape" && context.running.past.peek()) context.running.leavePast();
  else if (by && event.shiftKey) lookingBack.step(by);
  else if (by && (event.ctrlKey || event.metaKey)) lookingBack.toMark(by);
  else return;
  event.preventDefault();
}

function MarkTick({ mark, share }: { mark: TimeMark; share: number }) {
  const { askingWhy } = usePage();
  return (
    // For keyboards, the question about the mark of the moment is on the world.
    <button
      type="button"
      tabIndex={-1}
      class={`timeline-mark ${mark.sort}`}
      style={{ "--share": share }}
      title={t("page-why-mark", { what: describeMark(mark) })}
      onClick={() => askingWhy.aboutMark(mark)}
    />
  );
}

/** The time, and what happened then. */
function valueText(time: number, marks: readonly TimeMark[]): string {
  const seconds = t("page-timeline-seconds", { seconds: time.toFixed(2) });
  const there = marks.filter((mark) => Math.abs(mark.time - time) < STEP / 2).map(describeMark);
  return [seconds, ...there].join(", ");
}

function describeMark({ sort, text }: TimeMark): string {
  return t(`page-timeline-${sort}`, { text });
}
