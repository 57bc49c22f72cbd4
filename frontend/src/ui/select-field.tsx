/** A field with a list of choices. */

interface Props {
  readonly label: string;
  readonly value: string;
  readonly choose: (value: string) => void;
  /** Whether it has the focus in a dialog that opens. */
  readonly autofocus?: boolean;
  /** Values and their words. */
  readonly children: readonly (readonly [string, string])[];
}

export function SelectField({ label, value, choose, autofocus, children }: Props) {
  return (
    <label class="field">
      {label}
      <select autofocus={autofocus} value={value} onChange={({ currentTarget }) => choose(currentTarget.value)}>
        {children.map(([name, text]) => (
          <option key={name} value={name}>
            {text}
          </option>
        ))}
      </select>
    </label>
  );
}
