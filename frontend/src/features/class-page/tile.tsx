/** A pupil on the wall. */

import type { Phrase } from "../../i18n";
import { language, say, t } from "../../i18n";
import type { Seat } from "../../protocol/classroom";
import { Icon } from "../../ui/icons";
import { Menu } from "../../ui/menu";
import { needOf } from "./attention";
import { SmallWorld } from "./plan";
import type { ClassStream } from "./stream";

interface Props {
  readonly stream: ClassStream;
  readonly seat: Seat;
  readonly isProjected: boolean;
  readonly hint: (seat: Seat) => void;
  readonly remove: (seat: Seat) => void;
}

export function Tile({ stream, seat, isProjected, hint, remove }: Props) {
  const { id, name = "" } = seat;
  const need = needOf(seat);
  return (
    <li class={`tile ${need}`} aria-label={name}>
      <div class="tile-head">
        <strong>{name}</strong>
        <span class="tile-need">{needInWords(seat)}</span>
      </div>
      <SmallWorld plan={stream.plans.value.get(id)} seat={seat} label={t("page-class-world-of", { name })} />
      <p class="tile-step">
        <span>{stepInWords(seat)}</span>
        <span class={`tile-state ${seat.state ?? "idle"}`}>{t(`page-class-state-${seat.state ?? "idle"}`)}</span>
      </p>
      <p class="tile-error">{seat.error && need !== "away" ? say(seat.error as unknown as Phrase) : ""}</p>
      <div class="tile-tools">
        <a class="button bordered" href={pageOf(seat)} target="_blank" rel="noopener opener">
          {t("page-class-open")}
        </a>
        <button type="button" class="button bordered" onClick={() => hint(seat)}>
          <Icon name="hint" />
          {t("page-class-hint")}
        </button>
        <Menu
          label={t("page-class-more", { name })}
          icon="more"
          side="right"
          groups={[
            {
              items: [
                {
                  text: t(isProjected ? "page-class-unproject" : "page-class-project"),
                  run: () => stream.send({ kind: "ShowOnProjector", pupil: isProjected ? null : id }),
                },
                { text: t("page-class-renew-pin"), run: () => stream.send({ kind: "RenewPin", pupil: id }) },
                { text: t("page-class-export"), run: () => location.assign(`export.zip?pupil=${id}`) },
                { text: t("page-class-remove"), run: () => remove(seat) },
              ],
            },
          ]}
        />
      </div>
    </li>
  );
}

function needInWords(seat: Seat): string {
  const need = needOf(seat);
  const minutes = Math.floor((need === "stuck" ? (seat.stuck ?? 0) : (seat.quiet ?? 0)) / 60);
  return need === "fine" ? "" : t(`page-class-need-${need}`, { minutes });
}

/** The lesson and its step with the stars, or the project. */
function stepInWords({ lesson, step = 0, steps = 0, stars = 0, project = "" }: Seat): string {
  if (!step || !lesson) return project;
  const title = typeof lesson === "string" ? lesson : (lesson[language.value] ?? lesson.en ?? "");
  return t("page-class-step", { title, step, steps, stars });
}

/** The pupil's page, with the project that the pupil sees. */
function pageOf({ id, project }: Seat): string {
  return project ? `p/${id}/#${new URLSearchParams({ project })}` : `p/${id}/`;
}
