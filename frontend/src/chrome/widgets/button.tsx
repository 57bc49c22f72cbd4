import { t } from "../../i18n";
import { Icon, type IconName } from "./icons";
import { keysFor } from "../shortcuts";

interface Props {
  readonly icon: IconName;
  /** A key of the translations: the button's name. */
  readonly word: string;
  /** What the name speaks of. */
  readonly values?: Readonly<Record<string, string>>;
  /** Whether the name stands beside the icon where there is room. */
  readonly named?: boolean;
  readonly look?: "go" | "halt";
  /** It keeps the focus while it is off, so that the keyboard does not lose its place. */
  readonly off?: boolean;
  readonly pressed?: boolean;
  readonly onClick: () => void;
}

/** A button with an icon, its name as a tooltip, and the keys that do the same. */
export function IconButton({ icon, word, values, named, look, off, pressed, onClick }: Props) {
  const name = t(word, values);
  const keys = keysFor(word);
  return (
    <button
      type="button"
      class={["button", look, named && "named"].filter(Boolean).join(" ")}
      title={keys ? `${name} (${keys})` : name}
      aria-label={name}
      aria-disabled={off ? "true" : undefined}
      aria-pressed={pressed}
      onClick={() => off || onClick()}
    >
      <Icon name={icon} />
      {named && <span aria-hidden="true">{name}</span>}
    </button>
  );
}
