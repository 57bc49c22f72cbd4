/** The robot's face and lights. */

import { computed, effect } from "@preact/signals";
import { t } from "../../i18n";
import type { Context } from "../../model/context";
import { face } from "../../ui/face";
import type { Island } from "../../ui/island";
import { element } from "./elements";
import { emotionName } from "./emotions";

type Led = readonly [name: string, colour: readonly [number, number, number]];

function lamp([name, [red, green, blue]]: Led): HTMLElement {
  const light = element("span", { class: "lamp", "aria-hidden": "true" });
  light.style.background = `rgb(${red} ${green} ${blue})`;
  const state = red + green + blue > 0 ? `${red}, ${green}, ${blue}` : t("page-camera-off");
  return element(
    "li",
    { title: `${name}: ${state}` },
    light,
    element("span", {}, name),
    element("span", { class: "hidden" }, state),
  );
}

/** A small display of the robot's face and lights; empty for a robot without them. */
export function createShown(context: Context): Island {
  const dom = element("div", { class: "shown" });
  const robot = computed(() => context.running.telemetry.value?.robots[0]);
  // As one text, so equal values are not redrawn 20 times per second.
  const content = computed(() =>
    JSON.stringify([robot.value?.emotion ?? "none", Object.entries(robot.value?.leds ?? {})]),
  );

  function show(): void {
    const [emotion, leds] = JSON.parse(content.value) as [string, Led[]];
    const name = emotionName(emotion);
    const shown = name ? [face(emotion), element("span", {}, name)] : [];
    const lamps = leds.length > 0 ? [element("ul", { "aria-label": t("page-camera-lamps") }, ...leds.map(lamp))] : [];
    dom.replaceChildren(...shown, ...lamps);
    dom.hidden = dom.childElementCount === 0;
  }

  return { dom, destroy: effect(show) };
}
