/** The world in 3D: its objects, the moving robots, and placing the robot. */

import "./world.css";

import { effect, signal } from "@preact/signals";

import { t } from "../../i18n";
import type { Context } from "../../model/context";
import type { WorldIsland } from "../../model/views";
import { World } from "./world";

export function createWorld(context: Context): WorldIsland {
  try {
    return new World(context);
  } catch (error) {
    console.warn(error);
    return withoutPicture();
  }
}

/** The replacement for the world if the browser cannot draw in 3D. */
function withoutPicture(): WorldIsland {
  const dom = document.createElement("p");
  dom.className = "world world-missing";
  const end = effect(() => {
    dom.textContent = t("page-world-no3d");
  });
  const nothing = () => undefined;
  const shown = { point: nothing, showMissed: nothing, circle: nothing, lookAt: nothing };
  return {
    dom,
    framesDrawn: 0,
    tools: [],
    playerViews: signal([]),
    hint: signal(""),
    resize: nothing,
    drawBest: nothing,
    ...shown,
    destroy: end,
  };
}
