/** The menu of what one can do with projects, named after the open one. */

import { t } from "../../i18n";
import { chooseFile } from "../files";
import { Icon } from "../widgets/icons";
import { Menu } from "../widgets/menu";
import { usePage, type Page } from "../page";

export const IMPORTED = ".learnblock,.bt,.py";

export function ProjectMenu() {
  const page = usePage();
  const { name, saved } = page.project;
  return (
    <>
      <Menu label={t("project.menu")} items={items(page)}>
        <span class="hidden">{t("project.menu")}: </span>
        <span class="project-name">{name.value || "…"}</span>
        <Icon name="down" />
      </Menu>
      <span class="saved">{t(saved.value ? "project.saved" : "project.saving")}</span>
    </>
  );
}

function items(page: Page) {
  const { dialogs, project } = page;
  const name = project.name.value;
  return [
    { text: t("project.new"), run: () => project.create(t("project.newName")) },
    { text: t("project.open"), run: () => dialogs.show("open") },
    { text: t("project.examples"), run: () => dialogs.show("examples") },
    { text: t("project.saveAs"), separated: true, run: () => dialogs.show("saveAs") },
    { text: t("project.history"), run: () => dialogs.show("history") },
    { text: t("blocksets.menu"), separated: true, run: () => dialogs.show("blockSets") },
    { text: t("ownblocks.menu"), run: () => dialogs.show("ownBlocks") },
    { text: t("libraries.menu"), run: () => dialogs.show("libraries") },
    { text: t("tags.menu"), run: () => dialogs.show("tags") },
    { text: t("project.upload"), separated: true, run: () => chooseFile(IMPORTED, (file) => void project.import(file)) },
    { text: t("project.download_learnblock"), run: () => project.export("learnblock") },
    { text: t("project.download_bt"), run: () => project.export("bt") },
    { text: t("project.download_py"), run: () => project.export("py") },
    { text: t("project.delete"), separated: true, run: () => dialogs.show({ delete: name }) },
  ];
}
