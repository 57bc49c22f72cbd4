/** A dialog's list of classmates, of whom one is chosen. */

import type { Classmate } from "../../protocol/classroom";
import "./pairs.css";

interface Props {
  /** Null until the class has answered. */
  readonly classmates: readonly Classmate[] | null;
  /** What to say if there are none. */
  readonly none: string;
  readonly choose: (classmate: Classmate) => void;
}

export function ChooseClassmate({ classmates, none, choose }: Props) {
  if (classmates === null) return null;
  if (classmates.length === 0) return <p class="dim">{none}</p>;
  return (
    <ul class="classmates">
      {classmates.map((one) => (
        <li key={one.id}>
          <button type="button" class="button bordered" onClick={() => choose(one)}>
            {one.name}
          </button>
        </li>
      ))}
    </ul>
  );
}
