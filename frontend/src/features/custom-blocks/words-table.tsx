/** A block's words in each language: its text, its tooltip, its parameters. */

import { useSignal } from "@preact/signals";

import { language, languages, t } from "../../i18n";
import type { CustomBlockPreview } from "../../protocol/messages";
import { TextInput } from "../../ui/form/inputs";
import { type Argument, argumentsOf } from "./arguments";
import { type Configured, languagesOf, type Words, withVariable, withWord } from "./configuration";
import type { CustomBlockEdit } from "./custom-block-edit";

/** Languages offered besides those that the block already has. */
const OFFERED = [
  "AR",
  "CA",
  "DE",
  "EL",
  "EN",
  "ES",
  "EU",
  "FR",
  "GL",
  "IT",
  "JA",
  "KO",
  "NL",
  "PL",
  "PT",
  "RO",
  "RU",
  "SV",
  "TR",
  "UK",
  "ZH",
];

const COMMITTED = { kind: "text", isCommitted: true } as const;

interface Props {
  readonly draft: CustomBlockEdit;
  readonly block: Configured;
  readonly preview: CustomBlockPreview | null;
}

export function WordsTable({ draft, block, preview }: Props) {
  const added = useSignal<readonly string[]>([]);
  const own = languages.map((code) => code.toUpperCase());
  const codes = languagesOf(block, [...own, ...added.value]);
  const fields = new Map(preview ? argumentsOf(preview).map((one) => [one.name, one]) : []);
  const change = (update: (one: Configured) => Configured) => draft.configure(block.name, update);
  return (
    <div class="custom-block-words">
      <table>
        <caption>{t("page-custom-words")}</caption>
        <thead>
          <tr>
            <td />
            <th scope="col">{t("page-custom-field")}</th>
            {codes.map((code) => (
              <th scope="col" key={code}>
                {nameOf(code)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          <Row
            title={t("page-custom-label")}
            words={block.languages}
            codes={codes}
            set={(code, text) => change((one) => ({ ...one, languages: withWord(one.languages, code, text) }))}
          />
          <Row
            title={t("page-custom-tooltip")}
            words={block.tooltip}
            codes={codes}
            set={(code, text) => change((one) => ({ ...one, tooltip: withWord(one.tooltip, code, text) }))}
          />
          {block.variables?.map(({ name, translate }) => (
            <Row
              key={name}
              title={name}
              field={fields.get(name)}
              words={translate}
              codes={codes}
              set={(code, text) =>
                change((one) =>
                  withVariable(one, name, (old) => ({ ...old, translate: withWord(old.translate, code, text) })),
                )
              }
            />
          ))}
        </tbody>
      </table>
      <AddLanguage known={codes} add={(code) => (added.value = [...added.value, code])} />
    </div>
  );
}

interface RowProps {
  readonly title: string;
  readonly field?: Argument | undefined;
  readonly words: Words | undefined;
  readonly codes: readonly string[];
  readonly set: (code: string, text: string) => void;
}

function Row({ title, field, words = {}, codes, set }: RowProps) {
  return (
    <tr>
      <th scope="row">{title}</th>
      <td class="dim">{field && fieldText(field)}</td>
      {codes.map((code) => (
        <td key={code}>
          <TextInput
            shape={COMMITTED}
            value={words[code] ?? ""}
            take={(text) => set(code, text ?? "")}
            described={{ "aria-label": `${title}, ${nameOf(code)}` }}
          />
        </td>
      ))}
    </tr>
  );
}

/** The type of a parameter's field, with its limits. */
function fieldText({ kind, allowed: { min, max } }: Argument): string {
  const text = t(`page-custom-field-${kind}`);
  return min !== undefined && max !== undefined ? `${text}, ${min}–${max}` : text;
}

function AddLanguage({ known, add }: { known: readonly string[]; add: (code: string) => void }) {
  const others = OFFERED.filter((code) => !known.includes(code));
  return (
    <select
      aria-label={t("page-custom-add-language")}
      value=""
      onChange={({ currentTarget }) => currentTarget.value && add(currentTarget.value)}
    >
      <option value="">{t("page-custom-add-language")}</option>
      {others.map((code) => (
        <option key={code} value={code}>
          {nameOf(code)}
        </option>
      ))}
    </select>
  );
}

/** A language's name in the page's language; its code if there is none. */
function nameOf(code: string): string {
  try {
    return new Intl.DisplayNames([language.value], { type: "language" }).of(code) ?? code;
  } catch {
    // A configuration may contain anything; the server reports the mistakes.
    return code;
  }
}
