import { readdirSync, readFileSync } from "node:fs";
import { resolve } from "node:path";
import { expect, test } from "vitest";

import { MEANINGS, wordsFor } from "../../../src/views/blocks/meanings";

const PACKAGE = resolve(import.meta.dirname, "../../../../src/learnblock");
const configurations = `${PACKAGE}/blocks/configurations`;
const files = readdirSync(configurations).filter((file) => file.endsWith(".json"));
const defined = files.map((file) => readFileSync(`${configurations}/${file}`, "utf8"));
const toolbox = ["toolbox", "python_palette"].map((name) => readFileSync(`${PACKAGE}/blocks/${name}.py`, "utf8"));
const palette = [...toolbox, ...defined].join("\n");

function inLanguage(language: string): (code: string) => string {
  const words = readFileSync(`${PACKAGE}/i18n/${language}/page/blocks.ftl`, "utf8");
  return (code) => words.match(new RegExp(`^${code} = (.+)$`, "m"))?.[1] ?? "";
}

const found = (language: string, searched: string) =>
  Object.values(MEANINGS)
    .flat()
    .filter((type) => wordsFor(type, inLanguage(language)).includes(searched));

test("each block of a meaning is in the palette", () => {
  const missing = Object.values(MEANINGS)
    .flat()
    .filter((type) => !palette.includes(`"${type.replace(/^lb_skill_|^.*:/, "")}"`));
  expect(missing).toEqual([]);
});

test.each(["en", "es"])("each meaning has words in %s", (language) => {
  const without = Object.keys(MEANINGS).filter((name) => !inLanguage(language)(`page-blocks-meaning-${name}`));
  expect(without).toEqual([]);
});

test.each([
  ["en", "loop", "controls_repeat_ext", "lb_forever", "controls_whileUntil", "controls_for"],
  ["es", "bucle", "controls_repeat_ext", "lb_forever", "controls_whileUntil", "controls_for"],
  ["en", "speed", "lb_skill_move_straight", "lb_skill_drive_distance"],
  ["es", "velocidad", "lb_skill_move_straight", "lb_skill_drive_distance"],
  ["en", "list comprehension", "lb_python_form:list"],
  ["es", "excepción", "lb_python_block:try"],
  ["en", "lamp", "lb_skill_led", "lb_skill_RGBled"],
  ["es", "lampara", "lb_skill_led", "lb_skill_RGBled"],
])("in %s the search for %s finds its blocks", (language, searched, ...types) => {
  expect(found(language, searched)).toEqual(expect.arrayContaining(types));
});
