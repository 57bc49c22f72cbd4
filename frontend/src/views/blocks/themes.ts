/** The blocks' colours in the page's three themes, all dark enough for white text (AA). */

import * as Blockly from "blockly/core";

import type { ThemeName } from "../../model/preferences";

type Shades = Record<string, string>;

const COLOURS: Shades = {
  lb_motor: "#1a62c4",
  lb_perceptual: "#00766c",
  lb_proprioceptive: "#6d3fb4",
  lb_express: "#b5266b",
  lb_control: "#a8500a",
  lb_operator: "#2f7a3a",
  lb_others: "#4f6b78",
  lb_event: "#8a6100",
  lb_python: "#616161",
  logic_blocks: "#2a6f97",
  loop_blocks: "#a8500a",
  math_blocks: "#2f7a3a",
  text_blocks: "#0f766e",
  list_blocks: "#84478f",
  variable_blocks: "#b3421f",
  variable_dynamic_blocks: "#b3421f",
  procedure_blocks: "#c02f4d",
  hat_blocks: "#8a6100",
};

const HATS = new Set(["lb_event", "hat_blocks"]);

/** A colour mixed with white (amount above 0) or black (below). */
function mix(colour: string, amount: number): string {
  const end = amount > 0 ? "#ffffff" : "#000000";
  return Blockly.utils.colour.blend(end, colour, Math.abs(amount)) ?? colour;
}

function blockStyles(amount: number, edge: number): Record<string, Partial<Blockly.Theme.BlockStyle>> {
  const style = ([name, colour]: [string, string]) => {
    const primary = mix(colour, amount);
    const shades = { colourPrimary: primary, colourSecondary: mix(primary, 0.25), colourTertiary: mix(primary, edge) };
    return [name, { ...shades, hat: HATS.has(name) ? "cap" : "" }] as const;
  };
  return Object.fromEntries(Object.entries(COLOURS).map(style));
}

function categoryStyles(amount: number): Record<string, Blockly.Theme.CategoryStyle> {
  const style = ([name, colour]: [string, string]) =>
    [`${name.replace("_blocks", "")}_category`, { colour: mix(colour, amount) }] as const;
  return Object.fromEntries(Object.entries(COLOURS).map(style));
}

// Workspace and palette use the page's colours, so they follow its theme.
const COMPONENTS = {
  workspaceBackgroundColour: "var(--surface)",
  toolboxBackgroundColour: "var(--surface-2)",
  toolboxForegroundColour: "var(--text)",
  flyoutBackgroundColour: "var(--surface-2)",
  flyoutForegroundColour: "var(--text)",
  flyoutOpacity: 1,
  scrollbarColour: "var(--text-dim)",
  scrollbarOpacity: 0.5,
  insertionMarkerColour: "var(--text)",
  insertionMarkerOpacity: 0.3,
};

function define(name: ThemeName, amount: number, edge: number): Blockly.Theme {
  return Blockly.Theme.defineTheme(`learnblock-${name}`, {
    name: `learnblock-${name}`,
    base: Blockly.Themes.Zelos,
    blockStyles: blockStyles(amount, edge),
    categoryStyles: categoryStyles(name === "light" ? 0 : 0.35),
    componentStyles: COMPONENTS,
    fontStyle: { family: "var(--font)", weight: "600", size: 11 },
  });
}

const THEMES: Record<ThemeName, Blockly.Theme> = {
  light: define("light", 0, -0.25),
  dark: define("dark", -0.12, 0.35),
  contrast: define("contrast", -0.35, 0.9),
};

export function themeOf(name: ThemeName): Blockly.Theme {
  return THEMES[name];
}
