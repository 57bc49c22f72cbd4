/** The panel beside the world: the selected object and its properties. */

import { type Signal, signal } from "@preact/signals";
import { render } from "preact";

import { t } from "../../i18n";
import { Tick } from "../../ui/form/inputs";
import type { Field } from "../../ui/form/schema";
import type { Island } from "../../ui/island";
import { allThings, key, type Ref, thingAt } from "../../views/world/plan/sorts";
import type { GameValues, VaryValues, WorldValues } from "../../views/world/scenery/description";
import { defaultsOf, type TableName } from "./fields";
import { type Section, SectionFields } from "./form";
import { Teams } from "./teams-form";
import { replaced } from "./things";
import { nameOf } from "./words";
import type { WorldEdit } from "./world-edit";

/** What a child changes; everything else is under More. */
const MAIN: Readonly<Partial<Record<TableName, readonly string[]>>> = {
  world: ["theme"],
  floor: ["size", "colour"],
  line: ["colour", "closed"],
  wall: ["colour"],
  box: ["colour"],
  cylinder: ["colour"],
  tag: ["id"],
  face: ["emotion"],
  light: ["brightness"],
  prop: ["kind", "solid"],
  reach: ["name"],
  follow: ["name", "line"],
  visit: ["name", "id"],
  tour: ["name"],
  stop: ["name", "seconds"],
  show: ["name", "emotion"],
  avoid: ["name"],
  game: ["lives", "countdown"],
  collect: ["name", "kind"],
  gates: ["name", "laps"],
  score: ["name", "points"],
  zone: ["score", "ends", "colour"],
  switch: ["door", "seconds"],
  gate: ["score"],
  door: ["name", "colour"],
  mover: ["wander", "speed", "lives", "colour"],
  collectable: ["kind", "score", "lives"],
};

function isMain({ table }: Section, { key }: Field): boolean {
  return MAIN[table]?.includes(key) ?? false;
}

/** @param snaps whether positions are rounded to the grid. */
export function createProperties(draft: WorldEdit, snaps: Signal<boolean>): Island {
  const dom = document.createElement("div");
  // It stays open for the next object.
  const isMore = signal(false);
  dom.className = "editor-properties";
  render(<Properties draft={draft} snaps={snaps} isMore={isMore} />, dom);
  const destroy = () => {
    render(null, dom);
    dom.remove();
  };
  return { dom, destroy };
}

interface Props {
  readonly draft: WorldEdit;
  readonly snaps: Signal<boolean>;
  readonly isMore: Signal<boolean>;
}

function Properties({ draft, snaps, isMore }: Props) {
  const world = draft.world.value;
  const ref = draft.selected.value;
  if (!world) return null;
  const sections = ref ? sectionsOfThing(draft, world, ref) : sectionsOfWorld(draft, world);
  const fields = (wants: boolean) =>
    sections.map((section) => (
      <SectionFields
        key={section.table}
        world={world}
        of={ref}
        section={section}
        shows={(field) => isMain(section, field) === wants}
      />
    ));
  return (
    <>
      <ObjectChoice draft={draft} world={world} />
      <div class="editor-fields" key={ref ? key(ref) : ""}>
        {fields(true)}
        <details
          class="editor-more"
          open={isMore.value}
          onToggle={({ currentTarget }) => (isMore.value = currentTarget.open)}
        >
          <summary>{t("page-editor-more")}</summary>
          <div class="editor-fields">
            {fields(false)}
            {!ref && <Teams world={world} change={(changed) => draft.change(changed)} />}
            <Tick text={t("page-editor-snap")} value={snaps.value} take={(on) => (snaps.value = on)} />
          </div>
        </details>
      </div>
    </>
  );
}

function ObjectChoice({ draft, world }: { draft: WorldEdit; world: WorldValues }) {
  const all = allThings(world);
  const ref = draft.selected.value;
  const choose = (name: string) => draft.select(all.find((candidate) => key(candidate) === name) ?? null);
  return (
    <select
      aria-label={t("page-editor-selected")}
      value={ref ? key(ref) : ""}
      onChange={({ currentTarget }) => choose(currentTarget.value)}
    >
      <option value="">{t("page-editor-world")}</option>
      {all.map((candidate) => (
        <option key={key(candidate)} value={key(candidate)}>
          {nameOf(world, candidate)}
        </option>
      ))}
    </select>
  );
}

function sectionsOfThing(draft: WorldEdit, world: WorldValues, ref: Ref): Section[] {
  const values = thingAt(world, ref);
  if (!values) return [];
  const take = (name: string, value: unknown) =>
    draft.change(replaced(world, ref, { ...values, [name]: value }), `field ${key(ref)} ${name}`);
  return [{ table: ref.sort, values, take }];
}

function sectionsOfWorld(draft: WorldEdit, world: WorldValues): Section[] {
  const { theme, ambient_light, sensor_noise, floor } = world;
  const game = world.game ?? (defaultsOf("game") as unknown as GameValues);
  const vary = world.vary ?? (defaultsOf("vary") as unknown as VaryValues);
  const change = (name: string, changed: Partial<WorldValues>) =>
    draft.change({ ...world, ...changed }, `field world ${name}`);
  const take = (name: string, value: unknown) => change(name, { [name]: value });
  const takeFloor = (name: string, value: unknown) => change(`floor ${name}`, { floor: { ...floor, [name]: value } });
  const takeGame = (name: string, value: unknown) => change(`game ${name}`, { game: { ...game, [name]: value } });
  const takeVary = (name: string, value: unknown) => change(`vary ${name}`, { vary: { ...vary, [name]: value } });
  return [
    { table: "world", values: { theme, ambient_light, sensor_noise }, take },
    { table: "floor", values: { ...floor }, take: takeFloor },
    { table: "game", values: { ...game }, take: takeGame },
    { table: "vary", values: { ...vary }, take: takeVary },
  ];
}
