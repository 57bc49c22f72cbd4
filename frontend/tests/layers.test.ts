import { readdirSync, readFileSync } from "node:fs";
import { dirname, join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { expect, test } from "vitest";

const SOURCES = fileURLToPath(new URL("../src", import.meta.url));
/** A folder may import from itself and from what comes after it. */
const LAYERS = [
  "class.tsx",
  "guest.tsx",
  "hand-in-run.tsx",
  "main.tsx",
  "standalone.ts",
  "app",
  "features",
  "views",
  "model",
  "protocol",
  "ui",
  "i18n",
];
const IMPORT = /(?:from\s+|import\s+|import\()"(\.[^"]*)"/g;

const files = readdirSync(SOURCES, { recursive: true, encoding: "utf-8" }).filter((path) => /\.tsx?$/.test(path));
const known = new Set(files);
const imports = new Map(files.map((path) => [path, importsOf(path)]));

function importsOf(path: string): string[] {
  const text = readFileSync(join(SOURCES, path), "utf-8");
  return [...text.matchAll(IMPORT)].flatMap(([, address = ""]) => fileAt(dirname(path), address) ?? []);
}

function fileAt(folder: string, address: string): string | undefined {
  const path = relative(SOURCES, resolve(SOURCES, folder, address));
  return [`${path}.ts`, `${path}.tsx`, join(path, "index.ts"), join(path, "index.tsx")].find((one) => known.has(one));
}

function layerOf(path: string): number {
  return LAYERS.indexOf(path.split("/")[0] ?? "");
}

/** The nodes of a graph that are on a circle, or between two. */
function circles(graph: ReadonlyMap<string, ReadonlySet<string>>): string[] {
  const left = new Map(graph);
  const ends = () => [...left].filter(([, to]) => ![...to].some((one) => left.has(one))).map(([name]) => name);
  const starts = () => [...left.keys()].filter((name) => ![...left.values()].some((to) => to.has(name)));
  for (let free = ends(); free.length > 0; free = [...ends(), ...starts()]) for (const name of free) left.delete(name);
  return [...left.keys()];
}

function folders(): Map<string, Set<string>> {
  const graph = new Map<string, Set<string>>();
  for (const [path, others] of imports) {
    const from = dirname(path);
    const to = others.map((other) => dirname(other)).filter((folder) => folder !== from);
    graph.set(from, new Set([...(graph.get(from) ?? []), ...to]));
  }
  return graph;
}

test("every file belongs to a layer", () => {
  expect(files.length).toBeGreaterThan(100);
  expect(files.filter((path) => layerOf(path) < 0)).toEqual([]);
});

test("imports only point down", () => {
  const upward = [...imports].flatMap(([path, others]) =>
    others.filter((other) => layerOf(other) < layerOf(path)).map((other) => `${path} -> ${other}`),
  );
  expect(upward).toEqual([]);
});

test("no files import one another in a circle", () => {
  expect(circles(new Map([...imports].map(([path, others]) => [path, new Set(others)])))).toEqual([]);
});

test("no folders import one another in a circle", () => {
  expect(circles(folders())).toEqual([]);
});

test("a circle is found", () => {
  const graph = { a: ["b"], b: ["c"], c: ["b", "d"], d: [] };
  expect(circles(new Map(Object.entries(graph).map(([name, to]) => [name, new Set(to)])))).toEqual(["b", "c"]);
});

test("file names are kebab-case", () => {
  expect(files.filter((path) => !/^[a-z0-9/-]+\.(d\.)?tsx?$/.test(path))).toEqual([]);
});
