/** The server's problems with a world, each with its object. */

import { batch, computed, effect, signal } from "@preact/signals";
import { type Phrase, say, t } from "../../i18n";
import type { Connection } from "../../protocol/connection";
import type { FromPage, UnreachableGoal } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import type { Island } from "../../ui/island";
import { Throttle } from "../../ui/throttle";
import { allThings, type Ref, SORTS, type Sort } from "../../views/world/plan/sorts";
import type { WorldValues } from "../../views/world/scenery/description";
import { nameOf } from "./words";
import type { WorldEdit } from "./world-edit";

/** ms between two requests for a check. */
const PERIOD = 300;
/** The server names an object as in 'box[2]' or 'goal.reach[1].x', counting from 1. */
const NAMED = /'(?:goal\.)?(\w+)\[(\d+)\]/;

export class Checking implements Island {
  readonly dom = document.createElement("ul");
  readonly problems = signal<readonly Phrase[]>([]);
  /** Why goals can't be reached, by their key. */
  readonly unreachable = computed(
    () => new Map(this.goals.value.map(({ sort, index, reason }) => [`${sort}:${index}`, say(reason)])),
  );
  private readonly goals = signal<readonly UnreachableGoal[]>([]);
  private readonly asking = new Throttle(PERIOD);
  private readonly cleanup: Cleanup;

  constructor(
    private readonly draft: WorldEdit,
    connection: Connection,
  ) {
    this.dom.className = "editor-problems";
    this.dom.role = "status";
    this.cleanup = new Cleanup(
      connection.on("WorldChecked", ({ problems, unreachable = [] }) => this.told(problems, unreachable)),
      effect(() => {
        const world = draft.world.value;
        if (world) this.asking.do(() => connection.send(question(world)));
      }),
      effect(() => this.show(this.problems.value, this.goals.value)),
    );
  }

  destroy(): void {
    this.cleanup.dispose();
    this.asking.cancel();
    this.dom.remove();
  }

  private told(problems: readonly Phrase[], unreachable: readonly UnreachableGoal[]): void {
    batch(() => {
      this.problems.value = problems;
      // The plan is redrawn only if the goals have changed.
      if (JSON.stringify(unreachable) !== JSON.stringify(this.goals.peek())) this.goals.value = unreachable;
    });
  }

  private show(problems: readonly Phrase[], goals: readonly UnreachableGoal[]): void {
    this.dom.ariaLabel = t("page-editor-problems");
    this.dom.hidden = problems.length + goals.length === 0;
    const wrong = problems.map((problem) => this.item(say(problem), this.named(say(problem))));
    const far = goals.map(({ sort, index, reason }) => this.item(say(reason), { sort: sort as Sort, index }));
    for (const item of far) item.className = "far";
    this.dom.replaceChildren(...wrong, ...far);
  }

  private item(sentence: string, ref: Ref | null): HTMLElement {
    const item = document.createElement("li");
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
  return { kind: "CheckWorld", world };
}
