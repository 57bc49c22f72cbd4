/** The blocks' colours in the page's three themes. */

import * as Blockly from "blockly/core";

import type { ThemeName } from "../../model/preferences";
import { COLOURS, type Group, STYLES } from "./groups";

const HATS = new Set(["lb_events", "hat_blocks"]);

/** A colour mixed with white (amount above 0) or black (below). */
function mix(colour: string, amount: number): string {
  const end = amount > 0 ? "#ffffff" : "#000000";
  return Blockly.utils.colour.blend(end, colour, Math.abs(amount)) ?? colour;
}

/** How a theme changes the groups' colours; amounts as for `mix`. */
interface Shading {
  readonly fill: number;
  readonly edge: number;
  /** The page's text colour. */
  readonly text: string;
}

const SHADINGS: Readonly<Record<ThemeName, Shading>> = {
  light: { fill: 0, edge: -0.3, text: "#1a2138" },
  dark: { fill: 0, edge: 0.35, text: "#eef1fc" },
  contrast: { fill: -0.35, edge: 0.9, text: "#ffffff" },
};

function blockStyles(shading: Shading): Record<string, Partial<Blockly.Theme.BlockStyle>> {
  const style = ([name, group]: [string, Group]) => {
    const primary = fillOf(group, shading);
    const shades = {
      colourPrimary: primary,
      colourSecondary: mix(primary, 0.25),
      colourTertiary: mix(primary, shading.edge),
    };
    return [name, { ...shades, hat: HATS.has(name) ? "cap" : "" }] as const;
  };
  return Object.fromEntries(Object.entries(STYLES).map(style));
}

// Yellow keeps its brightness, because its text is dark.
function fillOf(group: Group, { fill }: Shading): string {
  return group === "events" ? COLOURS.events : mix(COLOURS[group], fill);
}

// Workspace and palette use the page's colours, so they follow its theme.
const COMPONENTS = {
  workspaceBackgroundColour: "var(--surface)",
  toolboxBackgroundColour: "var(--surface)",
  toolboxForegroundColour: "var(--text)",
  flyoutBackgroundColour: "var(--surface-2)",
  flyoutForegroundColour: "var(--text-dim)",
  flyoutOpacity: 1,
  scrollbarColour: "var(--border-strong)",
  scrollbarOpacity: 0.6,
  insertionMarkerOpacity: 0.3,
};

function define(name: ThemeName): Blockly.Theme {
  return Blockly.Theme.defineTheme(`learnblock-${name}`, {
    name: `learnblock-${name}`,
    base: Blockly.Themes.Zelos,
    blockStyles: blockStyles(SHADINGS[name]),
    // Blockly accepts no variable here.
    componentStyles: { ...COMPONENTS, insertionMarkerColour: SHADINGS[name].text },
    fontStyle: { family: "var(--font)", weight: "700", size: 12 },
  });
}

const THEMES: Record<ThemeName, Blockly.Theme> = {
  light: define("light"),
  dark: define("dark"),
  contrast: define("contrast"),
};

export function themeOf(name: ThemeName): Blockly.Theme {
  return THEMES[name];
}
