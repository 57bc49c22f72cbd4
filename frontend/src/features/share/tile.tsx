/** A way to take the program elsewhere, in the dialog Share. */

import { t } from "../../i18n";
import { Icon, type IconName } from "../../ui/icons";

interface Props {
  readonly icon: IconName;
  /** The end of the codes of its name and of what it says below. */
  readonly word: string;
  /** What it says below, if not what its code says. */
  readonly help?: string;
  readonly off?: boolean;
  readonly onClick: () => void;
}

export function Tile({ icon, word, help, off, onClick }: Props) {
  return (
    <button type="button" class="share-tile" disabled={off} onClick={onClick}>
      <Icon name={icon} />
      <span>
        <strong>{t(`page-share-${word}`)}</strong>
        <span class="dim">{help ?? t(`page-share-${word}-help`)}</span>
      </span>
    </button>
  );
}
