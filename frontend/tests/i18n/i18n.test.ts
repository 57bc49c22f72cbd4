import { signal } from "@preact/signals";
import { beforeAll, expect, test, vi } from "vitest";

import { language, languages, say, startLanguage, t, translated, worldName } from "../../src/i18n";

const preferred = signal("en");

async function speak(code: string): Promise<void> {
  preferred.value = code;
  // A busy computer takes longer than a second to load words.
  await vi.waitFor(() => expect(language.value).toBe(code), { timeout: 20_000 });
}

beforeAll(() => startLanguage(preferred));

test("each folder of messages is a language", () => {
  expect(languages).toEqual(expect.arrayContaining(["en", "es"]));
});

test("words follow the language", async () => {
  await speak("es");
  expect(t("page-bar-resume")).toBe("Continuar");
  await speak("en");
  expect(t("page-bar-resume")).toBe("Resume");
});

test("a language without words is shown in English", async () => {
  await speak("es");
  preferred.value = "tlh";
  await vi.waitFor(() => expect(language.value).toBe("en"), { timeout: 20_000 });
});

test("plurals depend on the number", async () => {
  await speak("en");
  expect([1, 2].map((count) => t("page-problems-some", { count }))).toEqual([
    "1 error in the program",
    "2 errors in the program",
  ]);
});

test("a phrase shows values, phrases and lists", async () => {
  await speak("en");
  const unknown = { code: "unknown-name-of", values: { kind: "robot", name: "cosmo", known: ["cozmo", "ebo"] } };
  expect(say(unknown)).toBe("There is no robot 'cosmo'. Known names: cozmo, ebo.");
  const inner = { code: "page-bar-run" };
  expect(say({ code: "run-robot-not-created", values: { reason: inner } })).toBe("The robot could not be created. Run");
});

test("text that is no code is shown as it is", () => {
  expect(say({ code: "out of memory" })).toBe("out of memory");
});

test("names of our worlds are translated, names of others are not", async () => {
  await speak("es");
  expect(worldName("An empty floor")).toBe("Un suelo vacío");
  expect(worldName("tag 3")).toBe("etiqueta 3");
  expect(worldName("My maze")).toBe("My maze");
  expect(translated("page-catalog-world-maze", "Maze")).toBe("Maze");
});
