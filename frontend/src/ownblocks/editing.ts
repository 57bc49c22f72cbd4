/** All parts of the dialog in which one block is edited. */

import { computed, effect, signal } from "@preact/signals";

import { fetchPalette, type Palette } from "../blocks/palette";
import type { Page } from "../chrome/page";
import { language, t } from "../i18n";
import type { OwnBlockProblem } from "../messages";
import { explained } from "../runerror";
import { Code } from "./code";
import { Draft } from "./draft";
import { Preview } from "./preview";
import { python } from "./python";
import { Trying } from "./trying";

export type TabName = "ownForm" | "ownTry" | "ownJson";

export class Editing {
  readonly draft: Draft;
  readonly trying: Trying;
  readonly source: Code;
  readonly json: Code;
  readonly preview = new Preview();
  readonly palette: Promise<Palette>;
  readonly tab = signal<TabName>("ownForm");
  /** The function that the form speaks of; the first where it is none of them. */
  readonly chosen = signal("");
  readonly block = computed(() => find(this.draft.blocks.value, this.chosen.value));
  readonly shown = computed(() => find(this.draft.previews.value, this.chosen.value));
  /** What is wrong with what is written, and what went wrong when it was tried. */
  readonly problems = computed(() => [...this.draft.problems.value, ...this.failure.value]);

  private readonly failure = computed(() => this.failureOf());
  private readonly ends: (() => void)[];

  constructor(
    private readonly page: Page,
    name: string,
    line: number,
  ) {
    const { context } = page;
    this.palette = fetchPalette(language.peek());
    this.draft = new Draft(context.connection);
    this.trying = new Trying(context);
    this.source = new Code(() => t("ownblocks.source"), (source) => this.wrote({ source }), python(this.palette));
    this.json = new Code(() => t("ownblocks.json"), (configuration) => this.wrote({ configuration }), []);
    this.ends = [
      effect(() => this.source.show(this.draft.written.value.source)),
      effect(() => this.json.show(this.draft.configuration.value)),
      effect(() => this.preview.show(this.shown.value)),
      effect(() => this.showProblems(this.problems.value)),
    ];
    this.begin(name, line);
  }

  destroy(): void {
    for (const end of this.ends) end();
    this.draft.destroy();
    this.trying.destroy();
  }

  /** Go to where a problem is. */
  goTo({ part, line = 0, column = 0 }: OwnBlockProblem): void {
    if (part === "source") this.source.goTo(line, column);
    if (part === "configuration") this.tab.value = "ownJson";
    // A tab that was hidden has its size only with the next frame.
    if (part === "configuration") requestAnimationFrame(() => this.json.goTo(line, column));
  }

  /** Begin as soon as the server has told which blocks there are. */
  private begin(name: string, line: number): void {
    let begun = false;
    const begin = () => {
      const blocks = this.page.shelf.blocks.value;
      if (!blocks || begun) return;
      begun = true;
      const found = this.page.shelf.find(name);
      if (found) this.draft.open(found);
      else this.draft.create(stub(new Set(blocks.flatMap((one) => one.blocks))));
      if (line) requestAnimationFrame(() => this.source.goTo(line));
    };
    this.ends.push(effect(begin));
  }

  private wrote(change: { source: string } | { configuration: string }): void {
    this.trying.forget();
    this.draft.change(change);
  }

  private showProblems(problems: readonly OwnBlockProblem[]): void {
    this.source.showProblems(problems.filter(({ part, line }) => part === "source" && line));
    this.json.showProblems(problems.filter(({ part, line }) => part === "configuration" && line));
  }

  private failureOf(): readonly OwnBlockProblem[] {
    const ended = this.trying.ended.value;
    if (ended?.ended !== "error") return [];
    const { message = "", own_line: line = 0 } = ended;
    return [{ part: "source", code: "run", severity: "error", message: explained(message), line }];
  }
}

function find<Named extends { readonly name: string }>(all: readonly Named[], name: string): Named | null {
  return all.find((one) => one.name === name) ?? all[0] ?? null;
}

/** What a new block begins with, under a name that no block of the user's has. */
function stub(taken: ReadonlySet<string>): string {
  let name = "my_block";
  for (let number = 2; taken.has(name); number++) name = `my_block_${number}`;
  return `from typing import Annotated

from learnblock.fields import Range


def ${name}(robot, times: Annotated[int, Range(1, 10)] = 3) -> None:
    """${t("ownblocks.stub")}"""
    for _ in range(times):
        print("${t("ownblocks.hello")}")
        robot.sleep(0.5)
`;
}
