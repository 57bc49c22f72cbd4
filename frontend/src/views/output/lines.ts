/** A program's output as lines. */

import { element } from "./elements";

/** Older lines are dropped. */
const MOST_LINES = 5000;
/** Older output beyond this, in characters, is dropped before layout. */
const MOST_WAITING = 2_000_000;

export type Sort = "printed" | "note" | "good" | "bad" | "asked";

/** The lines, added once per frame and scrolled to the end unless the user has scrolled back. */
export class Lines {
  readonly dom = element("div", { class: "console-lines scroll", role: "log", tabindex: "0" });
  private waiting = "";
  private frame = 0;
  private open: HTMLElement | null = null;
  private following = true;
  /** The words of the page's own lines, in the language in use. */
  private readonly own = new Map<Element, () => string>();

  constructor() {
    this.dom.onscroll = () => {
      const { scrollHeight, scrollTop, clientHeight } = this.dom;
      this.following = scrollHeight - scrollTop - clientHeight < 12;
    };
  }

  /** Add printed text; a line may come in pieces. */
  print(text: string): void {
    this.waiting = (this.waiting + text).slice(-MOST_WAITING);
    this.frame ||= requestAnimationFrame(() => this.flush());
  }

  /** Add a line of the page itself. */
  add(words: () => string, sort: Sort): void {
    this.flush();
    if (this.open?.textContent === "") this.open.remove();
    this.open = null;
    const line = element("div", { class: sort }, words());
    this.own.set(line, words);
    this.append([line]);
  }

  /** Translate the page's own lines into a different language. */
  translate(): void {
    for (const [line, words] of this.own) line.textContent = words();
  }

  clear(): void {
    this.own.clear();
    this.waiting = "";
    this.open = null;
    this.dom.replaceChildren();
    this.following = true;
  }

  text(): string {
    this.flush();
    return [...this.dom.children].map((line) => line.textContent).join("\n");
  }

  /** Show the end after the panel was hidden or resized. */
  follow(): void {
    if (this.following) this.dom.scrollTop = this.dom.scrollHeight;
  }

  destroy(): void {
    cancelAnimationFrame(this.frame);
  }

  private flush(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    if (!this.waiting) return;
    const pieces = this.waiting.split(/\r?\n/);
    this.waiting = "";
    this.continueLine(pieces);
    this.append(pieces.slice(-MOST_LINES).map((piece) => element("div", { class: "printed" }, piece)));
    this.leaveOpen();
  }

  /** The first piece belongs to the unfinished line. */
  private continueLine(pieces: string[]): void {
    if (!this.open) return;
    this.open.append(pieces.shift() ?? "");
    if (pieces.length > 0) this.open = null;
  }

  /** The last line is unfinished; an empty one is not shown. */
  private leaveOpen(): void {
    const last = this.dom.lastElementChild;
    if (last?.className !== "printed") return;
    this.open = last as HTMLElement;
  }

  private append(lines: readonly HTMLElement[]): void {
    this.dom.append(...lines);
    while (this.dom.childElementCount > MOST_LINES) this.removeFirst();
    this.follow();
  }

  private removeFirst(): void {
    const first = this.dom.firstElementChild;
    if (!first) return;
    this.own.delete(first);
    first.remove();
  }
}
