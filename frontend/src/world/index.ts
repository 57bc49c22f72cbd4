/** The world in 3D: what stands in it, the robots as they move, and the robot set down elsewhere. */

import "./world.css";

import { effect } from "@preact/signals";

import { t } from "../i18n";
import type { Island } from "../island";
import type { Context } from "../context";
import { World } from "./world";

/** The world as a part of the page. */
export interface WorldIsland extends Island {
  /** Take the size that the page gives it now. */
  resize(): void;
  /** Pictures drawn so far, for measuring. */
  readonly framesDrawn: number;
}

export function createWorld(context: Context): WorldIsland {
  try {
    return new World(context);
  } catch (error) {
    console.warn(error);
    return withoutPicture();
  }
}

/** What stands in the world's place where the browser cannot draw in 3D. */
function withoutPicture(): WorldIsland {
  const dom = document.createElement("p");
  dom.className = "world world-missing";
  const end = effect(() => {
    dom.textContent = t("world.no3d");
  });
  return { dom, framesDrawn: 0, resize: () => undefined, destroy: end };
}
