/** Menus for the page itself: language, theme, help. */

import { language, languages, t } from "../../i18n";
import { prefer, preferences, type Preferences } from "../../preferences";
import { Menu } from "../widgets/menu";
import { usePage } from "../page";

const THEMES: readonly Preferences["theme"][] = ["system", "light", "dark", "contrast"];

/** A language's own name for itself. */
export function languageName(code: string): string {
  const name = new Intl.DisplayNames([code], { type: "language" }).of(code) ?? code;
  return name.charAt(0).toLocaleUpperCase(code) + name.slice(1);
}

export function LanguageMenu() {
  const items = languages.map((code) => ({
    text: languageName(code),
    checked: code === language.value,
    run: () => prefer({ language: code }),
  }));
  return <Menu label={t("bar.language")} icon="globe" items={items} side="right" />;
}

export function ThemeMenu() {
  const items = THEMES.map((theme) => ({
    text: t(`settings.theme_${theme}`),
    checked: theme === preferences.value.theme,
    run: () => prefer({ theme }),
  }));
  return <Menu label={t("bar.theme")} icon="theme" items={items} side="right" />;
}

export function HelpMenu() {
  const { dialogs } = usePage();
  const items = [
    { text: t("tour.title"), run: () => (dialogs.tour.value = true) },
    { text: t("settings.shortcuts"), run: () => dialogs.show("shortcuts") },
    { text: t("project.examples"), run: () => dialogs.show("examples") },
    { text: t("settings.title"), separated: true, run: () => dialogs.show("settings") },
    { text: t("machine.robotsMenu"), run: () => dialogs.show("robotSettings") },
    { text: t("newrobot.menu"), run: () => dialogs.show("newRobot") },
    { text: t("machine.perceptionMenu"), run: () => dialogs.show("perception") },
  ];
  return <Menu label={t("bar.help")} icon="help" items={items} side="right" />;
}
