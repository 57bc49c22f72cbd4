/** The project menu, which shows the name of the open project. */

import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import { UPLOADS } from "../../model/upload";
import { chooseFiles, chooseFolder } from "../../ui/files";
import { Icon } from "../../ui/icons";
import { Menu } from "../../ui/menu";
import { useOpening } from "../files/opening";

export function ProjectMenu() {
  const page = usePage();
  const open = useOpening();
  const { name } = page.project;
  const { saved, readOnly } = page.context.program;
  return (
    <>
      <Menu label={t("page-project-menu")} items={items(page, open)}>
        <span class="hidden">{t("page-project-menu")}: </span>
        <span class="project-name">{name.value || "…"}</span>
        <Icon name="down" />
      </Menu>
      <span class="saved">{!readOnly.value && t(saved.value ? "page-project-saved" : "page-project-saving")}</span>
    </>
  );
}

function items(page: Page, open: (files: readonly File[]) => void) {
  const { dialogs, project } = page;
  const name = project.name.value;
  return [
    { text: t("page-project-new"), run: () => dialogs.show("new") },
    { text: t("page-project-open"), run: () => dialogs.show("open") },
    { text: t("page-project-examples"), run: () => dialogs.show("examples") },
    { text: t("page-project-rename"), separated: true, run: () => dialogs.show("rename") },
    { text: t("page-project-save-as"), run: () => dialogs.show("saveAs") },
    { text: t("page-project-history"), run: () => dialogs.show("history") },
    { text: t("page-sets-menu"), separated: true, run: () => dialogs.show("blockSets") },
    { text: t("page-custom-menu"), run: () => dialogs.show("customBlocks") },
    { text: t("page-libraries-menu"), run: () => dialogs.show("libraries") },
    { text: t("page-tags-menu"), run: () => dialogs.show("tags") },
    {
      text: t("page-project-upload"),
      separated: true,
      run: () => chooseFiles(UPLOADS.join(","), open),
    },
    { text: t("page-project-upload-folder"), run: () => chooseFolder(open) },
    { text: t("page-project-download-learnblock"), run: () => project.export("learnblock") },
    { text: t("page-project-download-bt"), run: () => project.export("bt") },
    { text: t("page-project-download-py"), run: () => project.export("py") },
    { text: t("page-project-delete"), separated: true, run: () => dialogs.show({ delete: name }) },
  ];
}
