/** The ten groups of blocks: each has one colour and one icon, whatever the block. */

export const GROUPS = [
  "events",
  "move",
  "sense",
  "show",
  "sound",
  "control",
  "game",
  "maths",
  "variables",
  "my_blocks",
] as const;

export type Group = (typeof GROUPS)[number];

/** All but the yellow of events are dark enough for white text (AA). */
export const COLOURS: Readonly<Record<Group, string>> = {
  events: "#ffc531",
  move: "#2563eb",
  sense: "#0b7a75",
  show: "#c4267f",
  sound: "#7c3aed",
  control: "#c2470a",
  game: "#966000",
  maths: "#15803d",
  variables: "#c81e3a",
  my_blocks: "#4b5b76",
};

/** Text and icons on a group's colour. */
export function inkOf(group: Group): string {
  return group === "events" ? "#3a2a00" : "#ffffff";
}

/** Our blocks name their group; the others are Blockly's own styles. */
export const STYLES: Readonly<Record<string, Group>> = {
  ...Object.fromEntries(GROUPS.map((group) => [`lb_${group}`, group])),
  hat_blocks: "events",
  logic_blocks: "maths",
  loop_blocks: "control",
  math_blocks: "maths",
  text_blocks: "maths",
  list_blocks: "variables",
  variable_blocks: "variables",
  variable_dynamic_blocks: "variables",
  procedure_blocks: "my_blocks",
};

export function isGroup(name: string): name is Group {
  return (GROUPS as readonly string[]).includes(name);
}
