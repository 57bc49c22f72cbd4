/** A program's output as lines. */

import { t } from "../../i18n";
import type { PrintedPart } from "../../protocol/messages";
import { icon } from "../../ui/icons";
import { button, element } from "./elements";

/** Older lines are dropped. */
const MOST_LINES = 5000;
/** Older output beyond this, in characters, is dropped before layout. */
const MOST_WAITING = 2_000_000;

/** Asks why a text was printed; `after` is the number of texts that this run has printed since. */
type Ask = (text: string, after: number) => void;

export type Sort = "printed" | "run" | "note" | "warned" | "good" | "bad" | "asked";

/** A line of the page itself. */
export interface OwnLine {
  readonly sort: Sort;
  words(): string;
  /** Whether it is about the end of the run, which is later than all others. */
  readonly isEnd?: boolean;
  /** Where it leads, if anywhere. */
  readonly lead?: { words(): string; go(): void };
}

/** The lines, added once per frame and scrolled to the end unless the user has scrolled back. */
export class Lines {
  readonly dom = element("div", { class: "console-lines scroll", role: "log", tabindex: "0" });
  private waiting: PrintedPart[] = [];
  private waitingLength = 0;
  /** How many characters of the run each robot has printed with all that is waiting. */
  private readonly until = new Map<string, number>();
  /** For each line of this run, how many characters were printed before it. */
  private starts = new WeakMap<Element, number>();
  /** How many characters had been printed at the moment that is shown; null for the present. */
  private shown: number | null = null;
  private frame = 0;
  /** The last line of each robot that has not printed its end yet. */
  private readonly open = new Map<string, HTMLElement>();
  /** The robot whose run is shown, if several print here; else empty. */
  private robot = "";
  private following = true;
  private readonly own = new Map<Element, OwnLine>();

  /** Asks about the line that the pointer or the focus is on. */
  private readonly why = button("why-line", () => this.askAbout(this.why.parentElement));

  constructor(private readonly ask: Ask) {
    this.why.append(icon("why"));
    this.why.tabIndex = -1;
    this.dom.addEventListener("pointerover", ({ target }) => this.offer(target));
    this.dom.addEventListener("keydown", (event) => this.pressed(event));
    this.dom.onscroll = () => {
      const { scrollHeight, scrollTop, clientHeight } = this.dom;
      this.following = scrollHeight - scrollTop - clientHeight < 12;
    };
  }

  /** Add printed text; a line may come in pieces, with lines of other robots in between. */
  print(part: PrintedPart): void {
    this.waiting.push(part);
    this.waitingLength += part.text.length;
    while (this.waitingLength > MOST_WAITING) this.waitingLength -= this.waiting.shift()?.text.length ?? 0;
    this.until.set(part.robot, part.until);
    this.frame ||= requestAnimationFrame(() => this.flush());
  }

  /** Of several robots that print here, show this one's past, and ask about its lines. */
  show(robot: string): void {
    this.robot = robot;
    this.why.remove();
  }

  /** From here on, the lines are those of another run. */
  beginRun(): void {
    this.flush();
    this.starts = new WeakMap();
    this.until.clear();
    this.open.clear();
  }

  /** Dim the lines that were printed after a moment, given by the characters before it; null for none. */
  showUntil(printed: number | null): void {
    if (printed === this.shown) return;
    this.shown = printed;
    this.flush();
    for (const line of this.dom.children) this.dim(line);
    if (printed !== null) this.scrollToNow();
    else this.follow();
  }

  /** Add a line of the page itself. */
  add(own: OwnLine): void {
    this.flush();
    this.open.clear();
    const line = element("div", { class: own.sort }, "");
    if (own.lead) line.append(button("text-link lead", own.lead.go));
    write(line, own);
    this.own.set(line, own);
    // Just before what is printed next: it belongs to the moment at which so much was printed.
    this.starts.set(line, own.isEnd ? Number.POSITIVE_INFINITY : (this.until.get(this.robot) ?? 0) - 0.5);
    this.dim(line);
    this.append([line]);
  }

  /** Write the page's own lines again, in a different language or for another view. */
  translate(): void {
    for (const [line, own] of this.own) write(line, own);
    this.why.title = t("page-why-printed");
    this.why.ariaLabel = t("page-why-printed");
  }

  clear(): void {
    this.own.clear();
    this.waiting = [];
    this.waitingLength = 0;
    this.open.clear();
    this.dom.replaceChildren();
    this.following = true;
  }

  text(): string {
    this.flush();
    return [...this.dom.children].map(spoken).join("\n");
  }

  /** Show the end after the panel was hidden or resized. */
  follow(): void {
    if (this.following) this.dom.scrollTop = this.dom.scrollHeight;
  }

  destroy(): void {
    cancelAnimationFrame(this.frame);
  }

  /** Put the question's button on a line that can be asked about. */
  private offer(target: EventTarget | null): void {
    const line = target instanceof Element ? target.closest<HTMLElement>(".printed") : null;
    if (line && this.isShown(line) && line !== this.why.parentElement && printedSince(line) !== null)
      line.append(this.why);
  }

  /** Whether a line is of the run that questions are about. */
  private isShown(line: Element): boolean {
    return ["", this.robot].includes(robotOf(line) ?? "");
  }

