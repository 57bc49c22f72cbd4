/** A pupil who can be chosen among others. */

import type { Seat } from "../../protocol/classroom";

interface Props {
  readonly seat: Seat;
  /** The ids of the chosen pupils. */
  readonly chosen: ReadonlySet<string>;
  readonly choose: (chosen: ReadonlySet<string>) => void;
}

export function PupilTick({ seat: { id, name }, chosen, choose }: Props) {
  const change = (isChosen: boolean) => {
    const ids = new Set(chosen);
    if (isChosen) ids.add(id);
    else ids.delete(id);
    choose(ids);
  };
  return (
    <label>
      <input type="checkbox" checked={chosen.has(id)} onChange={({ currentTarget }) => change(currentTarget.checked)} />
      <bdi>{name}</bdi>
    </label>
  );
}
