/** The menu of the page itself: help, stage, language, settings. */

import { language, languages, t } from "../../i18n";
import type { Dialogs } from "../../model/dialogs";
import { usePage } from "../../model/page";
import { chooseStage, prefer, preferences, STAGES } from "../../model/preferences";
import { languageName } from "../../ui/language-name";
import { Menu, type MenuItem } from "../../ui/menu";
import { keysFor } from "../../ui/shortcuts";

export function MoreMenu() {
  const { dialogs } = usePage();
  const { stage } = preferences.value;
  const groups = [
    {
      items: [
        {
          text: t("page-help-title"),
          icon: "help" as const,
          key: keysFor("page-help-title"),
          run: () => dialogs.show("help"),
        },
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
      items: [
        { text: t("page-device-title"), run: () => dialogs.show("otherDevice") },
        { text: t("page-settings-title"), run: () => dialogs.show("settings") },
      ],
    },
    // For those who set LearnBlock up: a child's menu stays short.
    ...(stage === "coder" ? [{ items: settingUp(dialogs) }] : []),
  ];
  return <Menu label={t("page-bar-more")} icon="more" groups={groups} side="right" />;
}

function settingUp(dialogs: Dialogs): MenuItem[] {
  return [
    { text: t("page-robots-perception-menu"), run: () => dialogs.show("perception") },
    { text: t("page-containment-menu"), run: () => dialogs.show("containment") },
    { text: t("page-newrobot-menu"), run: () => dialogs.show("newRobot") },
  ];
}
