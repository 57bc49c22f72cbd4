/** What the robot shows to those who look at it: its face and its lamps. */

import { computed, effect } from "@preact/signals";

import type { Context } from "../context";
import { t } from "../i18n";
import type { Island } from "../island";
import { element } from "./elements";
import { emotionName } from "./emotions";
import { face } from "./face";

type Led = readonly [name: string, colour: readonly [number, number, number]];

function lamp([name, [red, green, blue]]: Led): HTMLElement {
  const light = element("span", { class: "lamp", "aria-hidden": "true" });
  light.style.background = `rgb(${red} ${green} ${blue})`;
  const state = red + green + blue > 0 ? `${red}, ${green}, ${blue}` : t("robot.off");
  return element("li", { title: `${name}: ${state}` }, light, element("span", {}, name), element("span", { class: "unseen" }, state));
}

/** A small display of the robot's face and lamps; empty for a robot that has neither. */
export function createShown(context: Context): Island {
  const dom = element("div", { class: "shown" });
  const robot = computed(() => context.running.telemetry.value?.robots[0]);
  // As one text: what is equal need not be drawn again, twenty times a second.
  const content = computed(() => JSON.stringify([robot.value?.emotion ?? "none", Object.entries(robot.value?.leds ?? {})]));

  function show(): void {
    const [emotion, leds] = JSON.parse(content.value) as [string, Led[]];
    const name = emotionName(emotion);
    const shown = name ? [face(emotion), element("span", {}, name)] : [];
    const lamps = leds.length > 0 ? [element("ul", { "aria-label": t("robot.lamps") }, ...leds.map(lamp))] : [];
    dom.replaceChildren(...shown, ...lamps);
    dom.hidden = dom.childElementCount === 0;
  }

  return { dom, destroy: effect(show) };
}
