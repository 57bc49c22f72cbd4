/** The chosen world: the menu that chooses another, edits it or carries it elsewhere. */

import { few, remember } from "../../features/worlds/recent";
import { WORLD_FILES } from "../../features/worlds/worlds";
import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import type { WorldChoice } from "../../protocol/messages";
import { chooseFile } from "../../ui/files";
import { Icon } from "../../ui/icons";
import { Menu, type MenuGroup, type MenuItem } from "../../ui/menu";

export function WorldMenu() {
  const page = usePage();
  const { context, project } = page;
  if (context.running.scene.value?.real) return null;
  const name = context.running.world.value;
  const all = project.worlds.value;
  const groups: readonly MenuGroup[] = [
    { title: t("page-world-this"), items: [...changes(page), ...files(page)] },
    { title: t("page-bar-worlds"), items: [everyWorld(page), ...few(all, name).map((one) => choice(page, one))] },
  ];
  return (
    <div class="world-menu">
      <Menu label={t("page-bar-world")} icon="world" groups={groups} look="raised" side="right">
        <span class="hidden">{t("page-bar-world")}: </span>
        <span class="world-name">{name ? project.worldTitle(name) : "…"}</span>
        <Icon name="down" />
      </Menu>
    </div>
  );
}

function everyWorld({ context, dialogs }: Page): MenuItem {
  const off = context.running.active.value;
  return { text: t("page-gallery-open"), icon: "top", off, run: () => dialogs.show("worlds") };
}

/** One of the worlds that were chosen last. */
function choice({ context, controls, project, worldPictures }: Page, world: WorldChoice): MenuItem {
  const { name, robots = 1 } = world;
  const title = project.worldTitle(name);
  return {
    text: robots > 1 ? t("page-bar-world-robots", { title, count: robots }) : title,
    picture: worldPictures.of(world),
    checked: name === context.running.world.value,
    off: context.running.active.value,
    run: () => {
      remember(name);
      controls.chooseWorld(name);
    },
  };
}

/** What changes the world that is shown. */
function changes({ context: { running }, controls, dialogs }: Page): readonly MenuItem[] {
  const off = running.active.value;
  const items: MenuItem[] = [
    { text: t("page-shell-reset-world"), icon: "restart", off, run: () => controls.resetWorld() },
    { text: t("page-bar-edit-world"), icon: "edit", off, run: () => dialogs.show("worldEditor") },
  ];
  if (running.scene.value?.world.vary) {
    items.push({
      text: t("page-worlds-variant-choose"),
      icon: "shuffle",
      off,
      run: () => dialogs.show("worldVariant"),
    });
  }
  return items;
}

/** What carries worlds to other places, renames and deletes them. */
function files({ context, dialogs, project, worlds }: Page): readonly MenuItem[] {
  const off = context.running.active.value;
  const name = context.running.world.value;
  const items: MenuItem[] = [
    {
      text: t("page-worlds-import"),
      icon: "upload",
      off,
      run: () => chooseFile(WORLD_FILES.join(","), (file) => void worlds.import(file)),
    },
    { text: t("page-worlds-export"), icon: "download", off, run: () => worlds.export(name) },
  ];
  if (project.worlds.value.some((one) => one.own && one.name === name)) {
    items.push(
      { text: t("page-worlds-rename"), icon: "rename", off, run: () => dialogs.show({ renameWorld: name }) },
      { text: t("page-worlds-delete"), icon: "trash", off, run: () => worlds.delete(name) },
    );
  }
  return items;
}
