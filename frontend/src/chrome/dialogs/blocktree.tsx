/** Tabs of the palette and their blocks, each with a tick where it is shown. */

import { useSignal, type Signal } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";

import type { LabelledTab } from "../../blocks/labels";
import { forget, tick, type Ticks } from "../../blocksets/ticks";
import { t } from "../../i18n";
import { Icon } from "../widgets/icons";

interface Props {
  readonly tabs: readonly LabelledTab[];
  readonly ticks: Ticks;
  /** Whether they are no longer those of the set. */
  readonly changed: boolean;
  readonly change: (ticks: Ticks) => void;
}

export function BlockTree({ tabs, ticks, changed, change }: Props) {
  const search = useSignal("");
  const open = useSignal<ReadonlySet<string>>(new Set());
  const found = tabs.map((tab) => matching(tab, search.value)).filter((tab) => tab.blocks.length > 0);
  const all = tabs.flatMap(({ blocks }) => blocks);
  return (
    <div class="block-tree">
      <label class="field">
        {t("blocksets.search")}
        <input type="search" value={search.value} onInput={({ currentTarget }) => (search.value = currentTarget.value)} />
      </label>
      <p class="dim" role="status">
        {t("blocksets.count", { shown: all.filter((one) => ticks.blocks.has(one)).length, all: all.length })}
        {changed && ` · ${t("blocksets.isChanged")}`}
      </p>
      <div class="both">
        <button type="button" class="button bordered" onClick={() => change(tick(ticks, found.flatMap(({ blocks }) => blocks), true))}>
          {t("blocksets.all")}
        </button>
        <button type="button" class="button bordered" onClick={() => change(tick(ticks, found.flatMap(({ blocks }) => blocks), false))}>
          {t("blocksets.none")}
        </button>
      </div>
      <ul class="tabs-of-blocks" aria-label={t("blocksets.blocks")}>
        {found.map((tab) => (
          <TabRow key={tab.category} tab={tab} ticks={ticks} change={change} open={open} searching={search.value !== ""} />
        ))}
      </ul>
      <Absent ticks={ticks} change={change} />
      <label class="check">
        <input
          type="checkbox"
          checked={ticks.later}
          onChange={({ currentTarget }) => change({ ...ticks, later: currentTarget.checked })}
        />
        {t("blocksets.later")}
      </label>
    </div>
  );
}

/** A tab with those of its blocks that have these words; all of them where its own name has. */
function matching(tab: LabelledTab, words: string): LabelledTab {
  const wanted = words.trim().toLocaleLowerCase();
  if (tab.title.toLocaleLowerCase().includes(wanted)) return tab;
  const says = (block: string) => `${tab.labels.get(block)} ${block}`.toLocaleLowerCase().includes(wanted);
  return { ...tab, blocks: tab.blocks.filter(says) };
}

interface RowProps {
  readonly tab: LabelledTab;
  readonly ticks: Ticks;
  readonly change: (ticks: Ticks) => void;
  readonly open: Signal<ReadonlySet<string>>;
  /** Whether what is found is to be seen in any case. */
  readonly searching: boolean;
}

function TabRow({ tab, ticks, change, open, searching }: RowProps) {
  const { category, title, blocks, labels } = tab;
  const shown = blocks.filter((block) => ticks.blocks.has(block)).length;
  const isOpen = searching || open.value.has(category);
  const list = `blocks-of-${category}`;
  const toggle = () => {
    const others = new Set(open.value);
    if (!others.delete(category)) others.add(category);
    open.value = others;
  };
  return (
    <li>
      <div class="tab-row">
        <Tick label={title} some={shown > 0} all={shown === blocks.length} set={(on) => change(tick(ticks, blocks, on))} />
        <span class="dim">{labels.size > 0 && `${shown}/${blocks.length}`}</span>
        {labels.size > 0 && (
          <button
            type="button"
            class={isOpen ? "button open" : "button"}
            aria-expanded={isOpen}
            aria-controls={list}
            aria-label={t("blocksets.blocksOf", { tab: title })}
            onClick={toggle}
          >
            <Icon name="down" />
          </button>
        )}
      </div>
      <ul id={list} hidden={!isOpen}>
        {isOpen &&
          blocks.map((block) => (
            <li key={block}>
              <Tick
                label={labels.get(block) ?? block}
                some={ticks.blocks.has(block)}
                all={ticks.blocks.has(block)}
                set={(on) => change(tick(ticks, [block], on))}
              />
            </li>
          ))}
      </ul>
    </li>
  );
}

interface TickProps {
  readonly label: string;
  readonly some: boolean;
  readonly all: boolean;
  readonly set: (on: boolean) => void;
}

/** A tick that is neither on nor off where only some of its blocks are shown. */
function Tick({ label, some, all, set }: TickProps) {
  const box = useRef<HTMLInputElement>(null);
  useLayoutEffect(() => {
    if (box.current) box.current.indeterminate = some && !all;
  });
  return (
    <label class="check">
      <input ref={box} type="checkbox" checked={all} onChange={({ currentTarget }) => set(currentTarget.checked)} />
      {label}
    </label>
  );
}

/** What the set names and this LearnBlock lacks; it is kept unless somebody takes it out. */
function Absent({ ticks, change }: Pick<Props, "ticks" | "change">) {
  const { categories, blocks } = ticks.absent;
  const names = [...categories, ...blocks];
  if (names.length === 0) return null;
  return (
    <fieldset>
      <legend>{t("blocksets.absent")}</legend>
      {names.map((name) => (
        <Tick key={name} label={name} some all set={() => change(forget(ticks, name))} />
      ))}
    </fieldset>
  );
}
