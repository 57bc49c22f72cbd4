/** A colour: one of several swatches, or any other. */

import { t } from "../../i18n";
import type { Described } from "./inputs";

export interface Swatch {
  readonly value: string;
  /** The colour that it shows, as in a style sheet. */
  readonly shown: string;
  readonly words: string;
}

interface Props {
  readonly swatches: readonly Swatch[];
  /** The value of a swatch, or "#rrggbb". */
  readonly value: string;
  readonly take: (value: string) => void;
  readonly described: Described;
}

export function ColourInput({ swatches, value, take, described }: Props) {
  const isMixed = !swatches.some((swatch) => swatch.value === value);
  const mixed = isMixed && value.startsWith("#") ? value : "#808080";
  return (
    <div class="form-swatches">
      {swatches.map((swatch) => (
        <label key={swatch.value} class="form-swatch" title={swatch.words}>
          <input
            type="radio"
            name={described.id}
            aria-label={swatch.words}
            checked={swatch.value === value}
            onChange={() => take(swatch.value)}
          />
          <span style={{ "--swatch": swatch.shown }} />
        </label>
      ))}
      <input
        type="color"
        class={isMixed && swatches.length > 0 ? "chosen" : undefined}
        value={mixed}
        title={t("page-form-mix")}
        aria-label={t("page-form-mix")}
        onInput={({ currentTarget }) => take(currentTarget.value)}
        aria-describedby={described["aria-describedby"]}
      />
    </div>
  );
}
