// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { act, fireEvent, render, screen } from "@testing-library/preact";
import { expect, test } from "vitest";

import { choice } from "../../src/ui/form/choice";
import { type FieldProps, FormField } from "../../src/ui/form/field";
import { FormContext } from "../../src/ui/form/form";
import { Parts, Rows } from "../../src/ui/form/parts";
import { boundsIn, defaultsIn, fieldsIn, type Shape } from "../../src/ui/form/schema";
import { button } from "../dialog";

type Kind = FieldProps["shape"]["kind"];

/** A field labelled "Speed" whose value the test sees. */
function show(shape: Shape, first: unknown, more: Partial<FieldProps> = {}, problems?: readonly string[]) {
  const value = signal(first);
  const take = (taken: unknown) => {
    value.value = taken;
  };
  const Shown = () => {
    const props = { label: "Speed", shape, value: value.value, take, ...more } as unknown as FieldProps<Kind>;
    return (
      <FormContext.Provider value={problems ? { problems: () => problems } : {}}>
        <FormField {...props} />
      </FormContext.Provider>
    );
  };
  render(<Shown />);
  return value;
}

function field(): HTMLInputElement {
  return screen.getByLabelText("Speed");
}

async function type(text: string): Promise<void> {
  await act(() => void fireEvent.input(field(), { target: { value: text } }));
}

const SPEED = { kind: "number", least: -10, most: 10 } as const;

test("a number that is being typed stays as it is typed", async () => {
  const value = show(SPEED, 5);
  for (const text of ["0", "0.0", "0.05"]) {
    await type(text);
    expect(field().value).toBe(text);
  }
  expect(value.value).toBe(0.05);
});

test.each(["11", "-11", ""])("the number '%s' is refused with what is allowed", async (text) => {
  const value = show(SPEED, 5);
  await type(text);
  expect(value.value).toBe(5);
  expect(field().validationMessage).toBe("Enter a number from -10 to 10.");
  expect(field().getAttribute("aria-invalid")).toBe("true");
});

test("half a number is refused where whole ones are wanted", async () => {
  const value = show({ ...SPEED, step: 1 }, 5);
  await type("1.5");
  expect(value.value).toBe(5);
  expect(field().validationMessage).toBe("Enter a whole number from -10 to 10.");
});

test("a value that changes elsewhere replaces what is typed", async () => {
  const value = show(SPEED, 5);
  await type("77");
  await act(() => {
    value.value = 3;
  });
  expect(field().value).toBe("3");
});

test("an optional number may be empty", async () => {
  const number = show(SPEED, 5, { optional: true });
  await type("");
  expect(number.value).toBeNull();
});

test("an optional text is nothing if it is empty", async () => {
  const value = show({ kind: "text", shortest: 1 }, "a", { optional: true });
  await type("");
  expect(value.value).toBeNull();
});

test("a text that is too short is refused", async () => {
  const value = show({ kind: "text", shortest: 1 }, "a");
  await type("");
  expect([value.value, field().validationMessage]).toEqual(["a", "Enter some text."]);
});

test("where the server judges, its words stand at the field, and every value is taken", async () => {
  const value = show(SPEED, 5, {}, ["Too fast."]);
  await type("99");
  expect(value.value).toBe(99);
  screen.getByText("Too fast.");
  expect(field().getAttribute("aria-invalid")).toBe("true");
});

test("a committed text is reported when the field is left", async () => {
  const value = show({ kind: "text", isCommitted: true }, "a");
  await type("ab ");
  expect([value.value, field().value]).toEqual(["a", "ab "]);
  fireEvent.change(field());
  expect(value.value).toBe("ab");
});

test("a choice shows the words of its options", () => {
  const { shape, words } = choice([
    ["slow", "Slow"],
    ["fast", "Fast"],
  ]);
  const value = show(shape, "slow", { words });
  fireEvent.change(screen.getByLabelText("Speed"), { target: { value: "fast" } });
  expect([value.value, screen.getByText("Fast").tagName]).toEqual(["fast", "OPTION"]);
});

