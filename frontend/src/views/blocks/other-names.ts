/** What Scratch and MakeCode call the blocks that are the same there; the names are messages. */

const skills = (...names: string[]) => names.map((name) => `lb_skill_${name}`);

/** Blocks by what they are called elsewhere. */
const OTHER_NAMES: Readonly<Record<string, readonly string[]>> = {
  start: ["lb_main", "lb_start"],
  repeat: ["controls_repeat_ext"],
  forever: ["lb_forever"],
  if: ["controls_if"],
  while: ["controls_whileUntil"],
  count: ["controls_for"],
  each: ["controls_forEach"],
  "wait-until": ["lb_wait_until"],
  wait: skills("sleep"),
  set: ["variables_set"],
  change: ["math_change"],
  print: ["text_print"],
  ask: ["text_prompt_ext"],
  define: ["procedures_defnoreturn"],
  random: ["math_random_int"],
  arithmetic: ["math_arithmetic"],
  remainder: ["math_modulo"],
  round: ["math_round"],
  compare: ["logic_compare"],
  and: ["logic_operation"],
  not: ["logic_negate"],
  join: ["text_join"],
  list: ["lists_create_with"],
  item: ["lists_getIndex"],
  replace: ["lists_setIndex"],
  length: ["lists_length"],
  contains: ["lb_in"],
  comment: ["lb_comment"],
  move: skills("drive_distance"),
  turn: skills("turn", "turn_90_left", "turn_90_right"),
  point: skills("set_orientation"),
  go: skills("go_to"),
  key: skills("is_key_pressed"),
  timer: skills("get_timer"),
  "reset-timer": skills("reset_timer"),
  broadcast: skills("send"),
  received: skills("received"),
  "pen-down": skills("pen_down"),
  "pen-up": skills("pen_up"),
  "pen-colour": skills("set_pen_color"),
  "pen-size": skills("set_pen_width"),
  erase: skills("clear_drawing"),
  "show-text": skills("show_text", "matrix_text"),
  "show-number": skills("show_number", "matrix_number"),
  clear: skills("clear_screen"),
  note: skills("play_note"),
  light: skills("get_light"),
};

/** The names of a block elsewhere, in the page's language; empty if it has none. */
export function otherNames(type: string, words: (code: string) => string): string {
  const found = Object.keys(OTHER_NAMES).find((name) => OTHER_NAMES[name]?.includes(type));
  return found ? words(`page-help-name-${found}`) : "";
}
