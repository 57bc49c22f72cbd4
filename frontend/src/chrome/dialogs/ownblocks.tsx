/** Dialogs about the blocks that the user has made: all of them, and one to be edited. */

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import type { OwnBlock } from "../../messages";
import { said } from "../../sentences";
import { IconButton } from "../widgets/button";
import { Dialog } from "../widgets/dialog";
import { Icon } from "../widgets/icons";
import { IslandPlace } from "../widgets/island";
import { usePage } from "../page";
import type { OwnBlockDialogName } from "./dialogs";
import "./ownblocks.css";

/** How an exported block's file ends. */
export const EXPORTED = ".block.json";

export function OwnBlocksDialog() {
  const { context, dialogs, shelf } = usePage();
  const search = useSignal("");
  useFocusAfterwards();
  useEffect(() => {
    shelf.outcome.value = null;
    shelf.list();
  }, []);
  const blocks = shelf.blocks.value ?? [];
  const found = blocks.filter((one) => matches(one, search.value));
  return (
    <Dialog title={t("ownblocks.title")} close={() => dialogs.close()} size="large">
      <p class="dim">{t("ownblocks.help")}</p>
      <div class="own-blocks-tools">
        <button type="button" class="button filled" onClick={() => context.editOwnBlock("")}>
          {t("ownblocks.new")}
        </button>
        <ImportButton />
        <label class="field">
          {t("ownblocks.search")}
          <input type="search" value={search.value} onInput={({ currentTarget }) => (search.value = currentTarget.value)} />
        </label>
      </div>
      <OutcomeLine />
      {found.length === 0 && <p role="status">{t(blocks.length ? "ownblocks.noneFound" : "ownblocks.none")}</p>}
      <ul class="rows">
        {found.map((one) => (
          <Entry key={one.name} block={one} />
        ))}
      </ul>
    </Dialog>
  );
}

/** The palette's button that opened a dialog may be gone with the palette: its view has the focus then. */
function useFocusAfterwards(): void {
  const { views } = usePage();
  const focusBlocks = () => document.activeElement === document.body && views.focus("blocks");
  useEffect(() => () => void requestAnimationFrame(focusBlocks), []);
}

function matches({ name, category, blocks }: OwnBlock, words: string): boolean {
  return [name, category, ...blocks].join(" ").toLowerCase().includes(words.trim().toLowerCase());
}

function Entry({ block: { name, category, blocks, problems } }: { block: OwnBlock }) {
  const { context, shelf } = usePage();
  const wrong = problems.find((one) => one.severity === "error");
  return (
    <li>
      <button type="button" class="row-main" onClick={() => context.editOwnBlock(name, wrong?.line)}>
        <strong>{name}</strong>
        <span class="dim">{[category, blocks.join(", ")].filter(Boolean).join(" · ")}</span>
        {wrong && (
          <span class="own-block-wrong">
            <Icon name="error" /> {said(wrong.message)}
          </span>
        )}
      </button>
      <IconButton icon="copy" word="ownblocks.duplicate" values={{ name }} onClick={() => shelf.duplicate(name)} />
      <IconButton icon="download" word="ownblocks.export" values={{ name }} onClick={() => shelf.export(name)} />
      <IconButton icon="trash" word="ownblocks.delete" values={{ name }} onClick={() => shelf.delete(name)} />
    </li>
  );
}

function ImportButton() {
  const { shelf } = usePage();
  const choose = () => {
    const input = document.createElement("input");
    input.type = "file";
    input.accept = EXPORTED;
    input.onchange = () => {
      const file = input.files?.[0];
      if (file) void shelf.import(file);
    };
    input.click();
  };
  return (
    <button type="button" class="button bordered" title={t("ownblocks.importHelp")} onClick={choose}>
      {t("ownblocks.import")}
    </button>
  );
}

/** What became of the last thing that was done, and what can be done about that. */
function OutcomeLine() {
  const { shelf } = usePage();
  const button = useRef<HTMLButtonElement>(null);
  const outcome = shelf.outcome.value;
  // The button that had the focus has gone with its row.
  useEffect(() => {
    if (outcome?.action) button.current?.focus();
  }, [outcome]);
  const { sort = "done", message, word = "", values, action } = outcome ?? {};
  const act = () => {
    shelf.outcome.value = null;
    action?.run();
  };
  return (
    <div class={`own-blocks-outcome ${sort}`} role={sort === "done" ? "status" : "alert"}>
      {outcome && <span>{message ? said(message) : t(word, values)}</span>}
      {action && (
        <button type="button" class="button bordered" ref={button} onClick={act}>
          {t(action.word)}
        </button>
      )}
    </div>
  );
}

export function OwnBlockDialog({ name }: { name: OwnBlockDialogName }) {
  const page = usePage();
  useFocusAfterwards();
  const saved = useSignal(name.ownBlock);
  const close = () => page.dialogs.close();
  const load = async () => {
    const { createOwnBlockEditor } = await import("../../ownblocks");
    return createOwnBlockEditor(page, saved, name.line);
  };
  const title = saved.value ? t("ownblocks.edit", { name: saved.value }) : t("ownblocks.newTitle");
  return (
    <Dialog title={title} close={close} size="whole">
      <IslandPlace load={load} />
    </Dialog>
  );
}
