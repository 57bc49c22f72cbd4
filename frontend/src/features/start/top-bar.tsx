import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { language, languages, t } from "../../i18n";
import { usePage } from "../../model/page";
import { prefer } from "../../model/preferences";
import { Icon, type IconName } from "../../ui/icons";
import { languageName } from "../../ui/language-name";
import { Menu } from "../../ui/menu";
import { PupilChip } from "../in-class/notes";
import { Logo } from "./logo";

/** The sections of the page, with their icons. */
const PLACES: readonly (readonly [string, IconName])[] = [
  ["home", "home"],
  ["lessons", "lesson"],
  ["examples", "examples"],
  ["projects", "projects"],
];

export function TopBar() {
  const { classes, classNews } = usePage();
  const news = classNews.now.value;
  const atTeachers = classes.shown.value;
  const wanted = useSignal("");
  const show = (place: string) => {
    classes.shown.value = false;
    wanted.value = place;
  };
  useEffect(() => {
    // The sections are there once what is for teachers has gone.
    if (!wanted.value || atTeachers) return;
    goTo(wanted.value);
    wanted.value = "";
  }, [wanted.value, atTeachers]);
  return (
    <header class="start-bar">
      <Logo />
      <span class="start-brand">{news?.title ? t("page-class-title", { title: news.title }) : "LearnBlock"}</span>
      <nav aria-label={t("page-start-places")}>
        {PLACES.map(([name, icon]) => (
          <button
            key={name}
            type="button"
            aria-current={name === "home" && !atTeachers ? "page" : undefined}
            onClick={() => show(name)}
          >
            <Icon name={icon} />
            <span>{t(`page-start-${name}`)}</span>
          </button>
        ))}
      </nav>
      <PupilChip />
      <LanguageMenu />
      {!news && (
        <button
          type="button"
          class="button"
          aria-current={atTeachers ? "page" : undefined}
          onClick={() => (classes.shown.value = true)}
        >
          <Icon name="teachers" />
          <span>{t("page-start-teachers")}</span>
        </button>
      )}
    </header>
  );
}

function LanguageMenu() {
  const items = languages.map((code) => ({
    text: languageName(code),
    checked: code === language.value,
    run: () => prefer({ language: code }),
  }));
  return (
    <Menu label={t("page-bar-language")} icon="globe" groups={[{ items }]} side="right">
      <span class="hidden">{t("page-bar-language")}: </span>
      <span>{languageName(language.value)}</span>
      <Icon name="down" />
    </Menu>
  );
}

/** Scroll to a section, and put the focus there. */
function goTo(name: string): void {
  const section = document.getElementById(name);
  section?.scrollIntoView({ block: "start" });
  section?.focus({ preventScroll: true });
}
