import { t } from "../i18n";
import { Icon, type IconName } from "./icons";
import { keysFor } from "./shortcuts";

interface Props {
  readonly icon: IconName;
  /** The code of the button's name. */
  readonly word: string;
  /** The values in the name. */
  readonly values?: Readonly<Record<string, string>>;
  /** Whether the name is shown beside the icon if there is room. */
  readonly named?: boolean;
  readonly look?: "go" | "halt";
  /** It keeps the focus while it is disabled, so that keyboard users do not lose their position. */
  readonly off?: boolean;
  readonly pressed?: boolean;
  readonly onClick: () => void;
}

/** A button with an icon; its tooltip shows the name and the keyboard shortcut. */
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
