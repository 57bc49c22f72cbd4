/** The dialog in which one chooses which blocks are shown. */

import { useComputed, useSignal, useSignalEffect } from "@preact/signals";
import { useEffect, useId } from "preact/hooks";

import type { LabelledTab } from "../../blocks/labels";
import { descriptionOf, titleOf } from "../../blocksets/library";
import { ticksOf } from "../../blocksets/ticks";
import { language, t } from "../../i18n";
import type { BlockSet } from "../../messages";
import { said } from "../../sentences";
import { usePage } from "../page";
import { Dialog } from "../widgets/dialog";
import { BlockTree } from "./blocktree";
import { BlockSetActions } from "./blocksetactions";
import "./blocksets.css";

export function BlockSetsDialog() {
  const { dialogs, blockSets } = usePage();
  const tabs = useSignal<readonly LabelledTab[] | null>(null);
  const { draft } = blockSets;
  const failed = useSignal(false);
  const look = (base: BlockSet) => {
    draft.value = { base, ticks: ticksOf(base, tabs.value ?? []), changed: false };
  };
  useEffect(() => blockSets.list(), []);
  useSignalEffect(() => {
    void load(language.value)
      .then((found) => ((tabs.value = found), draft.peek()?.changed || look(blockSets.shown.peek())))
      .catch(() => (failed.value = true));
  });
  useSignalEffect(() => {
    if (blockSets.read.value && tabs.value) look(blockSets.read.value);
  });
  return (
    <Dialog title={t("blocksets.title")} close={() => dialogs.close()} size="large">
      {failed.value && <p role="alert">{t("blocks.failed")}</p>}
      {draft.value && tabs.value && (
        <>
          <div class="block-sets">
            <Sets chosen={draft.value.base} choose={look} />
            <BlockTree
              tabs={tabs.value}
              ticks={draft.value.ticks}
              changed={draft.value.changed}
              change={(ticks) => (draft.value = { ...draft.value!, ticks, changed: true })}
            />
          </div>
          <Refusals />
          <Deleted look={look} />
          <BlockSetActions key={draft.value.base.name} draft={draft.value} tabs={tabs.value} look={look} />
        </>
      )}
    </Dialog>
  );
}

async function load(code: string): Promise<readonly LabelledTab[]> {
  const { labelledTabs } = await import("../../blocks/labels");
  return labelledTabs(code);
}

function Refusals() {
  const { refusal, problems } = usePage().blockSets;
  const sentences = [refusal.value, ...problems.value].filter(Boolean);
  return (
    <div role="alert" class="refusals">
      {sentences.map((one) => (
        <p key={one}>{said(one)}</p>
      ))}
    </div>
  );
}

/** What was deleted, and the way back. */
function Deleted({ look }: { look: (set: BlockSet) => void }) {
  const { blockSets } = usePage();
  const { deleted } = blockSets;
  const undo = (set: BlockSet) => {
    blockSets.save(set, false);
    look(set);
  };
  return (
    <div role="status" class="deleted">
      {deleted.value && (
        <>
          <span>{t("blocksets.deleted", { title: titleOf(deleted.value) })}</span>
          <button type="button" class="button bordered" onClick={() => deleted.value && undo(deleted.value)}>
            {t("blocksets.undo")}
          </button>
        </>
      )}
    </div>
  );
}

interface SetsProps {
  readonly chosen: BlockSet;
  readonly choose: (set: BlockSet) => void;
}

function Sets({ chosen, choose }: SetsProps) {
  const { ours, own, carried } = usePage().blockSets;
  const alone = useComputed(() => {
    const saved = new Set(own.value.map((one) => JSON.stringify(one)));
    return carried.value.filter((one) => !saved.has(JSON.stringify(one)));
  });
  return (
    <div class="sets">
      <SetGroup word="blocksets.ours" sets={ours.value} chosen={chosen} choose={choose} />
      <SetGroup word="blocksets.carried" sets={alone.value} chosen={chosen} choose={choose} />
      <SetGroup word="blocksets.own" sets={own.value} chosen={chosen} choose={choose} />
    </div>
  );
}

function SetGroup({ word, sets, chosen, choose }: SetsProps & { word: string; sets: readonly BlockSet[] }) {
  if (sets.length === 0) return null;
  return (
    <fieldset>
      <legend>{t(word)}</legend>
      {sets.map((set) => (
        <SetChoice key={set.name} set={set} checked={same(set, chosen)} choose={choose} />
      ))}
    </fieldset>
  );
}

interface ChoiceProps {
  readonly set: BlockSet;
  readonly checked: boolean;
  readonly choose: (set: BlockSet) => void;
}

function SetChoice({ set, checked, choose }: ChoiceProps) {
  const [title, description] = [useId(), useId()];
  return (
    <label class="set">
      <input
        type="radio"
        name="block-set"
        aria-labelledby={title}
        aria-describedby={description}
        checked={checked}
        onChange={() => choose(set)}
      />
      <span>
        <strong id={title}>{titleOf(set)}</strong>
        <span id={description} class="dim">
          {descriptionOf(set)}
        </span>
      </span>
    </label>
  );
}

function same(one: BlockSet, other: BlockSet): boolean {
  return JSON.stringify(one) === JSON.stringify(other);
}
