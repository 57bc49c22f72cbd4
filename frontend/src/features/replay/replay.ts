/** The last seconds of a run again, from a camera that goes round the robots; they can be saved as a film. */

import { computed, effect, signal } from "@preact/signals";

import type { Page } from "../../model/page";
import type { Film } from "../share/film";
import type { Share } from "../share/share";

/** How much of the run is shown, s. */
const LENGTH = 10;
/** Moments in a second: the picture moves smoothly between them. */
const RATE = 15;
/** How long the end is shown, ms. */
const LAST_LOOK = 800;

type Parts = Pick<Page, "context" | "lookingBack" | "views"> & { readonly share: Share };

export class Replay {
  readonly isShown = signal(false);
  /** How many seconds it shows. */
  readonly seconds = computed(() => Math.min(LENGTH, this.end));
  private timer = 0;
  private began = 0;
  private film: Film | null = null;

  constructor(private readonly page: Parts) {
    const { running } = page.context;
    let wasPast = false;
    effect(() => {
      // Another run, or the user, has left the past.
      const isPast = running.past.value !== null;
      if (wasPast && !isPast) this.stop();
      wasPast = isPast;
    });
  }

  /** Show the end of the run again. */
  watch(): void {
    if (!this.isShown.peek()) this.page.views.world.peek()?.circle(true);
    this.isShown.value = true;
    window.clearInterval(this.timer);
    this.began = performance.now();
    this.timer = window.setInterval(() => this.step(), 1000 / RATE);
    this.step();
  }

  /** Show it from its beginning, and save a film of it when it ends. */
  save(): void {
    this.watch();
    this.film = this.page.share.record(() => (this.film = null));
  }

  /** Show the end of the game as before; a film that has not ended is dropped. */
  stop(): void {
    if (!this.isShown.peek()) return;
    this.film?.drop();
    this.finish();
  }

  private get end(): number {
    return this.page.context.running.timeline.value?.end ?? 0;
  }

  private step(): void {
    const passed = performance.now() - this.began;
    const length = 1000 * this.seconds.peek();
    if (passed < length + LAST_LOOK) this.page.lookingBack.look(this.end - Math.max(0, length - passed) / 1000);
    else {
      this.film?.end();
      this.finish();
    }
  }

  private finish(): void {
    const { lookingBack, views } = this.page;
    window.clearInterval(this.timer);
    this.isShown.value = false;
    views.world.peek()?.circle(false);
    lookingBack.leave();
  }
}

declare module "../../model/page" {
  interface Page {
    readonly replay: Replay;
  }
}
