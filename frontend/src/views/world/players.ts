/** Which of several robots the picture follows: all together, two side by side, or one. */

import { computed, effect, type ReadonlySignal, type Signal, signal } from "@preact/signals";
import { t } from "../../i18n";
import type { PlayerView } from "../../model/views";
import type { CameraMode } from "./cameras";
import type { Covered } from "./covered";
import { Halves, type Lens } from "./halves";
import type { XY } from "./scenery/description";

/** More robots than this are too many for a menu. */
const MOST = 4;

export interface Player {
  readonly name: string;
  readonly color: string | null;
}

interface Posed {
  readonly pose: { readonly x: number; readonly y: number };
}

export class Players {
  /** The names at the heads of the halves. */
  readonly dom = document.createElement("div");
  /** What the user can choose; nothing in a world with one robot. */
  readonly views: ReadonlySignal<readonly PlayerView[]>;
  private readonly players = signal<readonly Player[]>([]);
  /** The robots that are followed, by name; none for all of them. */
  private readonly chosen = signal<readonly string[]>([]);
  private readonly halves = new Halves();
  private readonly end: () => void;

  /**
   * @param mode of the camera: a choice changes it, and another one ends the view side by side.
   * @param look lets the camera begin to follow.
   */
  constructor(
    private readonly mode: Signal<CameraMode>,
    private readonly look: (mode: CameraMode) => void,
  ) {
    this.dom.className = "world-halves";
    this.views = computed(() => this.offered());
    this.end = effect(() => this.label());
  }

  /** The robots of the world, ours first; who is followed stays so, if it is still there. */
  join(players: readonly Player[]): void {
    const names = players.map(({ name }) => name);
    if (!this.chosen.peek().every((name) => names.includes(name)) || players.length < 2) {
      this.chosen.value = [];
      if (this.isSplit) this.look("follow");
    }
    this.players.value = players;
  }

  /** The numbers of the robots that are followed, among all of them. */
  followed(count: number): readonly number[] {
    const names = this.players.peek().map(({ name }) => name);
    const chosen = this.chosen.peek().map((name) => names.indexOf(name));
    return chosen.length ? chosen : Array.from({ length: count }, (_, i) => i);
  }

  /** The number of the only robot that is followed; null for several. */
  get alone(): number | null {
    const [name, other] = this.chosen.peek();
    if (name === undefined || other !== undefined) return null;
    return this.players.peek().findIndex((player) => player.name === name);
  }

  /** Whether two robots are followed in two halves. */
  get isSplit(): boolean {
    return this.mode.peek() === "split";
  }

  /** What is drawn side by side; nothing while there is one view. */
  get lenses(): readonly Lens[] {
    return this.isSplit ? this.halves.lenses : [];
  }

  /** See `Halves.size`. */
  size(width: number, height: number, covered: Covered): void {
    this.halves.size(width, height, covered);
    this.dom.classList.toggle("high", this.halves.isHigh);
  }

  zoom(factor: number): void {
    this.halves.zoom(factor);
  }

  /** Put the cameras of the halves before their robots. */
  start(robots: readonly Posed[]): void {
    this.halves.start(this.placesOf(robots));
  }

  /** Let the halves follow their robots; return whether a camera is still moving. */
  step(robots: readonly Posed[], now: number, calm: boolean): boolean {
    return this.isSplit && this.halves.step(this.placesOf(robots), now, calm);
  }

  /** Choose the next of what is offered. */
  next(): PlayerView | undefined {
    const views = this.views.peek();
    const view = views[(views.findIndex(({ on }) => on) + 1) % views.length];
    view?.choose();
    return view;
  }

  destroy(): void {
    this.end();
  }

  private placesOf(robots: readonly Posed[]): XY[] {
    return this.followed(robots.length).flatMap((i): XY[] => {
      const pose = robots[i]?.pose;
      return pose ? [[pose.x, pose.y]] : [];
    });
  }

  private offered(): PlayerView[] {
    const all = this.players.value.slice(0, MOST).map(({ name }) => name);
    const [own] = all;
    if (own === undefined || all.length < 2) return [];
    // In an order that the choice of a tab, which puts its robot first, does not change.
    const names = all.toSorted((one, other) => one.localeCompare(other));
    const pairs = names
      .filter((name) => name !== own)
      .map((name) => names.filter((one) => one === own || one === name));
    return [
      this.view("all", []),
      ...pairs.map((pair) => this.view("split", pair)),
      ...names.map((name) => this.view("one", [name])),
    ];
  }

  private view(kind: PlayerView["kind"], robots: readonly string[]): PlayerView {
    const mode = kind === "split" ? "split" : "follow";
    const [first = "", second = ""] = robots;
    return {
      kind,
      text: t(`page-world-players-${kind}`, { first, second }),
      on: this.mode.value === mode && this.chosen.value.join("\n") === robots.join("\n"),
      choose: () => {
        this.chosen.value = robots;
        this.look(mode);
      },
    };
  }

  private label(): void {
    const isSplit = this.mode.value === "split";
    const colors = new Map(this.players.value.map(({ name, color }) => [name, color]));
    this.dom.hidden = !isSplit;
    this.dom.replaceChildren(
      ...(isSplit ? this.chosen.value : []).map((name) => {
        const [half, plate] = [document.createElement("div"), document.createElement("b")];
        plate.textContent = name;
        plate.style.background = colors.get(name) ?? "";
        half.append(plate);
        return half;
      }),
    );
  }
}
