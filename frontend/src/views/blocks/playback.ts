/** What the moving picture in the help shows at each moment: pure functions of what was recorded. */

import type { BlockHelp } from "./block-help";

type Happened = BlockHelp["events"][number];
export type Waypoint = BlockHelp["way"][number];

/** An event, and when it is played. */
export interface Frame {
  /** Seconds from the start of the picture. */
  readonly at: number;
  /** Seconds of the run. */
  readonly time: number;
  readonly kind: string;
  readonly text: string;
}

/** How long a step is shown at least, in seconds, so that one can see it. */
const SHORTEST = 0.45;
/** The last printed lines that are shown. */
const LINES = 3;
const SEEN = new Set(["line", "print"]);

/** When each event is played: as in the run, but slower where steps follow each other too fast to be seen. */
export function paced(events: readonly Happened[], end: number): readonly Frame[] {
  const frames: Frame[] = [];
  let before: Frame = { at: 0, time: 0, kind: "", text: "" };
  let least = 0;
  for (const [time, kind, text] of events) {
    const frame = { at: Math.max(before.at + time - before.time, least), time, kind, text };
    frames.push(frame);
    before = frame;
    least = SEEN.has(kind) ? frame.at + SHORTEST : Math.max(least, frame.at);
  }
  const rest = Math.max(0, end - before.time);
  return [
    ...frames,
    { at: Math.max(before.at + rest, least), time: Math.max(end, before.time), kind: "end", text: "" },
  ];
}

/** The seconds of the run that are shown after some seconds of the picture. */
export function timeAt(frames: readonly Frame[], played: number): number {
  let before = { at: 0, time: 0 };
  for (const frame of frames) {
    if (frame.at > played) {
      const part = (played - before.at) / (frame.at - before.at);
      return before.time + part * (frame.time - before.time);
    }
    before = frame;
  }
  return before.time;
}

/** Where the robot is at a moment of the run. */
export function placeAt(way: readonly Waypoint[], time: number): Waypoint | undefined {
  const next = way.findIndex(([at]) => at > time);
  const after = way[next < 0 ? way.length - 1 : next];
  const before = way[next < 0 ? way.length - 1 : Math.max(0, next - 1)];
  if (!before || !after || after[0] === before[0]) return after;
  const part = (time - before[0]) / (after[0] - before[0]);
  const [, x, y, heading] = before;
  return [time, x + part * (after[1] - x), y + part * (after[2] - y), heading + part * turned(heading, after[3])];
}

/** The degrees from one heading to another, the short way round. */
function turned(from: number, to: number): number {
  return ((to - from + 540) % 360) - 180;
}

/** Where the robot has been by a moment. */
export function wayUntil(way: readonly Waypoint[], time: number): readonly Waypoint[] {
  const now = placeAt(way, time);
  return [...way.filter(([at]) => at < time), ...(now ? [now] : [])];
}

/** What is seen at a moment, beside the robot's place. */
export interface Shown {
  /** The id of the block that runs; empty for none. */
  readonly block: string;
  /** The last lines that were printed. */
  readonly printed: readonly string[];
  /** The emotion of the robot's face; empty for none. */
  readonly face: string;
  /** The colour of its lamp as CSS writes it; empty while it is off. */
  readonly light: string;
  /** What else a device does, such as a text on a screen or a tone. */
  readonly sign: string;
}

export function shownAt(frames: readonly Frame[], played: number): Shown {
  const past = frames.filter(({ at }) => at <= played);
  const last = (kind: (name: string) => boolean) => past.findLast((frame) => kind(frame.kind));
  const isOver = past.at(-1)?.kind === "end";
  return {
    block: isOver ? "" : (last((kind) => kind === "line")?.text ?? ""),
    printed: past.flatMap(({ kind, text }) => (kind === "print" ? [text] : [])).slice(-LINES),
    face: last((kind) => kind === "Display.show_emotion")?.text ?? "",
    light: colour(last((kind) => kind === "RGBLed.set_color")?.text ?? ""),
    sign: signOf(last((kind) => kind in SIGNS)),
  };
}

/** How a command of a device is drawn; commands that are not here are seen otherwise. */
const SIGNS: Readonly<Record<string, (text: string) => string>> = {
  "Screen.show_text": (text) => text,
  "Speaker.say": (text) => `“${text}”`,
  "Speaker.play": (text) => `♪ ${text}`,
  "Speaker.tone": (text) => `♪ ${Math.round(Number.parseFloat(text))} Hz`,
  "Animator.play": (text) => text,
  "JointMotor.move": (text) => `↕ ${Math.round(Number.parseFloat(text))}°`,
};

function signOf(frame: Frame | undefined): string {
  return frame ? (SIGNS[frame.kind]?.(frame.text) ?? "") : "";
}

function colour(text: string): string {
  const parts = text.split(" ").map(Number);
  return parts.some((part) => part > 0) ? `rgb(${parts.join(" ")})` : "";
}

/** A line of the pen: its colour and the places of the robot while the pen was down. */
export interface Line {
  readonly colour: string;
  readonly places: readonly Waypoint[];
}

/** What the pen has drawn by a moment of the run. */
export function drawnAt(frames: readonly Frame[], way: readonly Waypoint[], time: number): readonly Line[] {
  let lines: Line[] = [];
  let ink = "";
  let since: number | null = null;
  const draw = (until: number) => {
    if (since === null) return;
    const from = since;
    const start = placeAt(way, from);
    const inside = wayUntil(way, until).filter(([at]) => at > from);
    lines.push({ colour: ink, places: start ? [start, ...inside] : inside });
  };
  for (const { time: at, kind, text } of frames) {
    if (at > time || !kind.startsWith("Pen.")) continue;
    if (kind === "Pen.set" || kind === "Pen.set_color") draw(at);
    if (kind === "Pen.set") since = text === "True" ? at : null;
    else if (kind === "Pen.set_color") ink = colour(text);
    else if (kind === "Pen.clear") lines = [];
    if (since !== null) since = at;
  }
  draw(time);
  return lines;
}
