/** The actions for the set in the dialog. */

import { useSignal } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import { language, t } from "../../i18n";
import { usePage } from "../../model/page";
import { type BlockSet, LIMITS } from "../../protocol/messages";
import { Actions } from "../../ui/dialog";
import { chooseFile } from "../../ui/files";
import type { Toasts } from "../../ui/toasts";
import { type BlockSets, titleOf } from "./block-sets";
import type { LabelledTab } from "./labels";
import { setOf, type TickedBlocks } from "./ticks";

const NAME = "[\\p{L}\\p{N}_]([\\p{L}\\p{N}_ \\-]*[\\p{L}\\p{N}_])?";

interface Props {
  readonly ticked: TickedBlocks;
  readonly tabs: readonly LabelledTab[];
  readonly look: (set: BlockSet) => void;
}

export function BlockSetActions({ ticked, tabs, look }: Props) {
  const { dialogs, toasts, blockSets } = usePage();
  const naming = useSignal(false);
  const isOurs = blockSets.ours.value.some((one) => one.name === ticked.base.name);
  const isOwn = blockSets.own.value.some((one) => one.name === ticked.base.name);
  const empty = ticked.ticks.blocks.size === 0;
  const leave = () => {
    blockSets.ticked.value = null;
    dialogs.close();
  };
  const show = () => {
    leave();
    choose(
      blockSets,
      toasts,
      ticked.changed && isOurs ? renamed(setOf(ticked, tabs), blockSets.ours.value) : setOf(ticked, tabs),
    );
  };
  const remove = () => {
    blockSets.delete(ticked.base);
    look(blockSets.shown.peek());
  };
  if (naming.value) return <SaveForm ticked={ticked} tabs={tabs} look={look} done={() => (naming.value = false)} />;
  return (
    <>
      {empty && <p class="dim">{t("page-sets-empty")}</p>}
      <Actions cancel={leave}>
        <button
          type="button"
          class="button bordered"
          onClick={() => chooseFile(".toml", (file) => void blockSets.readFile(file))}
        >
          {t("page-sets-load")}
        </button>
        <button type="button" class="button bordered" onClick={() => blockSets.export(setOf(ticked, tabs))}>
          {t("page-sets-download")}
        </button>
        {isOwn && (
          <button type="button" class="button bordered" onClick={remove}>
            {t("page-sets-delete")}
          </button>
        )}
        <button type="button" class="button bordered" disabled={empty} onClick={() => (naming.value = true)}>
          {t("page-sets-save-as")}
        </button>
        <button type="button" class="button filled" disabled={empty} onClick={show}>
          {t("page-sets-show")}
        </button>
      </Actions>
    </>
  );
}

function SaveForm({ ticked, tabs, look, done }: Props & { done: () => void }) {
  const { blockSets } = usePage();
  const isOurs = blockSets.ours.value.some((one) => one.name === ticked.base.name);
  const name = useSignal(isOurs ? t("page-sets-my-blocks") : (ticked.base.name ?? ""));
  const taken = blockSets.own.value.some((one) => one.name === name.value.trim());
  const form = useRef<HTMLFormElement>(null);
  useLayoutEffect(() => form.current?.scrollIntoView({ block: "nearest" }), []);
  const save = (event: SubmitEvent) => {
    event.preventDefault();
    const set = named(setOf(ticked, tabs), name.value.trim());
    blockSets.save(set, taken);
    look(set);
    done();
  };
  return (
    <form ref={form} onSubmit={save}>
      <label class="field">
        {t("page-sets-name")}
        <input
          required
          autofocus
          pattern={NAME}
          maxLength={LIMITS.BlockSet.name}
          value={name.value}
          onInput={({ currentTarget }) => (name.value = currentTarget.value)}
        />
      </label>
      <p class="dim" role="status">
        {taken ? t("page-sets-replaces") : t("page-sets-save-help")}
      </p>
      <Actions cancel={done}>
        <button type="submit" class="button filled">
          {t("page-sets-save")}
        </button>
      </Actions>
    </form>
  );
}

/** The set with a name given by the user, which is its title too. */
function named(set: BlockSet, name: string): BlockSet {
  return name === set.name ? set : { ...set, name, title: { [language.peek()]: name } };
}

/** A changed built-in set becomes the user's own. */
function renamed(set: BlockSet, ours: readonly BlockSet[]): BlockSet {
  const title = titleOf(ours.find((one) => one.name === set.name) ?? set);
  return named(set, t("page-sets-changed", { title }));
}

/** Show a set's blocks, with undo. */
function choose(blockSets: BlockSets, toasts: Toasts, set: BlockSet): void {
  const before = blockSets.shown.peek();
  blockSets.choose(set);
  const action = { text: t("page-sets-undo"), run: () => blockSets.choose(before) };
  toasts.show({ sort: "note", text: t("page-sets-shown-now", { title: titleOf(set) }), action });
}