test("a colour is one of the swatches, or any other", async () => {
  const swatches = [{ value: "white", shown: "#fdf6e6", words: "As the theme" }];
  const value = show({ kind: "colour" }, "#123456", { swatches });
  await act(() => void fireEvent.click(screen.getByLabelText("As the theme")));
  expect(value.value).toBe("white");
  fireEvent.input(screen.getByLabelText("Custom colour"), { target: { value: "#00ff00" } });
  expect(value.value).toBe("#00ff00");
});

test("lines are texts, and a new line can be begun", async () => {
  const value = show({ kind: "list", item: { kind: "text" }, fewest: 0, most: 9 }, []);
  for (const [text, lines] of [
    ["a", ["a"]],
    ["a\n", ["a"]],
    ["a\nb", ["a", "b"]],
  ] as const) {
    await type(text);
    expect([field().value, value.value]).toEqual([text, lines]);
  }
});

test("parts are added up to the limit, and removed", () => {
  const values = signal<readonly string[]>(["a"]);
  const Shown = () => (
    <Parts
      values={values.value}
      take={(taken) => {
        values.value = taken;
      }}
      title={(number) => `Part ${number}`}
      add="Add a part"
      fresh={() => "b"}
      most={2}
    >
      {(value) => <span>{value}</span>}
    </Parts>
  );
  const { rerender } = render(<Shown />);
  fireEvent.click(screen.getByText("Add a part"));
  rerender(<Shown />);
  expect(values.value).toEqual(["a", "b"]);
  expect(button("Add a part").disabled).toBe(true);
  fireEvent.click(screen.getByLabelText("Delete: Part 1"));
  expect(values.value).toEqual(["b"]);
});

test("a row is inserted after another, and the fewest stay", () => {
  const values = signal<readonly number[]>([1, 3]);
  const Shown = () => (
    <Rows
      values={values.value}
      take={(taken) => {
        values.value = taken;
      }}
      fewest={2}
      between={(index) => index + 2}
      insertWords={(number) => `insert ${number}`}
      removeWords={(number) => `remove ${number}`}
    >
      {(value) => <span>{value}</span>}
    </Rows>
  );
  const { rerender } = render(<Shown />);
  expect(button("remove 1").disabled).toBe(true);
  fireEvent.click(screen.getByLabelText("insert 1"));
  rerender(<Shown />);
  expect(values.value).toEqual([1, 2, 3]);
  fireEvent.click(screen.getByLabelText("remove 2"));
  expect(values.value).toEqual([1, 3]);
});

const TABLE = {
  properties: {
    speed: { type: "number", minimum: -5, maximum: 5, default: 1 },
    count: { type: "integer", minimum: 0, maximum: 9 },
    mass: { anyOf: [{ type: "number", minimum: 1, maximum: 2 }, { type: "null" }] },
    colour: { anyOf: [{ enum: ["red"] }, { type: "array", prefixItems: [{ type: "integer" }] }] },
    place: {
      type: "array",
      prefixItems: [
        { minimum: 0, maximum: 1 },
        { minimum: 2, maximum: 3 },
      ],
      items: false,
    },
    points: { type: "array", items: { type: "array", prefixItems: [{ minimum: 0, maximum: 1 }] }, minItems: 2 },
    other: { $ref: "#/$defs/Other" },
    event: { anyOf: [{ $ref: "#/$defs/A" }], discriminator: { propertyName: "event" } },
    words: { anyOf: [{ type: "string" }, { type: "object" }] },
  },
} as const;

test("the fields of a table come from its schema", () => {
  const fields = fieldsIn(TABLE as never);
  expect(fields.map(({ key, shape }) => `${key} ${shape.kind}`)).toEqual([
    "speed number",
    "count number",
    "mass number",
    "colour colour",
    "place numbers",
    "points list",
    "other record",
    "event union",
  ]);
  expect(fields.filter(({ optional }) => optional).map(({ key }) => key)).toEqual(["mass"]);
  expect([boundsIn(TABLE.properties.mass), defaultsIn(TABLE as never)]).toEqual([[1, 2], { speed: 1 }]);
});
