/** The ready hats that the palette offers: each needs what its condition needs, and has the same values. */

import type * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { GAME_HATS } from "../../model/games";
import { READY_HATS } from "../../model/whens";
import { actionsOf } from "./actions";
import { SKILL } from "./menus";
import type { Item } from "./offers";
import { freeWhenName } from "./when-block";

type State = Blockly.serialization.blocks.State;

export function readyHats(workspace: Blockly.Workspace): Item[] {
  return hatsOf(
    workspace,
    READY_HATS.filter((type) => !GAME_HATS.includes(type)),
  );
}

/** Those of games, where there is one. */
export function gameHats(workspace: Blockly.Workspace): Item[] {
  return actionsOf(workspace)?.inGame() ? hatsOf(workspace, GAME_HATS) : [];
}

function hatsOf(workspace: Blockly.Workspace, types: readonly string[]): Item[] {
  return types.flatMap((type) => {
    const condition = actionsOf(workspace)?.offered(type.replace("lb_when_", SKILL)) as (State & Item) | undefined;
    if (!condition) return [];
    const { needs, inputs, data } = condition;
    const name = freeWhenName(workspace, t(`page-blocks-name-${type.replaceAll("_", "-")}`));
    return [{ kind: "block", type, fields: { NAME: name }, inputs, data, needs } as Item];
  });
}
