/** The form for a block besides its code: category, which gives it its colour, and words in each language. */

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { t } from "../../i18n";
import { LIMITS } from "../../protocol/messages";
import type { Palette } from "../../views/blocks/palette";
import { Committed } from "./committed";
import type { Editing } from "./editing";
import { WordsTable } from "./words-table";

const LONGEST_NAME = LIMITS.SaveCustomBlock.name;

export function Form({ editing }: { editing: Editing }) {
  const { draft, block } = editing;
  const shown = block.value;
  return (
    <div class="custom-block-form">
      <label class="field">
        {t("page-custom-name")}
        <input
          required
          maxLength={LONGEST_NAME}
          title={t("page-custom-name-help")}
          value={draft.written.value.name}
          onInput={({ currentTarget }) => draft.change({ name: currentTarget.value })}
        />
      </label>
      {shown ? <Choices editing={editing} /> : <p class="dim">{t("page-custom-no-block")}</p>}
      {shown && <WordsTable draft={draft} block={shown} preview={editing.shown.value} />}
    </div>
  );
}

function Choices({ editing: { draft, block, palette } }: { editing: Editing }) {
  const categories = useCategories(palette);
  const { name = "", category = "", shape = [] } = block.value ?? {};
  return (
    <>
      <label class="field">
        {t("page-custom-category")}
        <Committed
          list="custom-block-categories"
          longest={LONGEST_NAME}
          value={category}
          commit={(text) => draft.configure(name, (one) => ({ ...one, category: text }))}
        />
        <datalist id="custom-block-categories">
          {categories.map(([key, title]) => (
            <option key={key} value={key}>
              {title}
            </option>
          ))}
        </datalist>
      </label>
      <p class="field">
        {t("page-custom-shape")}
        <span class="dim">{t(shape.includes("blockVertical") ? "page-custom-statement" : "page-custom-value")}</span>
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

/** The palette's tabs of skills, each with its name in the user's language. */
function useCategories(palette: Promise<Palette>): readonly Category[] {
  const found = useSignal<readonly Category[]>([]);
  useEffect(
    () => void palette.then(({ toolbox }) => (found.value = (toolbox.contents as readonly Tab[]).flatMap(skillTab))),
    [],
  );
  return found.value;
}

function skillTab({ category = "", name = "", contents = [] }: Tab): Category[] {
  return contents.some(({ block = "" }) => block.startsWith("function.")) ? [[category, name]] : [];
}
