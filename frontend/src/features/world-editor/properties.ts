/** The panel beside the plan: the selected object and its properties. */

import { effect, untracked } from "@preact/signals";
import { t } from "../../i18n";
import { Cleanup } from "../../ui/cleanup";
import type { Island } from "../../ui/island";
import { allThings, key, type Ref, same, thingAt } from "../../views/world/plan/sorts";
import type { VaryValues, WorldValues } from "../../views/world/scenery/description";
import { defaultsOf } from "./fields";
import { form } from "./form";
import { replaced } from "./things";
import type { Update } from "./updates";
import { nameOf } from "./words";
import type { WorldEdit } from "./world-edit";

export class Properties implements Island {
  readonly dom = document.createElement("div");
  private readonly select = document.createElement("select");
  private readonly fields = document.createElement("div");
  private readonly cleanup: Cleanup;

  constructor(private readonly draft: WorldEdit) {
    this.dom.className = "editor-properties";
    this.fields.className = "editor-fields";
    this.dom.append(this.select, this.fields);
    this.select.addEventListener("change", () => this.chosen());
    this.cleanup = new Cleanup(effect(() => this.show(draft.world.value, draft.selected.value)));
  }

  destroy(): void {
    this.cleanup.dispose();
    this.dom.remove();
  }

  private show(world: WorldValues | null, selected: Ref | null): void {
    if (!world) return;
    this.list(world, selected);
    // Keep the field that the user is typing in; it reads the newest values itself.
    const typing =
      this.shown === nameOfShown(selected) &&
      isTyped(document.activeElement) &&
      this.fields.contains(document.activeElement);
    this.shown = nameOfShown(selected);
    const made = selected ? this.ofThing(world, selected) : this.ofWorld(world);
    if (!typing) untracked(() => this.replace(made));
  }

  private shown = "";

  private replace(made: HTMLElement[]): void {
    const focused = this.fields.contains(document.activeElement)
      ? (document.activeElement as HTMLElement).dataset.key
      : undefined;
    this.fields.replaceChildren(...made);
    if (focused) this.fields.querySelector<HTMLElement>(`[data-key="${focused}"]`)?.focus();
  }

  private list(world: WorldValues, selected: Ref | null): void {
    this.select.ariaLabel = t("page-editor-selected");
    const options = allThings(world).map((ref) => new Option(nameOf(world, ref), key(ref), false, same(ref, selected)));
    this.select.replaceChildren(new Option(t("page-editor-world"), "", false, !selected), ...options);
  }

  private chosen(): void {
    const world = this.draft.world.peek();
    const ref = world && allThings(world).find((candidate) => key(candidate) === this.select.value);
    this.draft.select(ref ?? null);
  }

  private ofThing(world: WorldValues, ref: Ref): HTMLElement[] {
    const thing = thingAt(world, ref);
    return thing ? form(ref.sort, thing, (name, update) => this.changeThing(ref, name, update)) : [];
  }

  private changeThing(ref: Ref, name: string, update: Update<unknown>): void {
    const world = this.draft.world.peek();
    const thing = world && thingAt(world, ref);
    if (thing)
      this.draft.change(replaced(world, ref, { ...thing, [name]: update(thing[name]) }), `field ${key(ref)} ${name}`);
  }

  private ofWorld(world: WorldValues): HTMLElement[] {
    const { theme, ambient_light, sensor_noise, floor } = world;
    const own = form("world", { theme, ambient_light, sensor_noise }, (name, update) => {
      this.changeWorld(name, (now) => ({ ...now, [name]: update(now[name as "ambient_light"]) }));
    });
    const vary = form("vary", { ...varyOf(world) }, (name, update) => {
      this.changeWorld(`vary ${name}`, (now) => {
        const before = varyOf(now);
        return { ...now, vary: { ...before, [name]: update(before[name as "start"]) } };
      });
    });
    const ground = form("floor", { ...floor }, (name, update) => {
      this.changeWorld(name, (now) => ({
        ...now,
        floor: { ...now.floor, [name]: update(now.floor[name as "border"]) },
      }));
    });
    return [...own, ...ground, ...vary];
  }

  private changeWorld(name: string, update: Update<WorldValues>): void {
    const world = this.draft.world.peek();
    if (world) this.draft.change(update(world), `field world ${name}`);
  }
}

/** How variants of a world differ; by default they do not. */
function varyOf({ vary }: WorldValues): VaryValues {
  return vary ?? (defaultsOf("vary") as unknown as VaryValues);
}

function nameOfShown(ref: Ref | null): string {
  return ref ? key(ref) : "";
}

function isTyped(element: Element | null): boolean {
  return element instanceof HTMLInputElement && element.type !== "checkbox";
}
