/** The robot's camera picture, what was recognised in it, and the robot's face and lights. */

import "./panel.css";
import "./camera.css";

import { computed, effect } from "@preact/signals";
import { t } from "../../i18n";
import type { Context } from "../../model/context";
import type { CameraFrame, Past } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import type { Island } from "../../ui/island";
import { element } from "./elements";
import { findingName } from "./findings";
import { drawFrame } from "./picture";
import { createShown } from "./shown";
import { watchVisibility } from "./visibility";

/** A picture, and what was found in it. */
interface Taken {
  readonly frame: CameraFrame;
  readonly jpeg: Blob;
}

class Camera implements Island {
  readonly dom = element("section", { class: "robot-panel camera" });
  private readonly canvas = element("canvas", { role: "img", width: "320", height: "240" });
  private readonly none = element("p", { class: "nothing" });
  private readonly notKept = element("p", { class: "nothing" });
  private readonly found = element("ul", { class: "found" });
  private readonly shown: Island;
  private readonly visibility = watchVisibility(this.dom);
  private readonly cleanup: Cleanup;
  private frame: CameraFrame | null = null;
  /** The last picture of the present. */
  private live: Taken | null = null;
  /** Whether a picture of the past has been asked for, and the time for which there is one to ask for. */
  private asked = false;
  private wanted: number | null = null;
  private decoding = false;
  private watched = false;

  constructor(private readonly context: Context) {
    this.shown = createShown(context);
    this.dom.append(this.canvas, this.none, this.notKept, this.found, this.shown.dom);
    const { connection } = context;
    const hasCamera = computed(() => hasCameraIn(context));
    const watching = computed(() => hasCamera.value && this.visibility.visible.value);
    this.cleanup = new Cleanup(
      connection.on("CameraFrame", (frame) => (this.frame = frame)),
      connection.onFrame((jpeg) => void this.receive(jpeg)),
      connection.onRefused(["ReadPastPicture"], () => this.answered()),
      connection.on("Opened", () => (this.asked = false)),
      // A newly opened project, for example after a reconnection, does not send frames until asked.
      connection.on("Opened", () => watching.peek() && this.watch(true)),
      connection.on("TabOpened", () => watching.peek() && this.watch(true)),
      effect(() => this.watch(watching.value)),
      effect(() => this.follow(context.running.past.value, watching.value)),
      effect(() => this.label(hasCamera.value)),
    );
  }

  destroy(): void {
    this.cleanup.dispose();
    this.watch(false);
    this.visibility.destroy();
    this.shown.destroy();
  }

  private watch(on: boolean): void {
    if (!on && !this.watched) return;
    this.watched = on;
    this.context.connection.send({ kind: "WatchCamera", on });
  }

  private label(hasCamera: boolean): void {
    this.dom.setAttribute("aria-label", t("page-camera-camera"));
    this.canvas.setAttribute("aria-label", t("page-camera-picture"));
    this.found.setAttribute("aria-label", t("page-camera-found"));
    this.none.textContent = t("page-camera-no-camera");
    this.none.hidden = hasCamera;
    this.canvas.hidden = !hasCamera;
    if (!hasCamera) this.found.replaceChildren();
  }

  /** Show the moment that the user looks back at, or the present again. */
  private follow(past: Past | null, watching: boolean): void {
    const { timeline } = this.context.running;
    const kept = !past || (timeline.value?.exact ?? true);
    this.canvas.classList.toggle("not-kept", !kept);
    this.notKept.hidden = kept;
    this.notKept.textContent = t("page-camera-not-kept");
    this.wanted = past && kept && watching ? past.time : null;
    if (past) this.ask();
    else if (this.live) void this.show(this.live);
  }

  /** Ask for one picture of the past after the other, never for two at once. */
  private ask(): void {
    if (this.asked || this.wanted === null) return;
    this.asked = true;
    this.context.connection.send({ kind: "ReadPastPicture", time: this.wanted });
    this.wanted = null;
  }

  private answered(): void {
    this.asked = false;
    this.ask();
  }

  private receive(jpeg: Blob): void {
    const frame = this.frame;
    if (!frame) return;
    const isPast = this.context.running.past.peek() !== null;
    if (!frame.past) this.live = { frame, jpeg };
    if ((frame.past ?? false) === isPast) void this.show({ frame, jpeg });
    if (frame.past) this.answered();
  }

  /** A frame that arrives while another is being drawn is skipped. */
  private async show({ frame, jpeg }: Taken): Promise<void> {
    if (this.decoding) return;
    this.decoding = true;
    try {
      const image = await createImageBitmap(jpeg);
      drawFrame(this.canvas, image, frame, findingName);
      image.close();
      this.list((frame.seen ?? []).map(findingName));
    } catch (error) {
      console.warn("a camera frame could not be read", error);
    } finally {
      this.decoding = false;
    }
  }

  private list(names: readonly string[]): void {
    const items = [...this.found.children].map((item) => item.textContent);
    if (items.join("\n") === names.join("\n")) return;
    this.found.replaceChildren(...names.map((name) => element("li", {}, name)));
  }
}

/** Whether our robot has a camera. */
function hasCameraIn({ running }: Context): boolean {
  return (running.scene.value?.cameras ?? []).length > 0;
}

/** The robot's camera, requested only while it is visible. */
export function createCamera(context: Context): Island {
  return new Camera(context);
}
