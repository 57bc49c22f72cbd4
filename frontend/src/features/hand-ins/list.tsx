/** The pupils of a step, grouped by what the teacher has to do. */

import { useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import type { HandInLine, HandInList } from "../../protocol/classroom";
import { Icon } from "../../ui/icons";
import { inLanguage } from "../lessons/texts";
import { GROUPS, type HandInStream, MOST_LINES } from "./stream";

export function HandInTable({ stream }: { stream: HandInStream }) {
  const list = stream.list.value;
  if (!list) return null;
  return (
    <>
      <Often list={list} />
      {list.lines?.length ? (
        <Lines stream={stream} lines={list.lines} />
      ) : (
        <p class="hand-ins-none">{t("page-handins-none", { step: list.step })}</p>
      )}
      <Without stream={stream} list={list} />
    </>
  );
}

/** What most pupils miss. Pupils who have not begun are not counted. */
function Often({ list: { often } }: { list: HandInList }) {
  if (!often) return null;
  return (
    <p class="hand-ins-often">
      <Icon name="error" />
      <span>
        <strong>{t("page-handins-often")}</strong> {inLanguage(often.missed)}{" "}
        {t("page-handins-pupils", { count: often.count })}
      </span>
    </p>
  );
}

/** Keys in the list, and by how many lines they move. */
const MOVES: Readonly<Record<string, number>> = { ArrowDown: 1, ArrowUp: -1, Home: -MOST_LINES, End: MOST_LINES };

/** One stop for Tab: the arrows move in it, and Enter goes on to the note. */
function Lines({ stream, lines }: { stream: HandInStream; lines: readonly HandInLine[] }) {
  const move = (event: KeyboardEvent) => {
    const by = MOVES[event.key];
    if (!by) return;
    event.preventDefault();
    stream.move(by, { stay: true });
  };
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the buttons in it take the keys
    <div class="hand-ins-lines" onKeyDown={move}>
      <div class="hand-ins-line head" aria-hidden="true">
        <span>{t("page-handins-pupil")}</span>
        <span>{t("page-handins-stars-head")}</span>
        <span>{t("page-handins-tries")}</span>
        <span>{t("page-handins-missed")}</span>
        <span>{t("page-handins-mark")}</span>
      </div>
      {GROUPS.map((group) => {
        const found = lines.filter(({ state }) => state === group);
        if (found.length === 0) return null;
        return (
          <section key={group} aria-labelledby={`group-${group}`}>
            <h3 id={`group-${group}`}>
              {t(`page-handins-state-${group.replace(" ", "-")}`)} · {found.length}
            </h3>
            <ul>
              {found.map((line) => (
                <Line key={line.pupil} stream={stream} line={line} />
              ))}
            </ul>
          </section>
        );
      })}
    </div>
  );
}

function Line({ stream, line }: { stream: HandInStream; line: HandInLine }) {
  const isShown = stream.pupil.value === line.pupil;
  const row = useRef<HTMLButtonElement>(null);
  useLayoutEffect(() => {
    if (isShown && stream.staysInList) row.current?.focus();
  }, [isShown, stream.focused.value]);
  return (
    <li>
      <button
        ref={row}
        type="button"
        class="hand-ins-line"
        aria-current={isShown ? "true" : undefined}
        tabIndex={isShown ? 0 : -1}
        onClick={() => stream.write(line.pupil)}
      >
        <bdi>{line.name}</bdi>
        <Stars line={line} />
        <span>{line.tries || "–"}</span>
        <span class="hand-ins-missed">{missed(line)}</span>
        <strong>{line.mark || (line.state === "to mark" ? t("page-handins-to-mark") : "")}</strong>
      </button>
    </li>
  );
}

function missed(line: HandInLine): string {
  if (!line.checked) return t("page-handins-unchecked");
  return inLanguage(line.missed) || t("page-handins-nothing");
}

export function Stars({ line: { stars = 0, checked } }: { line: HandInLine }) {
  if (!checked) return <span />;
  return (
    <span class="hand-ins-stars" role="img" aria-label={t("page-handins-stars", { stars })}>
      {[1, 2, 3].map((star) => (
        <Icon key={star} name={star <= stars ? "earned" : "star"} />
      ))}
    </span>
  );
}

/** Grey: they have no mark, and count under no mistake. */
function Without({ stream, list: { without = [] } }: { stream: HandInStream; list: HandInList }) {
  const notBegun = without.filter(({ state }) => state === "not begun");
  const others = without.filter(({ state }) => state === "not handed in");
  return (
    <>
      {notBegun.length > 0 && (
        <p class="hand-ins-without">
          <bdi>{notBegun.map(({ name }) => name).join(", ")}</bdi> {t("page-handins-not-begun")}
        </p>
      )}
      {others.length > 0 && (
        <div class="hand-ins-without">
          <p>
            <bdi>{others.map(({ name }) => name).join(", ")}</bdi> {t("page-handins-not-handed-in")}
          </p>
          <button type="button" class="button bordered" onClick={() => stream.collect()}>
            {t("page-handins-collect")}
          </button>
        </div>
      )}
    </>
  );
}
