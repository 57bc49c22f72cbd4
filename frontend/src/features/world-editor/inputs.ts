/** Inputs that refuse values a world file does not allow, and show what is allowed. */

import { t } from "../../i18n";

/** An input that accepts its text only if it is valid. */
export function checked(input: HTMLInputElement, wrong: () => string | null, take: () => void): HTMLInputElement {
  const judge = (): boolean => {
    const message = wrong();
    input.setCustomValidity(message ?? "");
    input.ariaInvalid = String(message !== null);
    return message === null;
  };
  input.addEventListener("input", () => judge() && take());
  input.addEventListener("change", () => input.reportValidity());
  return input;
}

interface Bounds {
  readonly least: number;
  readonly most: number;
  readonly whole?: boolean;
  readonly optional?: boolean;
}

/** A number within bounds; an optional one may be empty. */
export function numeric(
  value: number | null,
  { least, most, whole = false, optional = false }: Bounds,
  take: (text: string) => void,
): HTMLInputElement {
  const input = document.createElement("input");
  input.type = "number";
  input.step = whole ? "1" : "any";
  input.min = String(least);
  input.max = String(most);
  input.value = value === null ? "" : String(value);
  if (optional) input.placeholder = t("page-editor-none");
  const wrong = (): string | null => {
    if (input.value === "" && optional && !input.validity.badInput) return null;
    const number = Number(input.value);
    const allowed = input.value !== "" && number >= least && number <= most && (!whole || Number.isInteger(number));
    return allowed ? null : t(whole ? "page-editor-wants-whole" : "page-editor-wants-number", { least, most });
  };
  return checked(input, wrong, () => take(input.value));
}

/** A button with a sign and an accessible name. */
export function smallButton(sign: string, label: string, act: () => void): HTMLButtonElement {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "small";
  button.textContent = sign;
  button.ariaLabel = button.title = label;
  button.addEventListener("click", act);
  return button;
}
