/** The current variables and `when`s of the program. */

import "./panel.css";
import "./variables.css";

import { effect } from "@preact/signals";
import { t } from "../../i18n";
import type { Context } from "../../model/context";
import type { Variables, WhenNow } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import type { Island } from "../../ui/island";
import { element } from "./elements";
import { createTable } from "./table";

function entries(values: Record<string, string>): (readonly [string, string])[] {
  return Object.entries(values);
}

function whenEntry({ name, active, time }: WhenNow): readonly [string, string, string] {
  return [name, t(active ? "page-variables-active" : "page-variables-inactive"), active ? `${time.toFixed(1)} s` : ""];
}

/** A table of variables, and one of `when`s if the program has any. */
export function createVariables(context: Context): Island {
  const dom = element("section", { class: "robot-panel variables scroll", tabindex: "0" });
  const nothing = element("p", { class: "nothing" });
  const stack = element("p", { class: "stack" });
  const { askingWhy, lookingBack, running } = context;
  const title = () => t("page-why-variable");
  const ofVariables = { title, ask: (name: string) => askingWhy.aboutVariable(name) };
  const changes = {
    heading: () => t("page-variables-changes"),
    title: (by: -1 | 1, name: string) =>
      t(by < 0 ? "page-variables-change-before" : "page-variables-change-after", { name }),
    go: (by: -1 | 1, name: string) => lookingBack.toChange(by, name),
  };
  const local = createTable(ofVariables, changes);
  const shared = createTable(ofVariables, changes);
  const whens = createTable({ title, ask: (name) => askingWhy.aboutWhen(name, isActive(name)) });
  dom.append(nothing, stack, local.dom, shared.dom, whens.dom);

  /** The functions that ran at the moment that is looked back at, outermost first. */
  function showStack(functions: readonly string[]): void {
    stack.textContent = t("page-variables-stack", { functions: functions.map((name) => `${name}()`).join(" › ") });
    stack.hidden = functions.length === 0;
  }

  function isActive(name: string): boolean {
    return running.variables.peek()?.whens?.some((one) => one.name === name && one.active) ?? false;
  }

  function show(variables: Variables | null): void {
    const value = [t("page-variables-name"), t("page-variables-value")];
    local.show(t("page-variables-local"), value, entries(variables?.local ?? {}));
    shared.show(t("page-variables-shared"), value, entries(variables?.shared ?? {}));
    const columns = [t("page-variables-name"), t("page-variables-state"), t("page-variables-time")];
    whens.show(t("page-variables-whens"), columns, (variables?.whens ?? []).map(whenEntry), 1);
    nothing.textContent = t("page-variables-nothing");
    nothing.hidden = !(local.dom.hidden && shared.dom.hidden && whens.dom.hidden);
    dom.setAttribute("aria-label", t("page-variables-title"));
  }

  const cleanup = new Cleanup(
    effect(() => show(running.variables.value)),
    effect(() => void dom.classList.toggle("has-run", !!running.timeline.value?.end)),
    effect(() => showStack(running.past.value?.stack ?? [])),
  );
  return {
    dom,
    destroy: () => {
      cleanup.dispose();
    },
  };
}
