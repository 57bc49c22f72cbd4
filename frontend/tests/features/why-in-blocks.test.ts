import { readFileSync } from "node:fs";
import { signal } from "@preact/signals";
import { beforeAll, expect, test } from "vitest";

import { parted, questionInView, sentenceInView } from "../../src/features/why/in-view";
import { language, say, startLanguage } from "../../src/i18n";
import type { Page } from "../../src/model/page";
import type { Asked, WhySentence } from "../../src/protocol/messages";

const preferred = signal("en");

beforeAll(() => startLanguage(preferred));

/** A page that shows these views; a block in words is what it is called. */
function page(...shown: string[]): Page {
  const views = {
    shows: (view: string) => shown.includes(view),
    describeStep: (_: string, block: string) => ({ go: "drive forward", loop: "repeat 4 times" })[block] ?? "",
  };
  const state = { value: { places: [], blocktext: "", python: "" } };
  return { views, context: { program: { state } } } as unknown as Page;
}

const RAN: WhySentence = {
  phrase: { code: "why-ran", values: { line: "7", code: "drive()", time: "1.00" } },
  time: 1,
  block: "go",
  inner: null,
};
const NEEDS: WhySentence = {
  phrase: { code: "why-left", values: { line: "3", code: "break", inner: "9", time: "2" } },
  time: null,
  block: "loop",
  inner: "go",
};

test("where only blocks are shown, an answer names the block", () => {
  expect(say(sentenceInView(page("blocks"), RAN).phrase)).toBe("The block “drive forward” ran at 1.00 s.");
  expect(say(sentenceInView(page("blocks", "python"), RAN).phrase)).toBe("Line 7, drive(), ran at 1.00 s.");
});

test("both blocks of a sentence lead to their blocks", () => {
  const shown = sentenceInView(page("blocks"), NEEDS);
  const parts = parted(say(shown.phrase), shown);
  expect(parts.map(({ text }) => text).join("")).toBe(say(shown.phrase));
  expect(parts.filter(({ block }) => block)).toEqual([
    { text: "“repeat 4 times”", block: "loop" },
    { text: "“drive forward”", block: "go" },
  ]);
});

test("a block that is no longer there keeps its line", () => {
  const gone = { ...RAN, block: "deleted" };
  expect(say(sentenceInView(page("blocks"), gone).phrase)).toBe("Line 7, drive(), ran at 1.00 s.");
});

test("a question of the list names the block, too", () => {
  const asked = {
    question: { ask: "line", subject: "7" },
    phrase: { code: "why-ask-line", values: { subject: "7", time: "" } },
    block: "go",
  } as unknown as Asked;
  expect(say(questionInView(page("blocks"), asked))).toBe("Why did the block “drive forward” run?");
  expect(say(questionInView(page("blocktext"), asked))).toBe("Why did line 7 run?");
});

/** The messages that say where something is. */
function codes(code: string): string[] {
  const text = readFileSync(`../src/learnblock/i18n/${code}/why.ftl`, "utf-8");
  const messages = text.split(/^(?=why-)/m).filter((message) => /\{ why-/.test(message));
  return messages.map((message) => message.split(" ")[0]!);
}

test.each(["en", "es"])("no sentence about a block has a line in %s", async (code) => {
  preferred.value = code;
  // The words are loaded, which takes a while on a busy machine.
  await expect.poll(() => language.value, { timeout: 20_000 }).toBe(code);
  const block = { line: "block", code: "“go”", inner: "block", innerCode: "“loop”" };
  const names = ["time", "name", "value", "facts", "closest", "motion", "until", "since", "seconds", "other"];
  const more = ["function", "device", "message", "count", "angle", "answer", "needed", "state", "one"];
  const values = { ...Object.fromEntries([...names, ...more].map((name) => [name, "1"])), ...block };
  expect(codes(code).length).toBeGreaterThan(50);
  for (const message of codes(code)) {
    const said = say({ code: message, values });
    expect([message, said]).toEqual([message, expect.stringMatching(/“go”|“loop”/)]);
    expect([message, said]).toEqual([
      message,
      expect.not.stringMatching(/(line|línea) (block|\d)|\{|, ,| el bloque “go” ,/i),
    ]);
  }
});
