/** What can be done with the chosen world as a whole. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { chooseFile } from "../../ui/files";
import { Menu, type MenuItem } from "../../ui/menu";
import { useWorlds, WORLD_FILES } from "./worlds";

export function WorldMenu() {
  const { context, dialogs, project } = usePage();
  const worlds = useWorlds();
  const name = context.running.world.value;
  const isOwn = project.worlds.value.some((one) => one.own && one.name === name);
  const items: MenuItem[] = [
    {
      text: t("page-worlds-import"),
      run: () => chooseFile(WORLD_FILES.join(","), (file) => void worlds.import(file)),
    },
    { text: t("page-worlds-export"), run: () => worlds.export(name) },
  ];
  if (isOwn) {
    items.push(
      { text: t("page-worlds-rename"), separated: true, run: () => dialogs.show("renameWorld") },
      { text: t("page-worlds-delete"), run: () => worlds.delete(name) },
    );
  }
  return <Menu label={t("page-worlds-menu")} icon="more" items={items} side="right" />;
}
