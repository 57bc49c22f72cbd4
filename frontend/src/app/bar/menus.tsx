/** Menus of the page itself: language, theme, help. */

import { language, languages, t } from "../../i18n";
import { usePage } from "../../model/page";
import { prefer, preferences, THEMES } from "../../model/preferences";
import { languageName } from "../../ui/language-name";
import { Menu } from "../../ui/menu";

export function LanguageMenu() {
  const items = languages.map((code) => ({
    text: languageName(code),
    checked: code === language.value,
    run: () => prefer({ language: code }),
  }));
  return <Menu label={t("page-bar-language")} icon="globe" items={items} side="right" />;
}

export function ThemeMenu() {
  const items = THEMES.map((theme) => ({
    text: t(`page-settings-theme-${theme}`),
    checked: theme === preferences.value.theme,
    run: () => prefer({ theme }),
  }));
  return <Menu label={t("page-bar-theme")} icon="theme" items={items} side="right" />;
}

export function HelpMenu() {
  const { dialogs } = usePage();
  const items = [
    { text: t("page-tour-title"), run: () => (dialogs.tour.value = true) },
    { text: t("page-settings-shortcuts"), run: () => dialogs.show("shortcuts") },
    { text: t("page-project-examples"), run: () => dialogs.show("examples") },
    { text: t("page-settings-title"), separated: true, run: () => dialogs.show("settings") },
    { text: t("page-robots-robots-menu"), run: () => dialogs.show("robotSettings") },
    { text: t("page-newrobot-menu"), run: () => dialogs.show("newRobot") },
    { text: t("page-robots-perception-menu"), run: () => dialogs.show("perception") },
    { text: t("page-containment-menu"), run: () => dialogs.show("containment") },
  ];
  return <Menu label={t("page-bar-help")} icon="help" items={items} side="right" />;
}
