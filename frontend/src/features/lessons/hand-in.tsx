/** In the lesson's card in a class: hand the step in, and what the teacher has handed back. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { NotedLine, OwnHandIn } from "../../protocol/classroom";
import type { LessonShown } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { RunThatWasHandedIn } from "../in-class/handed-in-run";
import { inLanguage } from "./texts";
import "./hand-in.css";

/** The button; steps without checks have nothing to hand in. */
export function HandInButton({ shown }: { shown: LessonShown }) {
  const { handIns } = usePage();
  if (!handIns.all.value || !shown.goals?.length) return null;
  const before = handIns.of(shown.name ?? "", shown.step ?? 1);
  return (
    <button
      type="button"
      class={before?.improving ? "button filled" : "button bordered"}
      onClick={() => handIns.handIn()}
    >
      <Icon name="move" />
      {t(before ? "page-handins-own-again" : "page-handins-own")}
    </button>
  );
}

/** What has become of the hand-in of the open step. */
export function HandedIn({ shown }: { shown: LessonShown }) {
  const { handIns } = usePage();
  const found = handIns.of(shown.name ?? "", shown.step ?? 1);
  if (!found) return null;
  const back = handIns.back(found.lesson, found.step);
  return (
    <div class="handed-in" role="status">
      {found.waits && <p>{t("page-handins-own-waits")}</p>}
      {found.improving && (
        <p>
          {t("page-handins-own-improving")} {found.back?.note} <NotedPlace line={found.back?.line} />
        </p>
      )}
      {back && <Back handIn={back} />}
    </div>
  );
}

/** On a phone: that the work is back, which opens the card. */
export function BackLine({ shown, open }: { shown: LessonShown; open: () => void }) {
  const { handIns } = usePage();
  if (!handIns.back(shown.name ?? "", shown.step ?? 1)) return null;
  return (
    <button type="button" class="button filled" onClick={open}>
      <Icon name="lesson" />
      {t("page-handins-own-back")}
    </button>
  );
}

/** The teacher's note first, then what was reached, then what was missed. */
function Back({ handIn }: { handIn: OwnHandIn }) {
  const { handIns } = usePage();
  const { note, mark, checked, line } = handIn.back ?? {};
  const checks = checked?.checks ?? [];
  const runs = checked?.runs ?? 0;
  const inTurn = [...checks].sort((a, b) => Number(b.met === runs) - Number(a.met === runs));
  return (
    <section class="handed-back">
      <h3>
        <Icon name="lesson" />
        {t("page-handins-own-back")}
        {mark && <strong class="handed-back-mark">{t("page-handins-own-mark", { mark })}</strong>}
      </h3>
      {note && (
        <p class="handed-back-note">
          <strong>{t("page-handins-own-teacher")}</strong> {note} <NotedPlace line={line} />
        </p>
      )}
      <ul>
        {inTurn.map((check, index) => (
          <li key={index} class={check.met === runs ? "met" : "failed"}>
            <Icon name={check.met === runs ? "check" : "close"} />
            {inLanguage(check.met === runs ? check.say : check.reason || check.say)}
          </li>
        ))}
      </ul>
      <div class="handed-back-buttons">
        <button type="button" class="button filled" onClick={() => handIns.improve(handIn)}>
          <Icon name="restart" />
          {t("page-handins-own-improve")}
        </button>
        <button type="button" class="button bordered" onClick={() => (handIns.run.value = handIn)}>
          <Icon name="run" />
          {t("page-handins-your-run")}
        </button>
        <button type="button" class="button bordered" onClick={() => handIns.putAway(handIn)}>
          {t("page-handins-own-later")}
        </button>
      </div>
      <RunThatWasHandedIn handIn={handIn} />
    </section>
  );
}

/** What the note is about: a button to the marked block, or the line as it was if that is gone. */
function NotedPlace({ line }: { line: NotedLine | null | undefined }) {
  const { handIns, context } = usePage();
  const block = handIns.noted.value;
  if (!line) return null;
  if (!block) return <span class="handed-back-gone">{t("page-handins-own-gone", { line: line.text })}</span>;
  return (
    <button type="button" class="handed-back-line" onClick={() => context.reveal(block)}>
      <Icon name="blocks" />
      {t("page-handins-own-line", { line: line.text })}
    </button>
  );
}
