import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { type CustomBlocks, useCustomBlocks } from "../features/custom-blocks/custom-blocks";
import { EXPORTED } from "../features/custom-blocks/dialogs";
import { ENDING, type Libraries, useLibraries } from "../features/libraries/libraries";
import { useWorlds, WORLD_FILES, type Worlds } from "../features/worlds/worlds";
import { t } from "../i18n";
import { type Page, usePage } from "../model/page";

/** Accepts files dropped anywhere on the page: a project, a world, a custom block, or libraries. */
export function DropPlace() {
  const page = usePage();
  const libraries = useLibraries();
  const customBlocks = useCustomBlocks();
  const worlds = useWorlds();
  const over = useSignal(false);
  useEffect(
    () =>
      catchFiles(
        (on) => (over.value = on),
        (files) => void take({ ...page, libraries, customBlocks, worlds }, files),
      ),
    [],
  );
  return over.value ? <div class="drop-place">{t("page-project-drop")}</div> : null;
}

interface Takers extends Page {
  readonly libraries: Libraries;
  readonly customBlocks: CustomBlocks;
  readonly worlds: Worlds;
}

async function take(
  { customBlocks, dialogs, libraries, project, worlds }: Takers,
  files: readonly File[],
): Promise<void> {
  const packed = files.filter((one) => one.name.endsWith(ENDING));
  if (packed.length) {
    dialogs.show("libraries");
    return libraries.take(packed);
  }
  const [file] = files;
  if (!file) return;
  if (WORLD_FILES.some((ending) => file.name.endsWith(ending))) return worlds.import(file);
  if (!file.name.endsWith(EXPORTED)) return project.import(file);
  dialogs.show("customBlocks");
  return customBlocks.import(file);
}

/** Listen before the editors, which would insert the file's text. */
function catchFiles(show: (over: boolean) => void, take: (files: readonly File[]) => void): () => void {
  const listeners = {
    dragover: (event: DragEvent) => claim(event) && show(true),
    // The pointer has left the window if it enters no other element.
    dragleave: (event: DragEvent) => event.relatedTarget === null && show(false),
    drop: (event: DragEvent) => {
      show(false);
      const files = [...(event.dataTransfer?.files ?? [])];
      if (claim(event)) take(files);
    },
  };
  const entries = Object.entries(listeners) as [string, EventListener][];
  for (const [name, listener] of entries) addEventListener(name, listener, { capture: true });
  return () => {
    for (const [name, listener] of entries) removeEventListener(name, listener, { capture: true });
  };
}

function claim(event: DragEvent): boolean {
  if (!event.dataTransfer?.types.includes("Files")) return false;
  event.preventDefault();
  event.stopPropagation();
  return true;
}
