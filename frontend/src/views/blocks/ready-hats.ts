/** Events that are ready to use: each has a condition that robots sense, and a name that says so. */

import type * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { actionsOf } from "./actions";
import type { Item } from "./offers";
import { freeWhenName } from "./when-block";

type State = Blockly.serialization.blocks.State;

/** The conditions, by the words for the names of the events. */
const CONDITIONS: Readonly<Record<string, string>> = {
  "page-blocks-when-key": "lb_skill_is_key_pressed",
  "page-blocks-when-bumped": "lb_skill_is_bumped",
  "page-blocks-when-near": "lb_skill_is_front_obstacle",
  "page-blocks-when-heard": "lb_skill_received",
};

/** A `when` for each condition that the palette offers; it needs what its condition needs. */
export function readyHats(workspace: Blockly.Workspace): Item[] {
  return Object.entries(CONDITIONS).flatMap(([code, type]) => {
    const condition = actionsOf(workspace)?.offered(type) as (State & Item) | undefined;
    if (!condition) return [];
    const { needs, inputs, fields } = condition;
    return [hat(freeWhenName(workspace, t(code)), { type, inputs, fields }, needs)];
  });
}

function hat(name: string, condition: State, needs: Item["needs"]): Item {
  const inputs = { CONDITION: { block: condition } };
  const state = { type: "lb_when", fields: { NAME: name }, extraState: { condition: true }, inputs };
  return { kind: "block", ...state, needs } as Item;
}
