/** The user's own worlds in the gallery, and a place to begin one. */

import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import type { WorldChoice } from "../../protocol/messages";
import { day } from "../../ui/dates";
import { Icon } from "../../ui/icons";
import { Menu, type MenuItem } from "../../ui/menu";
import { WorldPicture } from "./card";

interface Props {
  readonly worlds: readonly WorldChoice[];
  readonly used: string;
  /** Whether worlds can be made and changed here, for which a project has to be open. */
  readonly canEdit: boolean;
  readonly use: (name: string) => void;
}

export function OwnWorlds({ worlds, used, canEdit, use }: Props) {
  const { dialogs } = usePage();
  return (
    <section class="own-worlds" aria-labelledby="own-worlds">
      <h3 id="own-worlds">
        <Icon name="projects" />
        {t("page-bar-own-worlds")}
      </h3>
      <ul>
        {canEdit && (
          <li>
            <button type="button" class="make-world" onClick={() => dialogs.show({ editWorld: "empty" })}>
              <Icon name="plus" />
              <span>
                <strong>{t("page-gallery-make")}</strong>
                <span class="dim">{t("page-gallery-make-help")}</span>
              </span>
            </button>
          </li>
        )}
        {worlds.map((world) => (
          <OwnWorld key={world.name} world={world} isUsed={world.name === used} canEdit={canEdit} use={use} />
        ))}
      </ul>
    </section>
  );
}

interface OwnProps extends Pick<Props, "canEdit" | "use"> {
  readonly world: WorldChoice;
  readonly isUsed: boolean;
}

function OwnWorld({ world, isUsed, canEdit, use }: OwnProps) {
  const page = usePage();
  const title = page.project.worldTitle(world.name);
  return (
    <li class="own-world">
      <button
        type="button"
        class="own-card"
        data-world={world.name}
        aria-current={isUsed ? "true" : undefined}
        onClick={() => use(world.name)}
      >
        <WorldPicture world={world} />
        <span>
          <strong>{title}</strong>
          <span class="dim">{isUsed ? t("page-gallery-used") : day(world.changed ?? 0)}</span>
        </span>
      </button>
      {canEdit && (
        <Menu
          label={t("page-gallery-more", { title })}
          icon="more"
          groups={[{ items: commands(page, world.name) }]}
          side="right"
        />
      )}
    </li>
  );
}

function commands({ dialogs, worlds }: Page, name: string): readonly MenuItem[] {
  return [
    { text: t("page-bar-edit-world"), icon: "edit", run: () => dialogs.show({ editWorld: name }) },
    { text: t("page-worlds-rename"), icon: "rename", run: () => dialogs.show({ renameWorld: name }) },
    { text: t("page-worlds-export"), icon: "download", run: () => worlds.export(name) },
    { text: t("page-worlds-delete"), icon: "trash", run: () => worlds.delete(name) },
  ];
}
