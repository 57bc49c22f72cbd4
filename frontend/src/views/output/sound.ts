/** The robot's speech and sounds. */

import { effect } from "@preact/signals";
import { language } from "../../i18n";
import type { Context } from "../../model/context";
import { loudness } from "../../model/loudness";
import { preferences } from "../../model/preferences";
import type { Sound } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import { song, soundNamed } from "./melodies";
import { Proximity } from "./proximity";
import { Synthesizer } from "./synthesizer";

const VOLUME = 0.2;
/** The maximum number of queued sentences; more would not be finished in time anyway. */
const MOST_SENTENCES = 8;
const LONGEST_SENTENCE = 500;

/** The song that the music player will play. */
class Player {
  private folder = 1;
  private number = 1;
  private volume = 30;

  constructor(private readonly synthesizer: Synthesizer) {}

  obey(action: string, values: readonly unknown[]): void {
    if (action === "select") [this.folder, this.number] = [Number(values[0]), Number(values[1])];
    if (action === "volume") this.volume = Number(values[0]);
    if (action === "action") this.press(String(values[0]).toLowerCase());
  }

  private press(key: string): void {
    this.synthesizer.silence();
    if (!/play|next|prev/.test(key)) return;
    if (key.startsWith("next")) this.number += 1;
    if (key.startsWith("prev")) this.number = Math.max(1, this.number - 1);
    const tones = song(this.folder, this.number, (loudness() * VOLUME * this.volume) / 100);
    for (const tone of tones) this.synthesizer.play(tone);
  }
}

class Loudspeaker {
  private readonly synthesizer = new Synthesizer();
  private readonly player = new Player(this.synthesizer);
  private readonly proximity = new Proximity(this.synthesizer);
  private readonly cleanup: Cleanup;
  private sentences = 0;
  private hasSaidWhere = false;

  /**
   * @param sayWhere says that the sounds of a robot without a loudspeaker are heard here.
   */
  constructor(
    { connection, running }: Context,
    isHeard: () => boolean,
    private readonly sayWhere: () => void,
  ) {
    this.cleanup = new Cleanup(
      connection.on("Sound", (sound) => isHeard() && this.receive(sound)),
      connection.on("Opened", () => {
        this.hasSaidWhere = false;
        this.silence();
      }),
      connection.on("TabOpened", () => this.silence()),
      connection.on("RunState", ({ state }) => state === "starting" && this.silence()),
      connection.on("Ended", ({ ended }) => ended === "stopped" && this.silence()),
      connection.on("Telemetry", (telemetry) => {
        if (preferences.value.audible) this.proximity.receive(telemetry, performance.now() / 1000);
      }),
      effect(() => {
        if (!isHeard() || running.state.value.state === "paused") this.silence();
      }),
    );
  }

  destroy(): void {
    this.cleanup.dispose();
    this.silence();
    this.synthesizer.destroy();
  }

  private receive({ device, action, values, stand_in }: Sound): void {
    if (stand_in && !this.hasSaidWhere) {
      this.hasSaidWhere = true;
      this.sayWhere();
    }
    if (device === "MP3") this.player.obey(action, values);
    if (device !== "Speaker") return;
    if (action === "say") this.say(String(values[0]));
    if (action === "tone") this.tone(Number(values[0]), Number(values[1]) / 1000);
    if (action === "play")
      for (const tone of soundNamed(String(values[0]), loudness() * VOLUME)) this.synthesizer.play(tone);
  }

  private tone(hertz: number, seconds: number): void {
    this.synthesizer.play({ hertz, seconds, volume: loudness() * VOLUME });
  }

  private say(text: string): void {
    if (!("speechSynthesis" in window) || this.sentences >= MOST_SENTENCES) return;
    const sentence = new SpeechSynthesisUtterance(text.slice(0, LONGEST_SENTENCE));
    sentence.lang = language.value;
    sentence.volume = Math.min(1, loudness());
    this.sentences += 1;
    sentence.onend = sentence.onerror = () => (this.sentences = Math.max(0, this.sentences - 1));
    speechSynthesis.speak(sentence);
  }

  private silence(): void {
    this.synthesizer.silence();
    this.sentences = 0;
    if ("speechSynthesis" in window) speechSynthesis.cancel();
  }
}

/**
 * Start playing the robot's sounds while it is to be heard.
 *
 * @param sayWhere says, once for each project, that the sounds of a robot without a loudspeaker are heard here.
 */
export function startSound(context: Context, isHeard: () => boolean, sayWhere: () => void): { destroy(): void } {
  return new Loudspeaker(context, isHeard, sayWhere);
}
