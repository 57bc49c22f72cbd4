/** What the robot's camera sees, what was found in it, and what the robot itself shows. */

import "./panel.css";
import "./camera.css";

import { computed, effect } from "@preact/signals";

import type { Context } from "../context";
import { t } from "../i18n";
import type { Island } from "../island";
import type { CameraFrame } from "../messages";
import { element } from "./elements";
import { findingName } from "./findings";
import { drawFrame } from "./picture";
import { createShown } from "./shown";
import { watchVisibility } from "./visibility";

class Camera implements Island {
  readonly dom = element("section", { class: "robot-panel camera" });
  private readonly canvas = element("canvas", { role: "img", width: "320", height: "240" });
  private readonly none = element("p", { class: "nothing" });
  private readonly found = element("ul", { class: "found" });
  private readonly shown: Island;
  private readonly visibility = watchVisibility(this.dom);
  private readonly disposers: (() => void)[];
  private frame: CameraFrame | null = null;
  private decoding = false;
  private watched = false;

  constructor(private readonly context: Context) {
    this.shown = createShown(context);
    this.dom.append(this.canvas, this.none, this.found, this.shown.dom);
    const { connection } = context;
    const hasCamera = computed(() => hasCameraIn(context));
    const watching = computed(() => hasCamera.value && this.visibility.visible.value);
    this.disposers = [
      connection.on("CameraFrame", (frame) => (this.frame = frame)),
      connection.onFrame((jpeg) => void this.show(jpeg)),
      // A project that is opened, as after a lost connection, knows of nobody who watches.
      connection.on("Opened", () => watching.peek() && this.watch(true)),
      effect(() => this.watch(watching.value)),
      effect(() => this.label(hasCamera.value)),
    ];
  }

  destroy(): void {
    for (const dispose of this.disposers) dispose();
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
    this.dom.setAttribute("aria-label", t("robot.camera"));
    this.canvas.setAttribute("aria-label", t("robot.picture"));
    this.found.setAttribute("aria-label", t("robot.found"));
    this.none.textContent = t("robot.noCamera");
    this.none.hidden = hasCamera;
    this.canvas.hidden = !hasCamera;
    if (!hasCamera) this.found.replaceChildren();
  }

  /** A frame that comes while another is being drawn is left out. */
  private async show(jpeg: Blob): Promise<void> {
    const frame = this.frame;
    if (!frame || this.decoding) return;
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

/** Whether our robot, the first of the scene, has a camera. */
function hasCameraIn({ running }: Context): boolean {
  const cameras = running.scene.value?.robots[0]?.[1].camera;
  return Array.isArray(cameras) && cameras.length > 0;
}

/** The robot's camera, watched only while it can be seen. */
export function createCamera(context: Context): Island {
  return new Camera(context);
}
