/** The server's problems with a world, each with its object. */

import { effect, signal } from "@preact/signals";
import { type Phrase, say, t } from "../../i18n";
import type { Connection } from "../../protocol/connection";
import type { FromPage } from "../../protocol/messages";
import type { Island } from "../../ui/island";
import { Throttle } from "../../ui/throttle";
import type { WorldValues } from "../../views/world/scenery/description";
import type { Draft } from "./drafts";
import { SORTS, type Sort } from "./sorts";
import { allThings, type Ref } from "./things";
import { nameOf } from "./words";

/** ms between two requests for a check. */
const PERIOD = 300;
/** The server names an object as in 'box[2]' or 'goal.reach[1].x', counting from 1. */
const NAMED = /'(?:goal\.)?(\w+)\[(\d+)\]/;

export class Checking implements Island {
  readonly dom = document.createElement("ul");
  readonly problems = signal<readonly Phrase[]>([]);
  private readonly asking = new Throttle(PERIOD);
  private readonly endings: (() => void)[];

  constructor(
    private readonly draft: Draft,
    connection: Connection,
  ) {
    this.dom.className = "editor-problems";
    this.dom.role = "status";
    this.endings = [
      connection.on("WorldChecked", ({ problems }) => (this.problems.value = problems)),
      effect(() => {
        const world = draft.world.value;
        if (world) this.asking.do(() => connection.send(question(world)));
      }),
      effect(() => this.show(this.problems.value)),
    ];
  }

  destroy(): void {
    for (const end of this.endings) end();
    this.asking.cancel();
    this.dom.remove();
  }

  private show(problems: readonly Phrase[]): void {
    this.dom.ariaLabel = t("page-editor-problems");
    this.dom.hidden = problems.length === 0;
    this.dom.replaceChildren(...problems.map((problem) => this.item(problem)));
  }

  private item(problem: Phrase): HTMLElement {
    const item = document.createElement("li");
    const sentence = say(problem);
    const ref = this.named(sentence);
    const world = this.draft.world.peek();
    if (ref && world) {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = nameOf(world, ref);
      button.addEventListener("click", () => this.draft.select(ref));
      item.append(button, " ");
    }
    item.append(sentence);
    return item;
  }

  private named(sentence: string): Ref | null {
    const [, sort = "", number = ""] = NAMED.exec(sentence) ?? [];
    const world = this.draft.world.peek();
    if (!world || !SORTS.includes(sort as Sort)) return null;
    return allThings(world).find((ref) => ref.sort === sort && ref.index === Number(number) - 1) ?? null;
  }
}

function question(world: WorldValues): FromPage {
  return { kind: "CheckWorld", world: world as unknown as Record<string, unknown> };
}
