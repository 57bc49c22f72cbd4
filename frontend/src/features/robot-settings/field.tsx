/** A field for one setting, with its limits and its error. */

import { useId } from "preact/hooks";

import { type Phrase, say, t, translated } from "../../i18n";
import type { Setting } from "../../protocol/messages";
import { beyond, formatValue, parseValue } from "./robot-settings";

interface Props {
  readonly setting: Setting;
  readonly value: unknown;
  /** Why it was refused. */
  readonly wrong: Phrase | undefined;
  readonly change: (value: unknown) => void;
}

interface InputProps extends Props {
  readonly id: string;
  readonly describedBy: string;
}

export function SettingField(props: Props) {
  const { setting, value, wrong, change } = props;
  const [id, about] = [useId(), useId()];
  const label = translated(`page-robots-setting-${setting.name.replaceAll("_", "-")}`, setting.name);
  const isUsual = JSON.stringify(value) === JSON.stringify(setting.default);
  return (
    <div class="setting">
      <label for={id}>{label}</label>
      <div class="setting-input">
        <Input {...props} id={id} describedBy={about} />
        {!isUsual && (
          <button
            type="button"
            class="button bordered"
            title={t("page-robots-usual-help")}
            onClick={() => change(setting.default)}
          >
            {t("page-robots-usual")}
          </button>
        )}
      </div>
      <div id={about}>
        <span class="dim">{aboutIt(setting, label)}</span>
        {wrong && <span class="refused">{say(wrong)}</span>}
      </div>
    </div>
  );
}

function Input({ setting, value, wrong, change, id, describedBy }: InputProps) {
  const common = { id, "aria-describedby": describedBy, "aria-invalid": wrong !== undefined };
  if (setting.sort === "boolean") {
    return (
      <input
        {...common}
        type="checkbox"
        checked={value === true}
        onChange={({ currentTarget }) => change(currentTarget.checked)}
      />
    );
  }
  const text = formatValue(setting, value);
  const typed = ({ currentTarget }: { currentTarget: { value: string } }) =>
    change(parseValue(setting, currentTarget.value));
  if (setting.sort === "choice")
    return <Choice {...common} choices={setting.choices ?? []} value={text} onChange={typed} />;
  if (setting.sort === "list") return <textarea {...common} rows={3} value={text} onChange={typed} />;
  const field = { ...common, value: text, onInput: typed };
  if (setting.secret) return <input {...field} type="password" autocomplete="off" />;
  if (setting.sort === "text") return <input {...field} type="text" spellcheck={false} />;
  return <input {...field} type="number" {...boundsOf(setting)} />;
}

interface ChoiceProps {
  readonly id: string;
  readonly choices: readonly string[];
  readonly value: string;
  readonly onChange: (event: { currentTarget: HTMLSelectElement }) => void;
}

function Choice({ choices, ...select }: ChoiceProps) {
  return (
    <select {...select}>
      {choices.map((one) => (
        <option key={one} value={one}>
          {one || t("page-robots-any")}
        </option>
      ))}
    </select>
  );
}

function boundsOf({ sort, least, most }: Setting) {
  return { min: least ?? undefined, max: most ?? undefined, step: sort === "whole" ? 1 : "any" };
}

/** The setting's help, with the limits that its field does not show. */
function aboutIt({ sort, allowed, description }: Setting, label: string): string {
  const shown = sort === "boolean" || sort === "choice" || sort === "text";
  const parts = [description ? beyond(label, say(description)) : "", shown || !allowed ? "" : say(allowed)];
  return parts.filter(Boolean).join(" · ");
}
