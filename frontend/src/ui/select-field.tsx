/** A field with a list of choices. */

interface Props {
  readonly label: string;
  readonly value: string;
  readonly choose: (value: string) => void;
  /** Values and their words. */
  readonly children: readonly (readonly [string, string])[];
}

export function SelectField({ label, value, choose, children }: Props) {
  return (
    <label class="field">
      {label}
      <select value={value} onChange={({ currentTarget }) => choose(currentTarget.value)}>
        {children.map(([name, text]) => (
          <option key={name} value={name}>
            {text}
          </option>
        ))}
      </select>
    </label>
  );
}
