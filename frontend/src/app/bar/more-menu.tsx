/** The menu of the page itself: help, stage, language, theme, settings. */

import { language, languages, t } from "../../i18n";
import { usePage } from "../../model/page";
import { chooseStage, prefer, preferences, STAGES, THEMES } from "../../model/preferences";
import { languageName } from "../../ui/language-name";
import { Menu } from "../../ui/menu";

export function MoreMenu() {
  const { dialogs } = usePage();
  const { stage, theme } = preferences.value;
  const groups = [
    {
      title: t("page-bar-help"),
      items: [
        { text: t("page-tour-title"), run: () => (dialogs.tour.value = true) },
        { text: t("page-settings-shortcuts"), run: () => dialogs.show("shortcuts") },
      ],
    },
    {
      title: t("page-bar-stage"),
      items: STAGES.map((name) => ({
        text: t(`page-bar-stage-${name}`),
        checked: name === stage,
        run: () => chooseStage(name),
      })),
    },
    {
      title: t("page-bar-language"),
      items: languages.map((code) => ({
        text: languageName(code),
        checked: code === language.value,
        run: () => prefer({ language: code }),
      })),
    },
    {
      title: t("page-bar-theme"),
      items: THEMES.map((name) => ({
        text: t(`page-settings-theme-${name}`),
        checked: name === theme,
        run: () => prefer({ theme: name }),
      })),
    },
    {
      items: [
        { text: t("page-device-title"), run: () => dialogs.show("otherDevice") },
        { text: t("page-settings-title"), run: () => dialogs.show("settings") },
        { text: t("page-robots-perception-menu"), run: () => dialogs.show("perception") },
        { text: t("page-containment-menu"), run: () => dialogs.show("containment") },
        { text: t("page-newrobot-menu"), run: () => dialogs.show("newRobot") },
      ],
    },
  ];
  return <Menu label={t("page-bar-more")} icon="more" groups={groups} side="right" />;
}
