import { useSignal } from "@preact/signals";

interface Props {
  /** Its name, where no label stands round it. */
  readonly label?: string;
  /** The id of what it offers. */
  readonly list?: string;
  readonly longest?: number;
  readonly value: string;
  readonly commit: (text: string) => void;
}

/** An input whose text counts once it is left: what is half written is neither told nor overwritten. */
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
