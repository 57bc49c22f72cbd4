/** Answers about a run that was recorded as a whole. */

import type {
  Asked,
  AskWhy,
  Drawing,
  LookBack,
  Past,
  Questions,
  ReadQuestions,
  Telemetry,
  WhyAnswer,
} from "../../protocol/messages";
import type { Moment, Recording } from "./content";

/** So far from a moment, in s, an answer is still one about it. */
const NEAR = 0.5;

export class RecordedRun {
  constructor(
    private readonly recording: Recording,
    /** Where all robots were at the time of a moment. */
    private readonly robotsAt: (time: number) => Telemetry["robots"],
  ) {}

  /** The last moment. */
  get end(): Past {
    const { moments } = this.recording;
    return this.pastOf(moments[moments.length - 1]!);
  }

  /** The moment at a place, or the one before or after it; the same one with `found: false` if there is none. */
  past({ time, event = null, step = 0, to = "line", subject = "" }: LookBack): Past {
    const { moments } = this.recording;
    const index = indexAt(moments, time, event);
    const here = moments[index]!;
    if (!step) return { ...this.pastOf(here), time: Math.min(time, this.recording.timeline.end) };
    if (to === "mark") {
      const marked = this.markFrom(here.past.time, step, subject);
      return marked === null ? notFound(this.pastOf(here)) : this.pastOf(moments[marked]!);
    }
    for (let next = index + step; next in moments; next += step) {
      if (isWanted(moments[next - step]!.past, moments[next]!.past, step, to, subject))
        return this.pastOf(moments[next]!);
    }
    return notFound(this.pastOf(here));
  }

  /** What can be asked about the run, or about a block. */
  questions({ block = "" }: ReadQuestions): Questions {
    const { questions } = this.recording.questions;
    const about = block ? questions.filter((one) => one.block === block) : questions;
    return { kind: "Questions", questions: about, block };
  }

  /** The answer to a question, or to the same one at the nearest moment; null if there is none. */
  answer({ question }: AskWhy): WhyAnswer | null {
    const { ask, subject, time } = question;
    const same = this.recording.answers.filter(({ asked }) => asked.question.ask === ask && isAbout(asked, subject));
    const distance = ({ asked }: WhyAnswer) => Math.abs((asked.question.time ?? time ?? 0) - (time ?? 0));
    const [nearest] = same.sort((one, other) => distance(one) - distance(other));
    return nearest && (ask !== "now" || distance(nearest) <= this.spacing) ? nearest : null;
  }

  /** Long runs have answers about fewer moments. */
  private get spacing(): number {
    const { begin = 0, end } = this.recording.timeline;
    return Math.max(NEAR, (end - begin) / 20);
  }

  private markFrom(time: number, step: number, sort: string): number | null {
    const marks = (this.recording.timeline.marks ?? []).filter((mark) => !sort || mark.sort === sort);
    const side = marks.filter((mark) => (step > 0 ? mark.time > time : mark.time < time));
    const mark = step > 0 ? side[0] : side.at(-1);
    return mark ? indexAt(this.recording.moments, mark.time, null) : null;
  }

  private pastOf({ past, drawn }: Moment): Past {
    if (!past.telemetry) return past;
    const telemetry = { ...past.telemetry, robots: this.robotsAt(past.time) };
    return { ...past, telemetry, drawing: past.drawing ?? firstPoints(this.recording.drawing, drawn) };
  }
}

/** The last moment at a time, or of those with an event, the last one up to it. */
function indexAt(moments: readonly Moment[], time: number, event: number | null): number {
  const isAfter = ({ past }: Moment) =>
    past.time > time + 1e-6 || (event !== null && Math.abs(past.time - time) <= 1e-6 && past.event > event);
  const after = moments.findIndex(isAfter);
  return Math.max(0, (after < 0 ? moments.length : after) - 1);
}

/** Whether a step from one moment to its neighbour reaches what is wanted. */
function isWanted(from: Past, to: Past, step: number, kind: NonNullable<LookBack["to"]>, subject: string): boolean {
  const [before, after] = step > 0 ? [from, to] : [to, from];
  if (kind === "change") return variableOf(before, subject) !== variableOf(after, subject);
  if (kind === "run") return to.event !== from.event && to.line.block === subject;
  return to.event !== from.event;
}

function variableOf({ variables: { local, shared } }: Past, name: string): string | undefined {
  return local[name] ?? shared[name];
}

function isAbout(asked: Asked, subject: string): boolean {
  return asked.question.subject === subject;
}

function notFound(past: Past): Past {
  return { ...past, found: false };
}

function firstPoints(drawing: Drawing | null, count: number): Drawing | null {
  if (!drawing || count === 0) return null;
  let left = count;
  const parts = (drawing.parts ?? []).map((part) => {
    const points = part.points.slice(0, left);
    left -= points.length;
    return { ...part, points };
  });
  return { ...drawing, parts: parts.filter(({ points }) => points.length > 0) };
}
