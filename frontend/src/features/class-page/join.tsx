/** The page on which children come in: word, name, pictures. */

import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import { Icon } from "../../ui/icons";
import { RobotPicture } from "../../ui/robots/picture";
import { type Room, room } from "../../ui/screen";
import { Logo } from "../start/logo";
import { Door } from "./door";
import { LanguageChoice } from "./frame";
import type { Joining } from "./joining";
import { PictureRow } from "./pictures";
import "./join.css";

/** The robots are beside the questions, or above them. */
const LAYOUTS: Readonly<Record<Room, string>> = { wide: "", medium: "above", narrow: "above small" };

export function JoinPage({ joining }: { joining: Joining }) {
  const about = joining.about.value;
  useEffect(() => void joining.load(), []);
  return (
    <div class={`join ${LAYOUTS[room.value]}`}>
      <Scene />
      <main class="join-main">
        {about && <Inside joining={joining} />}
        <LanguageChoice />
      </main>
    </div>
  );
}

function Inside({ joining }: { joining: Joining }) {
  if (joining.joined.value?.pictures) return <Remember joining={joining} />;
  return joining.about.value?.pupil ? <Again joining={joining} /> : <Door joining={joining} />;
}

/** The robots that wait in the class. */
function Scene() {
  return (
    <header class="join-scene">
      <p>
        <Logo size={40} />
        LearnBlock
      </p>
      {["thymio", "ev3", "ebo", "cozmo"].map((robot) => (
        <RobotPicture key={robot} robot={robot} />
      ))}
    </header>
  );
}

/** The browser knows a pupil. */
function Again({ joining }: { joining: Joining }) {
  const { pupil, address, title } = joining.about.value!;
  return (
    <section class="join-card">
      <p class="join-class">{t("page-class-title", { title })}</p>
      <h1>{t("page-class-hello", { name: pupil })}</h1>
      <a class="join-go" href={address}>
        <Icon name="next" />
        {t("page-class-go-on")}
      </a>
      <button type="button" class="button bordered" onClick={() => void joining.leave()}>
        {t("page-class-not-me", { name: pupil })}
      </button>
    </section>
  );
}

/** A new pupil learns the pictures by heart. */
function Remember({ joining }: { joining: Joining }) {
  const { pictures = [], address } = joining.joined.value!;
  return (
    <section class="join-card">
      <h1>{t("page-class-remember", { name: joining.name.value.trim() })}</h1>
      <p>{t("page-class-remember-text")}</p>
      <PictureRow pictures={pictures} />
      <a class="join-go" href={address}>
        <Icon name="next" />
        {t("page-class-remembered")}
      </a>
    </section>
  );
}
