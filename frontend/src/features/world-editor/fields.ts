/** The properties of each sort of object and their bounds, from the schema of world files. */

import { boundsIn, defaultsIn, type Field, fieldsIn, type Table } from "../../ui/form/schema";
import type { Sort, Thing } from "../../views/world/plan/sorts";
import schema from "./schema.json";

const TABLES: Readonly<Record<Sort | "world" | "floor" | "game" | "part" | "vary", keyof typeof schema>> = {
  line: "Line",
  wall: "Wall",
  box: "Box",
  cylinder: "Cylinder",
  tag: "Tag",
  face: "Face",
  light: "Lamp",
  prop: "Prop",
  start: "Start",
  reach: "Reach",
  follow: "Follow",
  visit: "Visit",
  tour: "Tour",
  stop: "Stop",
  show: "Show",
  avoid: "Avoid",
  collect: "CollectThings",
  gates: "Gates",
  score: "Score",
  zone: "Zone",
  switch: "Switch",
  gate: "RaceGate",
  door: "Door",
  mover: "Mover",
  collectable: "Collectable",
  world: "WorldFile",
  floor: "Floor",
  game: "GameRules",
  part: "Part",
  vary: "Vary",
};

export type TableName = keyof typeof TABLES;

function tableOf(name: TableName): Table {
  return schema[TABLES[name]] as unknown as Table;
}

/** The fields of a table in the order of its description. */
export function fieldsOf(table: TableName): Field[] {
  return fieldsIn(tableOf(table));
}

/** The smallest and largest value of a key. */
export function boundsOf(table: TableName, key: string): readonly [number, number] {
  return boundsIn(tableOf(table).properties[key] ?? {});
}

/** The default values of an object. */
export function defaultsOf(table: TableName): Thing {
  return defaultsIn(tableOf(table));
}
