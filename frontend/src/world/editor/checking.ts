/** What the server finds wrong with a world, each beside the thing that it names. */

import { effect, signal } from "@preact/signals";

import type { WorldValues } from "../description";
import { Throttle } from "../throttle";
import type { Draft } from "./drafts";
import { allThings, type Ref, type Sort, SORTS } from "./things";
import { nameOf } from "./words";
import type { Connection } from "../../connection";
import { t } from "../../i18n";
import type { Island } from "../../island";
import type { FromPage } from "../../messages";
import { said } from "../../sentences";

/** ms between two questions. */
const PERIOD = 300;
/** The server names a thing as in ``box[2]`` or ``goal.reach[1].x``, counting from 1. */
const NAMED = /`(?:goal\.)?(\w+)\[(\d+)\]/;

export class Checking implements Island {
  readonly dom = document.createElement("ul");
  readonly problems = signal<readonly string[]>([]);
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

  private show(problems: readonly string[]): void {
    this.dom.ariaLabel = t("editor.problems");
    this.dom.hidden = problems.length === 0;
    this.dom.replaceChildren(...problems.map((problem) => this.item(problem)));
  }

  private item(problem: string): HTMLElement {
    const item = document.createElement("li");
    const ref = this.named(problem);
    const world = this.draft.world.peek();
    if (ref && world) {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = nameOf(world, ref);
      button.addEventListener("click", () => this.draft.select(ref));
      item.append(button, " ");
    }
    item.append(said(problem).replaceAll("`", ""));
    return item;
  }

  private named(problem: string): Ref | null {
    const [, sort = "", number = ""] = NAMED.exec(problem) ?? [];
    const world = this.draft.world.peek();
    if (!world || !SORTS.includes(sort as Sort)) return null;
    return allThings(world).find((ref) => ref.sort === sort && ref.index === Number(number) - 1) ?? null;
  }
}

function question(world: WorldValues): FromPage {
  return { kind: "CheckWorld", world: world as unknown as Record<string, unknown> };
}
