/** The fields of an object: what its table in a world's file describes. */

import type { ComponentChildren } from "preact";

import { t, translated } from "../../i18n";
import { type FieldProps, FormField, NumberRow } from "../../ui/form/field";
import { NumberInput } from "../../ui/form/inputs";
import { Rows, Small } from "../../ui/form/parts";
import type { Field, Shape } from "../../ui/form/schema";
import type { Ref, Thing } from "../../views/world/plan/sorts";
import { colourIn, written } from "../../views/world/scenery/colours";
import type { Colour, PartValues, WorldValues, XY } from "../../views/world/scenery/description";
import { boundsOf, fieldsOf, type TableName } from "./fields";
import { swatchesFor } from "./swatches";

/** Values of a table, and the receiver of a changed one. */
export interface Section {
  readonly table: TableName;
  readonly values: Thing;
  readonly take: (key: string, value: unknown) => void;
}

interface Props {
  readonly world: WorldValues;
  /** The object; null for the world itself. */
  readonly of: Ref | null;
  readonly section: Section;
  readonly shows: (field: Field) => boolean;
}

/** A field for each key of a section that is shown. */
export function SectionFields({ world, of, section, shows }: Props) {
  const { table, values, take } = section;
  return fieldsOf(table)
    .filter((field) => field.key in values && !isHidden(values, field.key) && shows(field))
    .map((field) => {
      const given = { table, field, value: values[field.key], take: (value: unknown) => take(field.key, value) };
      return <ValueField key={field.key} {...given} world={world} of={of} />;
    });
}

/** A line has either corners or a path. */
function isHidden(values: Thing, key: string): boolean {
  if (!Array.isArray(values.path)) return false;
  const isPath = values.path.length > 0;
  return key === "points" ? isPath : !isPath && (key === "start" || key === "path");
}

interface ValueProps {
  readonly table: TableName;
  readonly field: Field;
  readonly value: unknown;
  readonly take: (value: unknown) => void;
  readonly world: WorldValues;
  readonly of: Ref | null;
}

function ValueField({ table, field, value, take, world, of }: ValueProps) {
  const { key, shape, optional } = field;
  const label = labelOf(table, key);
  const common = { label, optional, take, dataKey: key };
  if (shape.kind === "list" && shape.item.kind === "numbers") {
    const corners = <Corners shape={shape.item} points={value as XY[]} take={take} />;
    return <Group name={key} label={label} children={corners} />;
  }
  if (shape.kind === "list" && shape.item.kind === "record") {
    return <Group name={key} label={label} children={<Segments parts={value as PartValues[]} take={take} />} />;
  }
  if (shape.kind === "colour") {
    const colours = { value: written(value as Colour), take: (chosen: string) => take(colourIn(chosen)) };
    return <FormField {...common} {...colours} shape={{ kind: "colour" }} swatches={swatchesFor(world, of)} />;
  }
  const words = (option: string) =>
    t(`page-${shape.kind === "numbers" ? "editor-part" : "world"}-${key.replaceAll("_", "-")}-${option}`);
  return <FormField {...({ ...common, shape, value, words, known: known(world, key) } as FieldProps)} />;
}

/** The names that a key can refer to. */
function known({ line, box, door, team, goal }: WorldValues, key: string): string[] {
  const named: Readonly<Record<string, readonly { readonly name: string }[]>> = {
    line,
    door,
    team,
    object: box,
    after: Object.values(goal).flat(),
  };
  return [...new Set((named[key] ?? []).map(({ name }) => name))];
}

/** The label of a key: the table's own, or the shared one. */
export function labelOf(table: TableName, key: string): string {
  const word = key.replaceAll("_", "-");
  return translated(`page-editor-key-${table}-${word}`, t(`page-editor-key-${word}`));
}

function Group({ name, label, children }: { name: string; label: string; children: ComponentChildren }) {
  return (
    <fieldset class="form-group" data-key={name}>
      <legend>{label}</legend>
      {children}
    </fieldset>
  );
}

interface CornersProps {
  readonly shape: Extract<Shape, { kind: "numbers" }>;
  readonly points: readonly XY[];
  readonly take: (points: readonly XY[]) => void;
}

/** A line or a wall has at least two ends. */
const FEWEST_CORNERS = 2;

/** The corners of a wall or of a straight-edged line, as numbers. */
function Corners({ shape, points, take }: CornersProps) {
  return (
    <Rows
      values={points}
      take={take}
      fewest={FEWEST_CORNERS}
      between={(index) => amid(points, index)}
      insertWords={(number) => t("page-editor-add-corner", { number })}
      removeWords={(number) => t("page-editor-remove-corner", { number })}
    >
      {(point, set, index) => (
        <NumberRow
          label=""
          shape={shape}
          value={point}
          take={(numbers) => set(numbers as XY)}
          words={(axis) => t(`page-editor-corner-${axis === "0" ? "east" : "north"}`, { number: index + 1 })}
          dataKey={`points.${index}`}
        />
      )}
    </Rows>
  );
}

function amid(points: readonly XY[], index: number): XY {
  const [x, y] = points[index] as XY;
  const [nextX, nextY] = points[index + 1] ?? [x + 200, y];
  return [Math.round((x + nextX) / 2), Math.round((y + nextY) / 2)];
}

const STRAIGHT: PartValues = { forward: 200, turn: null, radius: null };
const CURVE: PartValues = { forward: null, turn: 90, radius: 200 };

interface SegmentsProps {
  readonly parts: readonly PartValues[];
  readonly take: (parts: readonly PartValues[]) => void;
}

/** A line's path: straight segments and curves. */
function Segments({ parts, take }: SegmentsProps) {
  const end = (word: string, part: PartValues) => (
    <Small sign={t(`page-editor-${word}`)} words={t(`page-editor-add-${word}`)} act={() => take([...parts, part])} />
  );
  return (
    <>
      <Rows
        values={parts}
        take={take}
        fewest={1}
        between={() => STRAIGHT}
        insertWords={(number) => t("page-editor-add-part", { number })}
        removeWords={(number) => t("page-editor-remove-part", { number })}
      >
        {(part, set, index) => <Segment part={part} take={set} index={index} />}
      </Rows>
      <div class="form-row">
        {end("straight", STRAIGHT)}
        {end("curve", CURVE)}
      </div>
    </>
  );
}

interface SegmentProps {
  readonly part: PartValues;
  readonly take: (part: PartValues) => void;
  readonly index: number;
}

function Segment({ part, take, index }: SegmentProps) {
  const keys = part.forward === null ? (["turn", "radius"] as const) : (["forward"] as const);
  return (
    <>
      <span aria-hidden="true">{part.forward !== null ? "↑" : (part.turn ?? 0) < 0 ? "↶" : "↷"}</span>
      <div class="form-row">
        {keys.map((key) => {
          const [least, most] = boundsOf("part", key);
          return (
            <NumberInput
              key={key}
              shape={{ kind: "number", least, most }}
              value={part[key] ?? null}
              take={(number) => take({ ...part, [key]: number })}
              described={{
                "aria-label": t(`page-editor-part-${key}`, { number: index + 1 }),
                "data-key": `path.${index}.${key}`,
              }}
            />
          );
        })}
      </div>
    </>
  );
}
