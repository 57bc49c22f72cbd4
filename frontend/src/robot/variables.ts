/** The program's variables and `when`s as they are now. */

import "./panel.css";
import "./variables.css";

import { effect } from "@preact/signals";

import type { Context } from "../context";
import { t } from "../i18n";
import type { Island } from "../island";
import type { Variables, WhenNow } from "../messages";
import { element } from "./elements";
import { createTable } from "./table";

function entries(values: Record<string, string>): (readonly [string, string])[] {
  return Object.entries(values);
}

function whenEntry({ name, active, time }: WhenNow): readonly [string, string, string] {
  return [name, t(active ? "variables.active" : "variables.inactive"), active ? `${time.toFixed(1)} s` : ""];
}

/** A table of variables, and one of `when`s where the program has some. */
export function createVariables(context: Context): Island {
  const dom = element("section", { class: "robot-panel variables scroll", tabindex: "0" });
  const nothing = element("p", { class: "nothing" });
  const local = createTable();
  const shared = createTable();
  const whens = createTable();
  dom.append(nothing, local.dom, shared.dom, whens.dom);

  function show(variables: Variables | null): void {
    const value = [t("variables.name"), t("variables.value")];
    local.show(t("variables.local"), value, entries(variables?.local ?? {}));
    shared.show(t("variables.shared"), value, entries(variables?.shared ?? {}));
    const columns = [t("variables.name"), t("variables.state"), t("variables.time")];
    whens.show(t("variables.whens"), columns, (variables?.whens ?? []).map(whenEntry), 1);
    nothing.textContent = t("variables.nothing");
    nothing.hidden = !(local.dom.hidden && shared.dom.hidden && whens.dom.hidden);
    dom.setAttribute("aria-label", t("variables.title"));
  }

  return { dom, destroy: effect(() => show(context.running.variables.value)) };
}
