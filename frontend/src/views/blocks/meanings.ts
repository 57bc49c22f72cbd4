/** What children call things that the blocks name otherwise, so that the search finds their blocks. */

const skills = (...names: string[]) => names.map((name) => `lb_skill_${name}`);

/** The blocks of each meaning, by their names in block sets; its words are messages. */
export const MEANINGS: Readonly<Record<string, readonly string[]>> = {
  loop: [
    "controls_repeat_ext",
    "lb_forever",
    "controls_whileUntil",
    "controls_for",
    "controls_forEach",
    "lb_for_unpacking",
  ],
  condition: ["controls_if"],
  pause: [...skills("sleep", "wait_until_still"), "lb_wait_until"],
  speed: skills(
    "move_straight",
    "drive_distance",
    "drive_arc",
    "go_to",
    "turn",
    "move_left",
    "move_right",
    "turn_left",
    "turn_right",
    "set_move",
    "slow_down",
  ),
  go: skills("move_straight", "drive_distance", "drive_arc", "go_to", "move_left", "move_right", "set_move"),
  rotate: skills("turn", "turn_90_left", "turn_90_right", "turn_back", "turn_left", "turn_right", "set_orientation"),
  halt: skills("stop_bot"),
  lamp: skills("led", "RGBled"),
  sensor: skills(
    "is_front_obstacle",
    "is_left_obstacle",
    "is_right_obstacle",
    "is_back_obstacle",
    "is_obstacle_free",
    "get_min_distance",
    "get_obstacle_direction",
  ),
  face: skills(
    "expressNeutral",
    "expressJoy",
    "expressSadness",
    "expressSurprise",
    "expressDisgust",
    "expressAnger",
    "expressFear",
  ),
  sound: skills("say_Text", "play_audio", "play_frequency", "play_note"),
  photo: skills("get_image"),
  random: ["math_random_int", "math_random_float"],
  show: ["text_print", ...skills("show_text", "show_number")],
  module: ["lb_python_line:import", "lb_python_line:from"],
  exception: ["lb_python_block:try", "lb_python_line:raise", "lb_python_line:assert"],
  object: ["lb_python_block:class", "lb_python_form:attribute", "lb_python_form:method"],
  switch: ["lb_python_block:match"],
  comprehension: ["lb_python_form:list"],
  anonymous: ["lb_python_form:lambda"],
  file: ["lb_python_block:with"],
  slice: ["lb_python_form:slice"],
  tuple: ["lb_python_form:tuple", "lb_python_line:set"],
};

/** The words that find a block although it does not show them. */
export function wordsFor(block: string, words: (code: string) => string): string[] {
  return Object.entries(MEANINGS)
    .filter(([, blocks]) => blocks.includes(block))
    .flatMap(([name]) => words(`page-blocks-meaning-${name}`).split(", "));
}
