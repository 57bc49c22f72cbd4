/** What appears in the world for a moment: confetti, notes, a flash. */

import { Group, type Object3D } from "three";

/** Something that is drawn until its time is over. */
export interface Effect {
  readonly object: Object3D;
  /** How long it lasts, ms. */
  readonly lasts: number;
  /** Draw it `age` ms after its beginning. */
  show(age: number): void;
  dispose(): void;
}

/** More at once would be slow, and too much to look at. */
const MOST = 8;

export class Effects {
  readonly object = new Group();
  /** The number of effects that have begun so far. */
  begun = 0;
  private running: { readonly effect: Effect; readonly since: number }[] = [];

  begin(effect: Effect, now: number): void {
    this.begun++;
    if (this.running.length >= MOST) this.end(this.running.shift()?.effect);
    this.running.push({ effect, since: now });
    effect.show(0);
    this.object.add(effect.object);
  }

  /** Draw all effects at `now`, in ms; return whether there are any. */
  step(now: number): boolean {
    if (this.running.length === 0) return false;
    for (const { effect, since } of this.running) {
      const age = Math.max(0, now - since);
      if (age < effect.lasts) effect.show(age);
      else this.end(effect);
    }
    this.running = this.running.filter(({ effect }) => effect.object.parent === this.object);
    return this.running.length > 0;
  }

  clear(): void {
    for (const { effect } of this.running) this.end(effect);
    this.running = [];
  }

  private end(effect: Effect | undefined): void {
    effect?.object.removeFromParent();
    effect?.dispose();
  }
}
