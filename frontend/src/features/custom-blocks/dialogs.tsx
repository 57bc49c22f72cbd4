/** The dialogs for custom blocks: the list, and the editor of one. */

import { useSignal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { say, t } from "../../i18n";
import type { CustomBlockDialogName } from "../../model/dialogs";
import { usePage } from "../../model/page";
import type { CustomBlock } from "../../protocol/messages";
import { IconButton } from "../../ui/button";
import { Dialog } from "../../ui/dialog";
import { chooseFile } from "../../ui/files";
import { Icon } from "../../ui/icons";
import { IslandPlace } from "../../ui/island-place";
import "./dialogs.css";

/** The file extension of an exported block. */
export const EXPORTED = ".block.json";

export function CustomBlocksDialog() {
  const { context, dialogs } = usePage();
  const shelf = usePage().customBlocks;
  const search = useSignal("");
  useFocusAfterwards();
  useEffect(() => {
    shelf.outcome.value = null;
    shelf.list();
  }, []);
  const blocks = shelf.blocks.value ?? [];
  const found = blocks.filter((one) => matches(one, search.value));
  return (
    <Dialog title={t("page-custom-title")} close={() => dialogs.close()} size="large">
      <p class="dim">{t("page-custom-help")}</p>
      <div class="custom-blocks-tools">
        <button type="button" class="button filled" onClick={() => context.editCustomBlock("")}>
          {t("page-custom-new")}
        </button>
        <ImportButton />
        <label class="field">
          {t("page-custom-search")}
          <input
            type="search"
            value={search.value}
            onInput={({ currentTarget }) => (search.value = currentTarget.value)}
          />
        </label>
      </div>
      <OutcomeLine />
      {found.length === 0 && <p role="status">{t(blocks.length ? "page-custom-none-found" : "page-custom-none")}</p>}
      <ul class="rows">
        {found.map((one) => (
          <Entry key={one.name} block={one} />
        ))}
      </ul>
    </Dialog>
  );
}

/** The palette may have closed together with the button that opened the dialog: focus its view instead. */
function useFocusAfterwards(): void {
  const { views } = usePage();
  const focusBlocks = () => document.activeElement === document.body && views.focus("blocks");
  useEffect(() => () => void requestAnimationFrame(focusBlocks), []);
}

function matches({ name, category, blocks }: CustomBlock, words: string): boolean {
  return [name, category, ...blocks].join(" ").toLowerCase().includes(words.trim().toLowerCase());
}

function Entry({ block: { name, category, blocks, problems } }: { block: CustomBlock }) {
  const { context } = usePage();
  const shelf = usePage().customBlocks;
  const wrong = problems.find((one) => one.severity === "error");
  return (
    <li>
      <button type="button" class="row-main" onClick={() => context.editCustomBlock(name, wrong?.line)}>
        <strong>{name}</strong>
        <span class="dim">{[category, blocks.join(", ")].filter(Boolean).join(" · ")}</span>
        {wrong && (
          <span class="custom-block-wrong">
            <Icon name="error" /> {say(wrong.message)}
          </span>
        )}
      </button>
      <IconButton icon="copy" word="page-custom-duplicate" values={{ name }} onClick={() => shelf.duplicate(name)} />
      <IconButton icon="download" word="page-custom-export" values={{ name }} onClick={() => shelf.export(name)} />
      <IconButton icon="trash" word="page-custom-delete" values={{ name }} onClick={() => shelf.delete(name)} />
    </li>
  );
}

function ImportButton() {
  const shelf = usePage().customBlocks;
  return (
    <button
      type="button"
      class="button bordered"
      title={t("page-custom-import-help")}
      onClick={() => chooseFile(EXPORTED, (file) => void shelf.import(file))}
    >
      {t("page-custom-import")}
    </button>
  );
}

/** The outcome of the last action, and the actions that the user can take. */
function OutcomeLine() {
  const shelf = usePage().customBlocks;
  const button = useRef<HTMLButtonElement>(null);
  const outcome = shelf.outcome.value;
  // The focused button disappeared with its row.
  useLayoutEffect(() => {
    if (outcome?.action) button.current?.focus();
  }, [outcome]);
  const { sort = "done", message, word = "", values, action } = outcome ?? {};
  const act = () => {
    shelf.outcome.value = null;
    action?.run();
  };
  return (
    <div class={`custom-blocks-outcome ${sort}`} role={sort === "done" ? "status" : "alert"}>
      {outcome && <span>{message ? say(message) : t(word, values)}</span>}
      {action && (
        <button type="button" class="button bordered" ref={button} onClick={act}>
          {t(action.word)}
        </button>
      )}
    </div>
  );
}

export function CustomBlockDialog({ name }: { name: CustomBlockDialogName }) {
  const page = usePage();
  useFocusAfterwards();
  const saved = useSignal(name.customBlock);
  const close = () => page.dialogs.close();
  const load = async () => {
    const { createCustomBlockEditor } = await import(".");
    return createCustomBlockEditor(page, saved, name.line);
  };
  const title = saved.value ? t("page-custom-edit", { name: saved.value }) : t("page-custom-new-title");
  return (
    <Dialog title={title} close={close} size="whole">
      <IslandPlace load={load} />
    </Dialog>
  );
}
