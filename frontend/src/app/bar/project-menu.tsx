/** The project menu, which shows the name of the open project. */

import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import { UPLOADS } from "../../model/upload";
import { chooseFiles } from "../../ui/files";
import { Icon } from "../../ui/icons";
import { Menu, type MenuGroup } from "../../ui/menu";
import { useOpening } from "../files/opening";

export function ProjectMenu() {
  const page = usePage();
  const open = useOpening();
  const { name } = page.project;
  const { saved, readOnly } = page.context.program;
  return (
    <>
      <Menu label={t("page-project-menu")} groups={groups(page, open)} look="title">
        <span class="hidden">{t("page-project-menu")}: </span>
        <span class="project-name">{name.value || "…"}</span>
        <Icon name="down" />
      </Menu>
      {!readOnly.value && (
        <span class="saved">
          <Icon name={saved.value ? "saved" : "saving"} />
          <span>{t(saved.value ? "page-project-saved" : "page-project-saving")}</span>
        </span>
      )}
    </>
  );
}

function groups(page: Page, open: (files: readonly File[]) => void): readonly MenuGroup[] {
  const { dialogs, project } = page;
  const name = project.name.value;
  return [
    {
      items: [
        { text: t("page-project-new"), run: () => dialogs.show("new") },
        { text: t("page-project-open"), run: () => dialogs.show("open") },
        { text: t("page-project-examples"), run: () => dialogs.show("examples") },
      ],
    },
    {
      items: [
        { text: t("page-project-rename"), run: () => dialogs.show("rename") },
        { text: t("page-project-save-as"), run: () => dialogs.show("saveAs") },
        { text: t("page-project-history"), run: () => dialogs.show("history") },
      ],
    },
    ...(page.pairs.canInvite ? [{ items: [{ text: t("page-pair-menu"), run: () => dialogs.show("invite") }] }] : []),
    {
      items: [
        { text: t("page-project-upload"), run: () => chooseFiles(UPLOADS.join(","), open) },
        { text: t("page-project-more"), run: () => dialogs.show("moreOfProject") },
      ],
    },
    { items: [{ text: t("page-project-delete"), run: () => dialogs.show({ delete: name }) }] },
  ];
}
