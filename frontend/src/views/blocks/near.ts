/** What the search offers besides the blocks with the searched words: what others call them, and slips of a key. */

import { DEFINITIONS } from "../../model/own-blocks";
import { WHENS } from "../../model/whens";
import { plain } from "../../ui/plain";

const skills = (...names: string[]) => names.map((name) => `lb_skill_${name}`);
const FACES = skills("expressJoy", "expressSurprise", "expressNeutral");
const COUNTING = ["variables_set", "math_change"];

/** The nearest blocks for words of Scratch, MakeCode and others, which are messages; some say what there is instead. */
export const FOREIGN: Readonly<Record<string, readonly string[]>> = {
  score: [...skills("change_score", "show_score", "change_lives"), ...COUNTING],
  game: skills("is_key_pressed", "change_score", "change_lives", "win_game", "game_over"),
  clone: FACES,
  hide: skills("clear_screen", "expressNeutral", "pen_up"),
  say: [...skills("say_Text", "show_text", "matrix_text"), "text_print"],
  glide: skills("go_to", "drive_distance", "move_straight"),
  direction: skills("set_orientation", "turn", "get_heading", "reset_orientation"),
  position: skills("get_pose", "go_to", "near_to_target"),
  edge: skills("is_bumped", "is_front_obstacle", "is_there_ground"),
  broadcast: skills("send", "received", "message_value"),
  flag: ["lb_main", "lb_start"],
  event: [...WHENS, ...skills("is_key_pressed", "is_shaken", "is_bumped", "received")],
  key: skills("is_key_pressed", "is_press_8_button_controller"),
  timer: skills("reset_timer", "get_timer", "sleep"),
  ask: ["text_prompt_ext"],
  text: ["text_join", "lists_length", "lb_in"],
  remainder: ["math_modulo", "lb_floor_divide"],
  array: ["lists_create_with", "lists_getIndex", "lists_length"],
  function: DEFINITIONS,
  pen: skills("pen_down", "pen_up", "set_pen_color", "clear_drawing"),
  icon: skills("matrix_icon", "show_text", "RGBled"),
  volume: skills("modify_volume"),
  microphone: skills("is_shaken", "is_bumped"),
  temperature: skills("get_light", "is_tilted"),
  servo: skills("setAngleMotor"),
  leave: ["controls_flow_statements", ...skills("stop_bot")],
  animate: [...skills("cozmoDances", "cozmoCat"), ...FACES],
  dictionary: ["lb_dictionary", "lb_dictionary_get"],
  smile: skills("expressJoy", "is_any_face_happy"),
  size: [...skills("RGBled"), ...FACES],
};

/** A word that is long enough for a slip, and how many keys may be wrong in it. */
const SLIPS = { length: 4, most: 2 };

/** The entries of `FOREIGN` that the searched words mean: whole words first, else those that begin like this. */
export function foreignNames(searched: string, wordsOf: (name: string) => string): string[] {
  const typed = plain(searched);
  const names = Object.keys(FOREIGN);
  const saying = (test: (word: string) => boolean) =>
    names.filter((name) => plain(wordsOf(name)).split(", ").some(test));
  // Such as "change score by 1".
  const whole = saying((word) => ` ${typed} `.includes(` ${word} `));
  return whole.length || typed.length < 3 ? whole : saying((word) => word.startsWith(typed));
}

/** The known words that differ from the searched one by the fewest slips of a key; none if all differ by more. */
export function nearestWords(searched: string, known: Iterable<string>): string[] {
  const word = plain(searched);
  if (word.length < SLIPS.length) return [];
  const most = word.length === SLIPS.length ? 1 : SLIPS.most;
  const near = [...known]
    .map((other) => ({ other, slips: distance(word, other) }))
    .filter(({ slips }) => slips <= most);
  const least = Math.min(...near.map(({ slips }) => slips));
  return near.filter(({ slips }) => slips === least).map(({ other }) => other);
}

/** The letters to add, leave out, replace or swap with the next one to get from one word to another. */
function distance(one: string, other: string): number {
  const rows = [Array.from({ length: other.length + 1 }, (_, at) => at)];
  for (let i = 1; i <= one.length; i++) {
    const row = [i];
    for (let j = 1; j <= other.length; j++) {
      const replaced = rows[i - 1]![j - 1]! + (one[i - 1] === other[j - 1] ? 0 : 1);
      const swaps = i > 1 && j > 1 && one[i - 1] === other[j - 2] && one[i - 2] === other[j - 1];
      const swapped = swaps ? rows[i - 2]![j - 2]! + 1 : Infinity;
      row.push(Math.min(rows[i - 1]![j]! + 1, row[j - 1]! + 1, replaced, swapped));
    }
    rows.push(row);
  }
  return rows[one.length]![other.length]!;
}
