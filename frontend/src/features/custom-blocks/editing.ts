/** The state of the custom block editor. */

import { computed, effect, signal } from "@preact/signals";
import { language, t } from "../../i18n";
import type { Context } from "../../model/context";
import { explained } from "../../model/run-error";
import type { CustomBlockProblem } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import { fetchPalette, type Palette } from "../../views/blocks/palette";
import { Code } from "./code";
import { CustomBlockEdit } from "./custom-block-edit";
import type { CustomBlocks } from "./custom-blocks";
import { Preview } from "./preview";
import { python } from "./python";
import { Trying } from "./trying";

export type TabName = "ownForm" | "ownTry" | "ownJson";

export class Editing {
  readonly draft: CustomBlockEdit;
  readonly trying: Trying;
  readonly source: Code;
  readonly json: Code;
  readonly preview = new Preview();
  readonly palette: Promise<Palette>;
  readonly tab = signal<TabName>("ownForm");
  /** The function shown in the form; the first one if the name is unknown. */
  readonly chosen = signal("");
  readonly block = computed(() => find(this.draft.blocks.value, this.chosen.value));
  readonly shown = computed(() => find(this.draft.previews.value, this.chosen.value));
  /** Problems of the source and configuration, and the error of the last test run. */
  readonly problems = computed(() => [...this.draft.problems.value, ...this.failure.value]);

  private readonly failure = computed(() => this.failureOf());
  private readonly cleanup: Cleanup;

  constructor(
    private readonly all: CustomBlocks,
    context: Context,
    name: string,
    line: number,
  ) {
    this.palette = fetchPalette(language.peek());
    this.draft = new CustomBlockEdit(context.connection);
    this.trying = new Trying(context);
    this.source = new Code(
      () => t("page-custom-source"),
      (source) => this.wrote({ source }),
      python(this.palette),
    );
    this.json = new Code(
      () => t("page-custom-json"),
      (configuration) => this.wrote({ configuration }),
      [],
    );
    this.cleanup = new Cleanup(
      effect(() => this.source.show(this.draft.written.value.source)),
      effect(() => this.json.show(this.draft.configuration.value)),
      effect(() => this.preview.showNow(this.shown.value)),
      effect(() => this.showProblems(this.problems.value)),
    );
    this.begin(name, line);
  }

  destroy(): void {
    this.cleanup.dispose();
    this.draft.destroy();
    this.trying.destroy();
  }

  /** Go to a problem. */
  goTo({ part, line = 0, column = 0 }: CustomBlockProblem): void {
    if (part === "source") this.source.goTo(line, column);
    if (part === "configuration") this.tab.value = "ownJson";
    // A tab that was hidden has no size before the next frame.
    if (part === "configuration") requestAnimationFrame(() => this.json.goTo(line, column));
  }

  /** Start when the server's list of blocks has arrived. */
  private begin(name: string, line: number): void {
    let begun = false;
    const begin = () => {
      const blocks = this.all.blocks.value;
      if (!blocks || begun) return;
      begun = true;
      const found = this.all.find(name);
      if (found) this.draft.open(found);
      else this.draft.create(stub(new Set(blocks.flatMap((one) => one.blocks))));
      if (line) requestAnimationFrame(() => this.source.goTo(line));
    };
    this.cleanup.add(effect(begin));
  }

  private wrote(change: { source: string } | { configuration: string }): void {
    this.trying.forget();
    this.draft.change(change);
  }

  private showProblems(problems: readonly CustomBlockProblem[]): void {
    this.source.showProblems(problems.filter(({ part, line }) => part === "source" && line));
    this.json.showProblems(problems.filter(({ part, line }) => part === "configuration" && line));
  }

  private failureOf(): readonly CustomBlockProblem[] {
    const ended = this.trying.ended.value;
    if (ended?.ended !== "error") return [];
    const { message, custom_line: line = 0 } = ended;
    return [{ part: "source", code: "run", severity: "error", message: { code: explained(message ?? "") }, line }];
  }
}

function find<Named extends { readonly name: string }>(all: readonly Named[], name: string): Named | null {
  return all.find((one) => one.name === name) ?? all[0] ?? null;
}

/** The source of a new block, with a function name that is still free. */
function stub(taken: ReadonlySet<string>): string {
  let name = "my_block";
  for (let number = 2; taken.has(name); number++) name = `my_block_${number}`;
  return `from typing import Annotated

from learnblock.fields import Range


def ${name}(robot, times: Annotated[int, Range(1, 10)] = 3) -> None:
    """${t("page-custom-stub")}"""
    for _ in range(times):
        print("${t("page-custom-hello")}")
        robot.sleep(0.5)
`;
}
