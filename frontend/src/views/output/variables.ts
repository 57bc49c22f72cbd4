/** The current variables and `when`s of the program. */

import "./panel.css";
import "./variables.css";

import { effect } from "@preact/signals";
import { t } from "../../i18n";
import type { Context } from "../../model/context";
import type { Variables, WhenNow } from "../../protocol/messages";
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
  const local = createTable();
  const shared = createTable();
  const whens = createTable();
  dom.append(nothing, local.dom, shared.dom, whens.dom);

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

  return { dom, destroy: effect(() => show(context.running.variables.value)) };
}
