/** What can be done with the set of blocks that is being looked at. */

import { useSignal } from "@preact/signals";

import type { LabelledTab } from "../../blocks/labels";
import { titleOf } from "../../blocksets/library";
import { setOf, type Draft } from "../../blocksets/ticks";
import { language, t } from "../../i18n";
import type { BlockSet } from "../../messages";
import { chooseFile } from "../files";
import { usePage, type Page } from "../page";
import { Actions } from "../widgets/dialog";

/** As the server takes it. */
const LONGEST_NAME = 60;
const NAME = "[\\p{L}\\p{N}_]([\\p{L}\\p{N}_ \\-]*[\\p{L}\\p{N}_])?";

interface Props {
  readonly draft: Draft;
  readonly tabs: readonly LabelledTab[];
  readonly look: (set: BlockSet) => void;
}

export function BlockSetActions({ draft, tabs, look }: Props) {
  const page = usePage();
  const { blockSets, dialogs } = page;
  const naming = useSignal(false);
  const isOurs = blockSets.ours.value.some((one) => one.name === draft.base.name);
  const isOwn = blockSets.own.value.some((one) => one.name === draft.base.name);
  const empty = draft.ticks.blocks.size === 0;
  const leave = () => {
    blockSets.draft.value = null;
    dialogs.close();
  };
  const show = () => {
    leave();
    choose(page, draft.changed && isOurs ? renamed(setOf(draft, tabs), blockSets.ours.value) : setOf(draft, tabs));
  };
  if (naming.value) return <SaveForm draft={draft} tabs={tabs} look={look} done={() => (naming.value = false)} />;
  return (
    <>
      {empty && <p class="dim">{t("blocksets.empty")}</p>}
      <Actions cancel={leave}>
        <button type="button" class="button bordered" onClick={() => chooseFile(".toml", (file) => void blockSets.readFile(file))}>
          {t("blocksets.load")}
        </button>
        <button type="button" class="button bordered" onClick={() => blockSets.export(setOf(draft, tabs))}>
          {t("blocksets.download")}
        </button>
        {isOwn && (
          <button type="button" class="button bordered" onClick={() => (blockSets.delete(draft.base), look(blockSets.shown.peek()))}>
            {t("blocksets.delete")}
          </button>
        )}
        <button type="button" class="button bordered" disabled={empty} onClick={() => (naming.value = true)}>
          {t("blocksets.saveAs")}
        </button>
        <button type="button" class="button filled" disabled={empty} onClick={show}>
          {t("blocksets.show")}
        </button>
      </Actions>
    </>
  );
}

function SaveForm({ draft, tabs, look, done }: Props & { done: () => void }) {
  const { blockSets } = usePage();
  const isOurs = blockSets.ours.value.some((one) => one.name === draft.base.name);
  const name = useSignal(isOurs ? t("blocksets.myBlocks") : (draft.base.name ?? ""));
  const taken = blockSets.own.value.some((one) => one.name === name.value.trim());
  const save = (event: SubmitEvent) => {
    event.preventDefault();
    const set = named(setOf(draft, tabs), name.value.trim());
    blockSets.save(set, taken);
    look(set);
    done();
  };
  return (
    <form onSubmit={save}>
      <label class="field">
        {t("blocksets.name")}
        <input
          required
          autofocus
          pattern={NAME}
          maxLength={LONGEST_NAME}
          value={name.value}
          onInput={({ currentTarget }) => (name.value = currentTarget.value)}
        />
      </label>
      <p class="dim" role="status">
        {taken ? t("blocksets.replaces") : t("blocksets.saveHelp")}
      </p>
      <Actions cancel={done}>
        <button type="submit" class="button filled">
          {t("blocksets.save")}
        </button>
      </Actions>
    </form>
  );
}

/** The set under a name that its author gave it, which is its title too. */
function named(set: BlockSet, name: string): BlockSet {
  return name === set.name ? set : { ...set, name, title: { [language.peek()]: name } };
}

/** One of ours that was changed is no longer ours. */
function renamed(set: BlockSet, ours: readonly BlockSet[]): BlockSet {
  const title = titleOf(ours.find((one) => one.name === set.name) ?? set);
  return named(set, t("blocksets.changed", { title }));
}

/** Show a set's blocks; it can be taken back. */
function choose({ blockSets, toasts }: Page, set: BlockSet): void {
  const before = blockSets.shown.peek();
  blockSets.choose(set);
  const action = { text: t("blocksets.undo"), run: () => blockSets.choose(before) };
  toasts.show({ sort: "note", text: t("blocksets.shownNow", { title: titleOf(set) }), action });
}
