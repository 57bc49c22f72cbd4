/** The teams of a world, as the page shows them. */

import { friendly } from "./colours";
import type { WorldValues } from "./description";

/** The colour of a team in the notation of style sheets; null without such a team. */
export function colourOfTeam({ team }: Pick<WorldValues, "team">, name: string | null | undefined): string | null {
  const named = name ? team.find((one) => one.name === name) : undefined;
  return named ? friendly(named.colour) : null;
}
