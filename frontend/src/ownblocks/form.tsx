/** What is chosen for a block besides its code: where it lies, its colour, its words in every language. */

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import type { Palette } from "../blocks/palette";
import { t } from "../i18n";
import { Committed } from "./committed";
import type { Editing } from "./editing";
import { WordsTable } from "./wordstable";

const TYPES = ["motor", "perceptual", "proprioceptive", "express", "control", "operator", "others"] as const;
/** As the server takes it. */
const LONGEST_NAME = 100;

export function Form({ editing }: { editing: Editing }) {
  const { draft, block } = editing;
  const shown = block.value;
  return (
    <div class="own-block-form">
      <label class="field">
        {t("ownblocks.name")}
        <input
          required
          maxLength={LONGEST_NAME}
          title={t("ownblocks.nameHelp")}
          value={draft.written.value.name}
          onInput={({ currentTarget }) => draft.change({ name: currentTarget.value })}
        />
      </label>
      {shown ? <Choices editing={editing} /> : <p class="dim">{t("ownblocks.noBlock")}</p>}
      {shown && <WordsTable draft={draft} block={shown} preview={editing.shown.value} />}
    </div>
  );
}

function Choices({ editing: { draft, block, palette } }: { editing: Editing }) {
  const categories = useCategories(palette);
  const { name = "", category = "", type = "", shape = [] } = block.value ?? {};
  return (
    <>
      <label class="field">
        {t("ownblocks.category")}
        <Committed
          list="own-block-categories"
          longest={LONGEST_NAME}
          value={category}
          commit={(text) => draft.configure(name, (one) => ({ ...one, category: text }))}
        />
        <datalist id="own-block-categories">
          {categories.map(([key, title]) => (
            <option key={key} value={key}>
              {title}
            </option>
          ))}
        </datalist>
      </label>
      <label class="field">
        {t("ownblocks.colour")}
        <select value={type} onChange={({ currentTarget }) => draft.configure(name, (one) => ({ ...one, type: currentTarget.value }))}>
          {TYPES.map((one) => (
            <option key={one} value={one}>
              {t(`ownblocks.type_${one}`)}
            </option>
          ))}
        </select>
      </label>
      <p class="field">
        {t("ownblocks.shape")}
        <span class="dim">{t(shape.includes("blockVertical") ? "ownblocks.statement" : "ownblocks.value")}</span>
      </p>
    </>
  );
}

type Category = readonly [key: string, title: string];

interface Tab {
  readonly category?: string;
  readonly name?: string;
  readonly contents?: readonly { readonly block?: string }[];
}

/** The tabs of skills that there are, each with its name in the user's language. */
function useCategories(palette: Promise<Palette>): readonly Category[] {
  const found = useSignal<readonly Category[]>([]);
  useEffect(() => void palette.then(({ toolbox }) => (found.value = (toolbox.contents as readonly Tab[]).flatMap(skillTab))), []);
  return found.value;
}

function skillTab({ category = "", name = "", contents = [] }: Tab): Category[] {
  return contents.some(({ block = "" }) => block.startsWith("function.")) ? [[category, name]] : [];
}