  private askAbout(line: Element | null): void {
    const after = line && printedSince(line);
    if (line && this.isShown(line) && after !== null) this.ask(textOf(line), after);
  }

  /** Arrow keys go from line to line; Enter asks about it. */
  private pressed(event: KeyboardEvent): void {
    const here = document.activeElement?.closest(".console-lines > .printed") ?? null;
    const next = neighbour(this.dom, here, event.key);
    if (next) {
      next.focus();
      this.offer(next);
    } else if (event.key === "Enter" && here) this.askAbout(here);
    else return;
    event.preventDefault();
  }

  private flush(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const parts = this.waiting;
    this.waiting = [];
    this.waitingLength = 0;
    this.append(parts.flatMap((part) => this.linesOf(part)).slice(-MOST_LINES));
  }

  /** The new lines of a part, whose first piece may belong to an unfinished line. */
  private linesOf({ robot, text, until }: PrintedPart): HTMLElement[] {
    const pieces = text.split(/\r?\n/);
    let start = until - text.length;
    const open = this.open.get(robot);
    if (open) {
      const piece = pieces.shift() ?? "";
      open.append(piece);
      start += piece.length + 1;
      if (pieces.length > 0) this.open.delete(robot);
    }
    // Behind the end of the last line nothing is begun yet.
    const isUnfinished = pieces.at(-1) !== "";
    if (!isUnfinished) pieces.pop();
    const lines = pieces.map((piece) => {
      const line = this.line(robot, piece, start);
      start += piece.length + 1;
      return line;
    });
    const last = lines.at(-1);
    if (isUnfinished && last) this.open.set(robot, last);
    return lines;
  }

  private line(robot: string, text: string, start: number): HTMLElement {
    const line = element("div", { class: "printed", tabindex: "-1" }, text);
    if (robot) {
      line.dataset.robot = robot;
      line.prepend(element("b", { class: "robot" }, robot));
    }
    this.starts.set(line, start);
    this.dim(line);
    return line;
  }

  /** Dim a line if it was printed later than the moment that is shown. */
  private dim(line: Element): void {
    // When other robots printed is not known in the time of this one.
    const isOther = ![null, "", this.robot].includes(robotOf(line));
    line.toggleAttribute("hidden", this.shown !== null && isOther);
    const later = this.shown !== null && (this.starts.get(line) ?? -1) >= this.shown;
    if (later === line.classList.contains("later")) return;
    line.classList.toggle("later", later);
    if (later) line.setAttribute("aria-hidden", "true");
    else line.removeAttribute("aria-hidden");
  }

  /** Scroll to the last line of the moment that is shown. */
  private scrollToNow(): void {
    const now = [...this.dom.children].findLast((line) => !line.classList.contains("later"));
    if (!now || this.dom.clientHeight === 0) return;
    const [frame, line] = [this.dom.getBoundingClientRect(), now.getBoundingClientRect()];
    if (line.top < frame.top) this.dom.scrollTop -= frame.top - line.top;
    if (line.bottom > frame.bottom) this.dom.scrollTop += line.bottom - frame.bottom;
  }

  private append(lines: readonly HTMLElement[]): void {
    this.dom.append(...lines);
    while (this.dom.childElementCount > MOST_LINES) this.removeFirst();
    if (this.shown === null) this.follow();
  }

  private removeFirst(): void {
    const first = this.dom.firstElementChild;
    if (!first) return;
    this.own.delete(first);
    first.remove();
  }
}

/** The words of a line of the page itself, before the button that leads on. */
function write(line: Element, { words, lead }: OwnLine): void {
  const text = line.firstChild;
  if (text) text.textContent = lead ? `${words()} ` : words();
  const button = line.querySelector<HTMLElement>(".lead");
  if (!button || !lead) return;
  button.textContent = lead.words();
  button.hidden = !button.textContent;
}

/** A line's text, without the button on it. */
function textOf(line: Element): string {
  return [...line.childNodes].map((part) => (part instanceof Text ? part.data : "")).join("");
}

/** The robot that has printed a line, empty if it is the only one here; null for a line of the page itself. */
function robotOf(line: Element): string | null {
  if (!line.classList.contains("printed")) return null;
  return (line instanceof HTMLElement && line.dataset.robot) || "";
}

/** A line's text after the name of its robot, if several print here. */
function spoken(line: Element): string {
  const robot = robotOf(line);
  if (robot === null) return line.textContent ?? "";
  return robot ? `${robot}: ${textOf(line)}` : textOf(line);
}

/** How many lines the same run has printed after a line; null if it was an earlier run. */
function printedSince(line: Element): number | null {
  let count = 0;
  for (let next = line.nextElementSibling; next; next = next.nextElementSibling) {
    if (next.classList.contains("run")) return null;
    if (robotOf(next) === robotOf(line) && textOf(next)) count += 1;
  }
  return count;
}

/** The printed line to go to with a key; the last one at first. */
function neighbour(lines: Element, here: Element | null, key: string): HTMLElement | null {
  if (key !== "ArrowUp" && key !== "ArrowDown") return null;
  const next = (one: Element) => (key === "ArrowUp" ? one.previousElementSibling : one.nextElementSibling);
  let found = here ? next(here) : key === "ArrowUp" ? lines.lastElementChild : null;
  while (found && !(found.classList.contains("printed") && textOf(found))) found = next(found);
  return found as HTMLElement | null;
}
