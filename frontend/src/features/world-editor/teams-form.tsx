/** The teams of a world: their names and colours, and which robots are in them. */

import { t } from "../../i18n";
import { FormField } from "../../ui/form/field";
import { Tick } from "../../ui/form/inputs";
import { Parts } from "../../ui/form/parts";
import { colourIn, written } from "../../views/world/scenery/colours";
import type { TeamValues, WorldValues } from "../../views/world/scenery/description";
import { namedSwatches, nameOfColour } from "./swatches";
import { MOST_TEAMS, newTeam, withStartIn, withTeams } from "./teams";

/** As long as a name in a world's file. */
const NAME = { kind: "text", shortest: 1, longest: 40, isCommitted: true } as const;

interface Props {
  readonly world: WorldValues;
  readonly change: (world: WorldValues) => void;
}

export function Teams({ world, change }: Props) {
  return (
    <fieldset class="form-group" data-key="team">
      <legend>{t("page-editor-teams")}</legend>
      <Parts
        values={world.team}
        take={(teams) => change(withTeams(world, teams))}
        title={(number) => t("page-editor-team", { number })}
        add={t("page-editor-add-team")}
        fresh={() => newTeam(world, nameOfColour)}
        most={MOST_TEAMS}
      >
        {(team, take) => (
          <>
            <Looks team={team} take={take} />
            <Robots world={world} team={team} change={change} />
          </>
        )}
      </Parts>
    </fieldset>
  );
}

function Looks({ team, take }: { team: TeamValues; take: (team: TeamValues) => void }) {
  return (
    <>
      <FormField
        label={t("page-editor-key-name")}
        shape={NAME}
        value={team.name}
        take={(name) => take({ ...team, name: name ?? "" })}
      />
      <FormField
        label={t("page-editor-key-colour")}
        shape={{ kind: "colour" }}
        swatches={namedSwatches()}
        value={written(team.colour)}
        take={(colour) => take({ ...team, colour: colourIn(colour) })}
      />
    </>
  );
}

/** A tick for each start: a robot is in the team of the start that it takes. */
function Robots({ world, team, change }: Props & { team: TeamValues }) {
  return (
    <fieldset class="form-group">
      <legend>{t("page-editor-team-robots")}</legend>
      {world.start.map(({ name }) => (
        <Tick
          key={name}
          text={name}
          value={team.robots.includes(name)}
          take={(isIn) => change(withStartIn(world, name, isIn ? team.name : null))}
        />
      ))}
    </fieldset>
  );
}
