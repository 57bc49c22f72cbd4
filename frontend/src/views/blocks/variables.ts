/** The workspace's variables, with case-sensitive names. */

import * as Blockly from "blockly/core";

import type { Variable } from "../../protocol/messages";

type Model = Blockly.IVariableModel<Blockly.IVariableState>;

/** Makes Blockly compare names of variables and functions as Python does. */
export function compareNamesExactly(): void {
  Blockly.Names.equals = (one: string, other: string) => one === other;
}

/** Creates and renames variables; `removeVariables` removes the others. */
export function setVariables(workspace: Blockly.WorkspaceSvg, wanted: readonly Variable[]): void {
  const names = new Map(wanted.map(({ id, name }) => [id, name]));
  const map = workspace.getVariableMap();
  const changed = map.getAllVariables().filter((variable) => variable.getName() !== names.get(variable.getId()));
  // Two variables may swap names, so all get temporary names first.
  for (const variable of changed) variable.setName(`\0${variable.getId()}`);
  for (const { name, id } of wanted) nameVariable(map, name, id);
  for (const variable of changed) showName(workspace, variable);
}

function nameVariable(map: Blockly.IVariableMap<Model>, name: string, id: string): void {
  const variable = map.getVariableById(id);
  if (variable) variable.setName(name);
  else map.createVariable(name, "", id);
}

function showName(workspace: Blockly.WorkspaceSvg, variable: Model): void {
  for (const block of workspace.getAllBlocks(false)) block.updateVarName(variable);
}

/**
 * Removes all other variables, except those that a block uses: Blockly would remove the block too.
 * A call of a deleted function creates variables for its parameters.
 */
export function removeVariables(workspace: Blockly.WorkspaceSvg, wanted: readonly Variable[]): void {
  const ids = new Set(wanted.map(({ id }) => id));
  const map = workspace.getVariableMap();
  for (const variable of map.getAllVariables()) {
    const id = variable.getId();
    if (!ids.has(id) && Blockly.Variables.getVariableUsesById(workspace, id).length === 0) map.deleteVariable(variable);
  }
}
