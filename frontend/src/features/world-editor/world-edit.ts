/** The edited world, with undo and redo. */

import { computed, signal } from "@preact/signals";
import type { Ref } from "../../views/world/plan/sorts";
import type { WorldValues } from "../../views/world/scenery/description";

const MOST_STEPS = 300;

interface State {
  readonly world: WorldValues;
  readonly selected: Ref | null;
}

/** A world and its selected object; every change can be undone. */
export class WorldEdit {
  private readonly state = signal<State | null>(null);
  private readonly past = signal<readonly State[]>([]);
  private readonly future = signal<readonly State[]>([]);
  private merging = "";

  readonly world = computed(() => this.state.value?.world ?? null);
  readonly selected = computed(() => this.state.value?.selected ?? null);
  readonly canUndo = computed(() => this.past.value.length > 0);
  readonly canRedo = computed(() => this.future.value.length > 0);

  /** Begin with a world. */
  open(world: WorldValues): void {
    this.past.value = this.future.value = [];
    this.merging = "";
    this.state.value = { world, selected: null };
  }

  select(selected: Ref | null): void {
    if (!this.state.value) return;
    this.merging = "";
    this.state.value = { ...this.state.value, selected };
  }

  /**
   * Store a changed world.
   *
   * @param merge consecutive changes with the same name are undone together.
   */
  change(world: WorldValues, merge = "", selected = this.selected.peek()): void {
    if (!this.state.value) return;
    if (!merge || merge !== this.merging) this.past.value = [...this.past.value, this.state.value].slice(-MOST_STEPS);
    this.merging = merge;
    this.future.value = [];
    this.state.value = { world, selected };
  }

  undo(): void {
    this.step(this.past, this.future);
  }

  redo(): void {
    this.step(this.future, this.past);
  }

  private step(from: typeof this.past, to: typeof this.past): void {
    const next = from.value.at(-1);
    if (!next || !this.state.value) return;
    to.value = [...to.value, this.state.value];
    from.value = from.value.slice(0, -1);
    this.merging = "";
    this.state.value = next;
  }
}
