/** Opening the files that a user has chosen or dropped. */

import { EXPORTED } from "../../features/custom-blocks/dialogs";
import { lessonFolderOf } from "../../features/lessons/folder";
import { LESSON_FILE } from "../../features/lessons/lesson-file";
import { WORLD_FILES } from "../../features/worlds/worlds";
import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import { uploadOf, withEnding } from "../../model/upload";

/** Opens a project, a lesson, a world, a custom block, or libraries. */
export function useOpening(): (files: readonly File[]) => void {
  const page = usePage();
  return (files) => void open(page, files);
}

async function open(page: Page, files: readonly File[]): Promise<void> {
  const { dialogs, lessons, libraries, project, toasts } = page;
  const folder = lessonFolderOf(files);
  if (folder) return lessons.importFolder(folder);
  const found = uploadOf(files);
  switch (found.kind) {
    case "program":
      return project.import(found.file, found.libraries);
    case "libraries":
      dialogs.show("libraries");
      return libraries.take(found.files);
    case "several":
      return toasts.error(t("page-project-several-programs", { count: found.count }));
    case "unknown":
      return files[0] && openOther(page, files[0]);
  }
}

async function openOther({ customBlocks, dialogs, lessons, toasts, worlds }: Page, file: File): Promise<void> {
  if (withEnding([file], [LESSON_FILE]).length) return lessons.import(file);
  if (withEnding([file], WORLD_FILES).length) return worlds.import(file);
  if (!file.name.endsWith(EXPORTED)) return toasts.error(t("page-project-wrong-file", { name: file.name }));
  dialogs.show("customBlocks");
  return customBlocks.import(file);
}
