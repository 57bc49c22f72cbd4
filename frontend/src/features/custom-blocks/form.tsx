/** The form for a block besides its code: category, which gives it its colour, and words in each language. */

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { t } from "../../i18n";
import { LIMITS } from "../../protocol/messages";
import { FormField } from "../../ui/form/field";
import type { Palette } from "../../views/blocks/palette";
import type { Editing } from "./editing";
import { WordsTable } from "./words-table";

const LONGEST_NAME = LIMITS.SaveCustomBlock.name;

export function Form({ editing }: { editing: Editing }) {
  const { draft, block } = editing;
  const shown = block.value;
  return (
    <div class="custom-block-form">
      <FormField
        label={t("page-custom-name")}
        help={t("page-custom-name-help")}
        shape={{ kind: "text", longest: LONGEST_NAME }}
        value={draft.written.value.name}
        take={(name) => draft.change({ name: name ?? "" })}
      />
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
      <FormField
        label={t("page-custom-category")}
        shape={{ kind: "text", longest: LONGEST_NAME, isCommitted: true }}
        known={categories}
        value={category}
        take={(text) => draft.configure(name, (old) => ({ ...old, category: text ?? "" }))}
      />
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
