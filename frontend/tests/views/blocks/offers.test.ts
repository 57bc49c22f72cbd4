import { expect, test } from "vitest";

import { type FilledTab, found, type Item, type Offer, offered } from "../../../src/views/blocks/offers";

const WORDS = {
  more: (count: number) => `+ ${count}`,
  fewer: () => "fewer",
  missing: (need: string) => `no ${need}`,
  standIn: (need: string) => `no ${need}, but here`,
  from: (stage: string) => `from ${stage}`,
};

function block(name: string, ...needs: string[]): Item {
  return { kind: "block", type: name, needs };
}

const TABS: readonly FilledTab[] = [
  { name: "Driving", category: "Base", items: [block("drive"), block("turn"), block("slow")] },
  { name: "Head", category: "Motor", items: [block("look", "Motor"), block("tilt", "Motor")] },
];
const FIRST = [
  { heading: "", blocks: ["turn", "drive"] },
  { heading: "Look", blocks: ["look"] },
];

function shown(change: Partial<Offer>): string[] {
  const offer = { tabs: TABS, first: FIRST, open: false, lacks: new Set<string>(), stage: "coder" as const, ...change };
  return offered(offer, WORDS).map(wordOf);
}

function wordOf(item: Item): string {
  return (item as { text?: string }).text ?? `${item.lacking ? "pale " : ""}${item.type}`;
}

test("a group first shows its first blocks, in their order, and counts the others", () => {
  expect(shown({})).toEqual(["turn", "drive", "Look", "look", "+ 2"]);
});

test("the others follow under the names of their tabs", () => {
  const others = ["Driving", "slow", "Head", "tilt", "fewer"];
  expect(shown({ open: true })).toEqual(["turn", "drive", "Look", "look", ...others]);
});

test("blocks that the robot can't do are pale, last, and under the reason", () => {
  const lacks = new Set(["Motor"]);
  expect(shown({ lacks })).toEqual(["turn", "drive", "+ 3"]);
  const others = ["Driving", "slow", "no Motor", "pale look", "pale tilt", "fewer"];
  expect(shown({ lacks, open: true })).toEqual(["turn", "drive", ...others]);
});

test("sounds that this computer plays for the robot are offered as usual, below where they are heard", () => {
  const items = [block("say", "Speaker:say"), block("note", "Speaker:tone"), block("rest"), block("music", "MP3")];
  const tabs = [{ name: "Sound", category: "Speaker", items }];
  const first = [{ heading: "", blocks: ["say", "note", "rest"] }];
  const lacks = new Set(["Speaker", "Speaker:say", "Speaker:tone", "MP3"]);
  expect(shown({ tabs, first, lacks })).toEqual(["no Speaker, but here", "say", "note", "rest", "+ 1"]);
  const voice = new Set(["Speaker:say"]);
  expect(shown({ tabs, first, lacks: voice })).toEqual(["no Speaker:say, but here", "say", "note", "rest", "+ 1"]);
  expect(shown({ tabs, first })).toEqual(["say", "note", "rest", "+ 1"]);
  expect(found(items, [], { lacks, stage: "coder" }, WORDS).map(wordOf)).toEqual([
    "say",
    "note",
    "rest",
    "no MP3",
    "pale music",
  ]);
});

test("a block set shows all its blocks at once", () => {
  expect(shown({ first: null })).toEqual(["Driving", "drive", "turn", "slow", "Head", "look", "tilt"]);
});

test("a group without any of its first blocks shows the others at once", () => {
  expect(shown({ tabs: [TABS[1]!], lacks: new Set(["Motor"]) })).toEqual(["no Motor", "pale look", "pale tilt"]);
});

test("a whole tab can be among the first", () => {
  expect(shown({ first: [{ heading: "", blocks: ["Base"] }] })).toEqual(["drive", "turn", "slow", "+ 2"]);
});

test("found blocks that the robot can't do come last", () => {
  const items = [block("look", "Motor"), block("drive")];
  expect(found(items, [], { lacks: new Set(["Motor"]), stage: "coder" }, WORDS).map(wordOf)).toEqual([
    "drive",
    "no Motor",
    "pale look",
  ]);
});

test("found blocks that the palette shows first come first, in its order", () => {
  const items = [block("rare"), block("until"), block("wait"), block("other")];
  const first = [
    { heading: "", blocks: ["wait"] },
    { heading: "", blocks: ["until"] },
  ];
  expect(found(items, first, { lacks: new Set(), stage: "coder" }, WORDS).map(wordOf)).toEqual([
    "wait",
    "until",
    "rare",
    "other",
  ]);
});

test("a block that another block of the palette can become is left out", () => {
  const [left, right] = [block("left"), { ...block("right"), like: "left" }];
  const tab = (items: readonly Item[]) => [{ name: "Driving", category: "Base", items }];
  expect(shown({ tabs: tab([left, right]), first: null })).toEqual(["left"]);
  expect(shown({ tabs: tab([right]), first: null })).toEqual(["right"]);
});

test("blocks of a later stage are not offered, and found under the name of their stage", () => {
  const items = [{ ...block("try"), stage: "coder" as const }, block("drive")];
  const tabs = [{ name: "Driving", category: "Base", items }];
  expect(shown({ tabs, first: null, stage: "explorer" })).toEqual(["drive"]);
  expect(shown({ tabs, first: null, stage: "coder" })).toEqual(["try", "drive"]);
  const lacks = new Set<string>();
  expect(found(items, [], { lacks, stage: "starter" }, WORDS).map(wordOf)).toEqual(["drive", "from coder", "try"]);
  expect(found(items, [], { lacks, stage: "coder" }, WORDS).map(wordOf)).toEqual(["try", "drive"]);
});
