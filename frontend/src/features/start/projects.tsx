/** The user's projects, with all that can be done to them. */

import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import { UPLOADS } from "../../model/upload";
import type { ProjectEntry } from "../../protocol/messages";
import { day } from "../../ui/dates";
import { chooseFiles } from "../../ui/files";
import { Icon } from "../../ui/icons";
import { Menu, type MenuGroup } from "../../ui/menu";
import { projectPicture } from "./project-picture";

/** The number of projects beside the examples; the others are in the dialog with the search. */
const MOST = 5;

/** Opens files that the user has chosen. */
export type OpenFiles = (files: readonly File[]) => void;

export function Projects({ openFiles }: { openFiles: OpenFiles }) {
  const { dialogs, project } = usePage();
  const entries = project.entries.value ?? [];
  return (
    <section id="projects" class="start-projects" aria-labelledby="start-projects" data-region="projects" tabIndex={-1}>
      <div class="start-head">
        <h2 id="start-projects">{t("page-start-projects")}</h2>
        <button type="button" class="button bordered" onClick={() => chooseFiles(UPLOADS.join(","), openFiles)}>
          {t("page-start-import")}
        </button>
        <button type="button" class="button filled" onClick={() => dialogs.show("new")}>
          <Icon name="plus" />
          {t("page-start-new")}
        </button>
      </div>
      {project.entries.value?.length === 0 && <p class="dim start-none">{t("page-start-no-projects")}</p>}
      <ul class="start-list">
        {entries.slice(0, MOST).map((entry) => (
          <Project key={entry.name} entry={entry} />
        ))}
      </ul>
      {entries.length > MOST && (
        <button type="button" class="more-link start-all" onClick={() => dialogs.show("open")}>
          {t("page-start-all", { count: entries.length })}
          <Icon name="next" />
        </button>
      )}
    </section>
  );
}

function Project({ entry }: { entry: ProjectEntry }) {
  const page = usePage();
  const picture = projectPicture(entry);
  return (
    <li>
      <button type="button" class="start-project" onClick={() => page.project.open(entry.name)}>
        {picture ? <img src={picture} alt="" width={480} height={270} loading="lazy" /> : <span class="start-blank" />}
        <strong>{entry.name}</strong>
        <span class="dim">{day(entry.changed)}</span>
      </button>
      <Menu label={t("page-start-more", { name: entry.name })} icon="more" groups={groups(page, entry)} side="right" />
    </li>
  );
}

function groups({ dialogs, project }: Page, { name }: ProjectEntry): readonly MenuGroup[] {
  return [
    {
      items: [
        { text: t("page-start-open"), icon: "projects", run: () => project.open(name) },
        { text: t("page-project-rename"), icon: "rename", run: () => dialogs.show({ rename: name }) },
        { text: t("page-start-copy"), icon: "copy", run: () => dialogs.show({ copy: name }) },
        {
          text: t("page-project-download-learnblock"),
          icon: "download",
          run: () => project.export("learnblock", name),
        },
      ],
    },
    { items: [{ text: t("page-project-delete"), icon: "trash", run: () => dialogs.show({ delete: name }) }] },
  ];
}
