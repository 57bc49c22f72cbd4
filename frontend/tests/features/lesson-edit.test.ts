import { expect, test } from "vitest";

import { fieldsOf, kindsOf, newOf } from "../../src/features/lesson-editor/fields";
import { draftOf, editedOf, moved } from "../../src/features/lessons/lesson-edit";

const CONTENT = {
  title: "Square",
  level: 1,
  minutes: 30,
  aims: ["Drive", { en: "Turn" }],
  robots: ["sim-ebo"],
  step: [
    {
      title: { en: "Drive" },
      phase: "make",
      text: { en: "Go.", es: " " },
      check: [{ kind: "ends", say: "It ends." }],
      hint: [{ check: "ends", say: ["Look.", { en: "There." }] }],
    },
  ],
};

test("a text for all languages is in that of the teacher", () => {
  const { content } = draftOf({ content: CONTENT }, "es");
  expect(content.title).toEqual({ es: "Square" });
  expect(content.aims).toEqual([{ es: "Drive" }, { en: "Turn" }]);
  expect(content.step[0]?.check?.[0]).toEqual({ kind: "ends", say: { es: "It ends." } });
  expect(content.step[0]?.hint?.[0]?.say).toEqual([{ es: "Look." }, { en: "There." }]);
});

test("languages in which a text is blank are left out", () => {
  const { content } = editedOf(draftOf({ content: CONTENT }, "en"));
  expect(content).toMatchObject({ step: [{ text: { en: "Go." } }] });
  expect(JSON.stringify(content)).not.toContain('"es"');
});

test("blank words, hints and aims are left out, but not the last aim", () => {
  const draft = draftOf({ content: { ...CONTENT, aims: [{}, { en: "" }] } }, "en");
  const [step] = draft.content.step;
  const blank = { ...step, check: [{ kind: "ends", say: { en: "" } }], hint: [{ say: [{}, { en: " " }] }] };
  const changed = { ...draft, content: { ...draft.content, step: [blank as NonNullable<typeof step>] } };
  const { content } = editedOf(changed);
  expect(content.aims).toEqual([{}]);
  expect(content.step).toMatchObject([{ check: [{ kind: "ends" }], hint: [] }]);
  expect(JSON.stringify(content.step)).not.toContain("say");
});

test("what a form has no fields for is sent back as it came", () => {
  const puzzle = { program: "puzzle.bt", also: ["main:\nend\n"], distractors: ["function.turn(90)"] };
  const content = { ...CONTENT, picture: "a.svg", step: [{ ...CONTENT.step[0], puzzle }] };
  const edited = editedOf(draftOf({ content, programs: { "puzzle.bt": "main:\nend\n" } }, "en"));
  expect(edited.content).toMatchObject({ picture: "a.svg", step: [{ puzzle }] });
  expect(edited.programs).toEqual({ "puzzle.bt": "main:\nend\n" });
});

test("an item is moved among the others", () => {
  expect(moved(["a", "b", "c"], 2, -1)).toEqual(["a", "c", "b"]);
  expect(moved(["a", "b", "c"], 0, 1)).toEqual(["b", "a", "c"]);
});

test("every kind of check and of event has a form with values to begin with", () => {
  expect(kindsOf("kind")).toContain("on_line");
  for (const kind of kindsOf("kind")) expect(newOf("kind", kind).kind).toBe(kind);
  expect(newOf("kind", "never")).toEqual({ kind: "never", what: { event: "collision" } });
  expect(newOf("event", "at")).toEqual({ event: "at", x: 0, y: 0 });
  expect(fieldsOf("kind", "in_order").map(({ shape }) => shape.kind)).toEqual(["list", "number"]);
});
