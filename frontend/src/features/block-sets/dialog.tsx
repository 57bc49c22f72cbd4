/** The dialog for choosing blocks. */

import { useComputed, useSignal, useSignalEffect } from "@preact/signals";
import { useEffect, useId } from "preact/hooks";
import { language, say, t } from "../../i18n";
import { usePage } from "../../model/page";
import type { BlockSet } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";
import { BlockSetActions } from "./actions";
import { descriptionOf, titleOf } from "./block-sets";
import { BlockTree } from "./block-tree";
import type { LabelledTab } from "./labels";
import { ticksOf } from "./ticks";
import "./dialog.css";

export function BlockSetsDialog() {
  const { dialogs, blockSets } = usePage();
  const tabs = useSignal<readonly LabelledTab[] | null>(null);
  const { ticked } = blockSets;
  const failed = useSignal(false);
  const look = (base: BlockSet) => {
    ticked.value = { base, ticks: ticksOf(base, tabs.value ?? []), changed: false };
  };
  useEffect(() => blockSets.list(), []);
  useSignalEffect(() => {
    void load(language.value)
      .then((found) => {
        tabs.value = found;
        if (!ticked.peek()?.changed) look(blockSets.shown.peek());
      })
      .catch(() => (failed.value = true));
  });
  useSignalEffect(() => {
    if (blockSets.read.value && tabs.value) look(blockSets.read.value);
  });
  return (
    <Dialog title={t("page-sets-title")} close={() => dialogs.close()} size="large">
      {failed.value && <p role="alert">{t("page-blocks-failed")}</p>}
      {ticked.value && tabs.value && (
        <>
          <div class="block-sets">
            <Sets chosen={ticked.value.base} choose={look} />
            <BlockTree
              tabs={tabs.value}
              ticks={ticked.value.ticks}
              changed={ticked.value.changed}
              change={(ticks) => (ticked.value = { ...ticked.value!, ticks, changed: true })}
            />
          </div>
          <Refusals />
          <Deleted look={look} />
          <BlockSetActions key={ticked.value.base.name} ticked={ticked.value} tabs={tabs.value} look={look} />
        </>
      )}
    </Dialog>
  );
}

async function load(code: string): Promise<readonly LabelledTab[]> {
  const { labelledTabs } = await import("./labels");
  return labelledTabs(code);
}

function Refusals() {
  const { requests, problems } = usePage().blockSets;
  const sentences = [requests.refusal.value, ...problems.value].filter(Boolean);
  return (
    <div role="alert" class="refusals">
      {sentences.map((one) => (
        <p key={one}>{say(one)}</p>
      ))}
    </div>
  );
}

/** The deleted set, with undo. */
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
          <span>{t("page-sets-deleted", { title: titleOf(deleted.value) })}</span>
          <button type="button" class="button bordered" onClick={() => deleted.value && undo(deleted.value)}>
            {t("page-sets-undo")}
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
      <SetGroup word="page-sets-ours" sets={ours.value} chosen={chosen} choose={choose} />
      <SetGroup word="page-sets-carried" sets={alone.value} chosen={chosen} choose={choose} />
      <SetGroup word="page-sets-own" sets={own.value} chosen={chosen} choose={choose} />
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
