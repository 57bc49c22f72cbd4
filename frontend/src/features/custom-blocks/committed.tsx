import { useSignal } from "@preact/signals";

interface Props {
  /** Its accessible name if it is not inside a label. */
  readonly label?: string;
  /** The id of its list of suggestions. */
  readonly list?: string;
  readonly longest?: number;
  readonly value: string;
  readonly commit: (text: string) => void;
}

/** An input that reports its text when it loses the focus; a half-typed text is not overwritten. */
export function Committed({ label, list, longest, value, commit }: Props) {
  const typed = useSignal<string | null>(null);
  const end = () => {
    if (typed.value !== null) commit(typed.value.trim());
    typed.value = null;
  };
  return (
    <input
      aria-label={label}
      list={list}
      maxLength={longest}
      value={typed.value ?? value}
      onInput={({ currentTarget }) => (typed.value = currentTarget.value)}
      onChange={end}
    />
  );
}
