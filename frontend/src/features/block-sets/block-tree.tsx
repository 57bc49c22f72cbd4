/** The palette's tabs and blocks, each with a check box. */

import { type Signal, useSignal } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import { t } from "../../i18n";
import { Icon } from "../../ui/icons";
import type { LabelledTab } from "./labels";
import { forget, type Ticks, tick } from "./ticks";

interface Props {
  readonly tabs: readonly LabelledTab[];
  readonly ticks: Ticks;
  /** Whether the ticks differ from the set. */
  readonly changed: boolean;
  readonly change: (ticks: Ticks) => void;
}

export function BlockTree({ tabs, ticks, changed, change }: Props) {
  const search = useSignal("");
  const open = useSignal<ReadonlySet<string>>(new Set());
  const found = tabs.map((tab) => matching(tab, search.value)).filter((tab) => tab.blocks.length > 0);
  const all = tabs.flatMap(({ blocks }) => blocks);
  const names = found.flatMap(({ blocks }) => blocks);
  const tickFound = (on: boolean) => change(tick(ticks, names, on));
  return (
    <div class="block-tree">
      <label class="field">
        {t("page-sets-search")}
        <input
          type="search"
          value={search.value}
          onInput={({ currentTarget }) => (search.value = currentTarget.value)}
        />
      </label>
      <p class="dim" role="status">
        {t("page-sets-count", { shown: all.filter((one) => ticks.blocks.has(one)).length, all: all.length })}
        {changed && ` · ${t("page-sets-is-changed")}`}
      </p>
      <div class="both">
        <button type="button" class="button bordered" onClick={() => tickFound(true)}>
          {t("page-sets-all")}
        </button>
        <button type="button" class="button bordered" onClick={() => tickFound(false)}>
          {t("page-sets-none")}
        </button>
      </div>
      <ul class="tabs-of-blocks" aria-label={t("page-sets-blocks")}>
        {found.map((tab) => (
          <TabRow
            key={tab.category}
            tab={tab}
            ticks={ticks}
            change={change}
            open={open}
            searching={search.value !== ""}
          />
        ))}
      </ul>
      <Absent ticks={ticks} change={change} />
      <label class="check">
        <input
          type="checkbox"
          checked={ticks.later}
          onChange={({ currentTarget }) => change({ ...ticks, later: currentTarget.checked })}
        />
        {t("page-sets-later")}
      </label>
    </div>
  );
}

/** A tab with its blocks that match the search; all of them if its name matches. */
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
  /** Whether a search is active, which opens the tabs. */
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
        <Tick
          label={title}
          some={shown > 0}
          all={shown === blocks.length}
          set={(on) => change(tick(ticks, blocks, on))}
        />
        <span class="dim">{labels.size > 0 && `${shown}/${blocks.length}`}</span>
        {labels.size > 0 && (
          <button
            type="button"
            class={isOpen ? "button open" : "button"}
            aria-expanded={isOpen}
            aria-controls={list}
            aria-label={t("page-sets-blocks-of", { tab: title })}
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

/** A check box that is indeterminate if only some of its blocks are shown. */
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

/** Names in the set that are unknown here; they are kept until the user removes them. */
function Absent({ ticks, change }: Pick<Props, "ticks" | "change">) {
  const { categories, blocks } = ticks.absent;
  const names = [...categories, ...blocks];
  if (names.length === 0) return null;
  return (
    <fieldset>
      <legend>{t("page-sets-absent")}</legend>
      {names.map((name) => (
        <Tick key={name} label={name} some all set={() => change(forget(ticks, name))} />
      ))}
    </fieldset>
  );
}
