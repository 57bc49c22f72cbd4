import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { expect, test } from "vitest";

const SOURCES = fileURLToPath(new URL("../src", import.meta.url));
const THEME = "ui/theme.css";
/** Its lengths are millimetres of a world. */
const IN_MILLIMETRES = "views/world/plan/shapes.css";
const DECLARATION = /(?<=^|[\s;{])(-{0,2}[a-z][\w-]*)\s*:\s*([^;{}]*)(?=[;}])/g;
const COLOUR =
  /#[\da-f]{3,8}\b|\b(?:rgb|hsl|hwb|lab|lch|oklab|oklch|color|light-dark)a?\(|(?<![\w-])(?:black|silver|gr[ae]y|white|maroon|red|purple|fuchsia|green|lime|olive|yellow|navy|blue|teal|aqua|orange|pink|gold|brown|cyan|magenta|violet|indigo|crimson|tomato)(?![\w-])/i;
const SCALED = /^(?:(?:row-|column-)?gap|(?:padding|margin)(?:-[a-z-]+)?|border(?:-[a-z-]+)*-radius|font|font-size)$/;
const LENGTH = /(?<![\w.-])-?(\d*\.?\d+)(px|rem|pt)\b/g;
/** A hairline, in pixels. */
const HAIRLINE = 1;
/** From here, in pixels, a distance makes room for something else, and belongs to that. */
const ROOM = 40;

const files = readdirSync(SOURCES, { recursive: true, encoding: "utf-8" });
const sheets = new Map(files.filter((path) => path.endsWith(".css")).map((path) => [path, read(path)]));

function read(path: string): string {
  return readFileSync(join(SOURCES, path), "utf-8").replaceAll(/\/\*.*?\*\//gs, "");
}

function declarations(sheet: string): readonly (readonly [string, string])[] {
  return [...sheet.matchAll(DECLARATION)].map(([, property = "", value = ""]) => [property, value]);
}

function literalColours(sheet: string): string[] {
  return declarations(sheet).flatMap(([property, value]) => (COLOUR.test(value) ? `${property}: ${value}` : []));
}

function lengthsOutsideScale(sheet: string): string[] {
  return declarations(sheet).flatMap(([property, value]) =>
    SCALED.test(property) && [...value.matchAll(LENGTH)].some(isLiteral(property)) ? `${property}: ${value}` : [],
  );
}

function isLiteral(property: string): (length: RegExpMatchArray) => boolean {
  return ([, number, unit]) => {
    const pixels = Number(number) * (unit === "rem" ? 16 : 1);
    return property.startsWith("font") ? pixels > 0 : pixels > HAIRLINE && pixels <= ROOM;
  };
}

/** What each sheet does wrong, with its path. */
function faults(find: (sheet: string) => string[], ...except: readonly string[]): string[] {
  return [...sheets].flatMap(([path, sheet]) =>
    except.includes(path) ? [] : find(sheet).map((fault) => `${path}: ${fault}`),
  );
}

test("only the theme has colours", () => {
  expect(sheets.size).toBeGreaterThan(40);
  expect(faults(literalColours, THEME)).toEqual([]);
});

test("distances, corners and letters have sizes of the theme's scales", () => {
  expect(faults(lengthsOutsideScale, THEME, IN_MILLIMETRES)).toEqual([]);
});

test("every custom property that a sheet uses is set somewhere", () => {
  const scripts = files.filter((path) => /\.tsx?$/.test(path)).map(read);
  const set = [...sheets.values(), ...scripts].join("\n").matchAll(/(--[\w-]+)(?=\s*:|")/g);
  const known = new Set([...set].map(([name]) => name));
  const unknown = (sheet: string) =>
    [...sheet.matchAll(/var\((--[\w-]+)/g)].flatMap(([, name = ""]) => (known.has(name) ? [] : name));
  expect(faults(unknown)).toEqual([]);
});

test.each(["#fff", "1px solid rgb(0 0 0 / 20%)", "color-mix(in srgb, var(--run) 88%, black)", "light-dark(red, blue)"])(
  "%s is a colour outside the theme",
  (value) => expect(literalColours(`.a:hover { border: 0; background: ${value}; }`)).toHaveLength(1),
);

test.each(["transparent", "currentcolor", "var(--gold)", "color-mix(in srgb, var(--black) 20%, transparent)"])(
  "%s is no colour outside the theme",
  (value) => expect(literalColours(`a { color: ${value}; }`)).toEqual([]),
);

test.each([
  "padding: 8px",
  "margin: 0 -0.5rem",
  "gap: .4rem",
  "border-start-start-radius: 3px",
  "font: 700 12px var(--font)",
])("%s is outside the scales", (declaration) => expect(lengthsOutsideScale(`a { ${declaration}; }`)).toHaveLength(1));

test.each([
  "padding: 0 1px 0.5em var(--space-4)",
  "margin: 12vh auto 120px",
  "font: 600 var(--text-3) / 1.4 var(--font)",
  "width: 8px",
])("%s is within the scales", (declaration) => expect(lengthsOutsideScale(`a { ${declaration}; }`)).toEqual([]));
