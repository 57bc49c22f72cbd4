/** The upper edge of the wall: the lesson that is on, how to join, and what reaches all pages at once. */

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { language, languages, t } from "../../i18n";
import { prefer } from "../../model/preferences";
import type { LessonOffer, Wall } from "../../protocol/classroom";
import { Icon } from "../../ui/icons";
import { languageName } from "../../ui/language-name";
import { Menu } from "../../ui/menu";
import { inLanguage } from "../lessons/texts";
import { printClass } from "./print-programs";
import type { ClassStream } from "./stream";
import { lessonInWords, pictureOf } from "./words";

/** ms between two looks at the clock. */
const TICK = 15_000;

interface LessonProps {
  /** The lesson on; undefined without one. */
  readonly lesson: LessonOffer | undefined;
  readonly handOut: () => void;
}

export function LessonButton({ lesson, handOut }: LessonProps) {
  const picture = lesson && pictureOf(lesson);
  return (
    <button type="button" class="wall-lesson" aria-haspopup="dialog" onClick={handOut}>
      {picture ? <img src={picture} alt="" width={48} height={34} /> : <Icon name="lesson" />}
      <span>
        <strong class={lesson ? "hidden" : undefined}>{t("page-class-hand-out")}</strong>
        {lesson && <strong>{inLanguage(lesson.title)}</strong>}
        {lesson && <small>{lessonInWords(lesson)}</small>}
      </span>
      <Icon name="down" />
    </button>
  );
}

/** How many of the lesson's minutes are left since it was handed out. It never rings. */
export function MinutesLeft({ lesson, began }: { lesson: LessonOffer | undefined; began: number }) {
  const now = useSignal(Date.now());
  useEffect(() => {
    const clock = setInterval(() => (now.value = Date.now()), TICK);
    return () => clearInterval(clock);
  }, []);
  if (!lesson || !began) return null;
  const left = Math.ceil(lesson.minutes - (now.value / 1000 - began) / 60);
  if (left < 1) return null;
  return (
    <span class="wall-clock">
      <Icon name="wait" />
      {t("page-class-left", { minutes: Math.min(left, lesson.minutes) })}
    </span>
  );
}

interface ToolsProps {
  readonly stream: ClassStream;
  readonly wall: Wall;
  readonly showJoin: () => void;
  readonly hintAll: () => void;
}

export function Tools({ stream, wall, showJoin, hintAll }: ToolsProps) {
  const print = () => {
    const failed = () => (stream.refused.value = { code: "page-class-print-none" });
    printClass().then((isPrinted) => isPrinted || failed(), failed);
  };
  return (
    <div class="class-tools">
      <button type="button" class="button bordered" aria-haspopup="dialog" onClick={showJoin}>
        <Icon name="qrCode" />
        <span>
          {/* At a hub, pupils log in instead. */}
          <span class={wall.word ? "wide" : undefined}>
            {t(wall.word ? "page-class-join-word" : "page-class-join-address")}
          </span>{" "}
          <b>{wall.word}</b>
        </span>
      </button>
      <a class="button bordered" href="projector" target="_blank" rel="noopener opener">
        <Icon name="projector" />
        <span class="wide">{t("page-class-projector")}</span>
      </a>
      <button
        type="button"
        class="button bordered"
        aria-pressed={wall.eyes_up}
        onClick={() => stream.rest(!wall.eyes_up)}
      >
        <Icon name="eye" />
        {t("page-class-eyes-up-button")}
      </button>
      <button type="button" class="button halt" onClick={() => stream.send({ kind: "StopAll" })}>
        <Icon name="stop" />
        {t("page-class-stop-all")}
      </button>
      <Menu
        label={t("page-class-more-tools")}
        icon="more"
        side="right"
        groups={[
          {
            items: [
              { text: t("page-class-hint-all"), icon: "hint", run: hintAll },
              {
                text: t("page-class-sharing"),
                icon: "game",
                on: wall.sharing ?? false,
                run: () => stream.send({ kind: "LetShareWorlds", on: !wall.sharing }),
              },
              {
                text: t("page-class-showing"),
                icon: "share",
                on: wall.showing ?? false,
                run: () => stream.send({ kind: "LetShowPrograms", on: !wall.showing }),
              },
              { text: t("page-class-export-all"), icon: "download", run: () => location.assign("export.zip") },
              // At a hub, the programs are on pupils' servers.
              ...(wall.word ? [{ text: t("page-class-print-all"), icon: "print", run: print } as const] : []),
            ],
          },
          {
            title: t("page-bar-language"),
            items: languages.map((code) => ({
              text: languageName(code),
              checked: code === language.value,
              run: () => prefer({ language: code }),
            })),
          },
        ]}
      />
    </div>
  );
}
