import { readdirSync, readFileSync } from "node:fs";
import { resolve } from "node:path";
import { expect, test } from "vitest";

import { CHANGING } from "../../../src/model/shown-blocks";
import { FOREIGN, foreignNames, nearestWords } from "../../../src/views/blocks/near";

const PACKAGE = resolve(import.meta.dirname, "../../../../src/learnblock");
const configurations = `${PACKAGE}/blocks/configurations`;
const files = readdirSync(configurations).filter((file) => file.endsWith(".json"));
const defined = files.map((file) => readFileSync(`${configurations}/${file}`, "utf8"));
const palette = [readFileSync(`${PACKAGE}/blocks/toolbox.py`, "utf8"), ...defined].join("\n");
const changing = Object.values(CHANGING).flat();

function inLanguage(language: string): (code: string) => string {
  const words = readFileSync(`${PACKAGE}/i18n/${language}/page/search.ftl`, "utf8");
  return (code) => words.match(new RegExp(`^page-search-${code} = (.+)$`, "m"))?.[1] ?? "";
}

test("each block suggested for a foreign word is in the palette", () => {
  const missing = Object.values(FOREIGN)
    .flat()
    .filter((type) => !changing.includes(type) && !palette.includes(`"${type.replace("lb_skill_", "")}"`));
  expect(missing).toEqual([]);
});

test.each(["en", "es"])("each foreign word has a translation in %s", (language) => {
  expect(Object.keys(FOREIGN).filter((name) => !inLanguage(language)(name))).toEqual([]);
});

test.each([
  ["en", "score", "score"],
  ["en", "game", "game"],
  ["en", "hide", "hide"],
  ["en", "say", "say"],
  ["en", "glid", "glide"],
  ["en", "glide 1 secs to x", "glide"],
  ["en", "Point in direction", "direction"],
  ["es", "puntuacion", "score"],
  ["es", "PUNTUACIÓN", "score"],
  ["es", "juego", "game"],
  ["es", "esconder", "hide"],
  ["es", "decir", "say"],
  ["es", "desliza", "glide"],
])("in %s the search for %s is one for %s", (language, searched, name) => {
  expect(foreignNames(searched, inLanguage(language))).toContain(name);
});

test.each(["a", "xy", "qwerty", ""])("%s is no foreign word", (searched) => {
  expect(foreignNames(searched, inLanguage("en"))).toEqual([]);
});

test.each([
  ["forwrad", ["forward"]],
  ["reapet", ["repeat"]],
  ["reppeat", ["repeat"]],
  ["diriger", []],
  ["abc", []],
])("%s has the nearest words %s", (searched, expected) => {
  expect(nearestWords(searched, ["forward", "repeat", "turn", "wait", "abd"])).toEqual(expected);
});
