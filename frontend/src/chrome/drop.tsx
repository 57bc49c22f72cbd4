import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { t } from "../i18n";
import { ENDING } from "../libraries/shelf";
import { EXPORTED } from "./dialogs/ownblocks";
import { usePage, type Page } from "./page";

/** A file may be dropped anywhere on the page: a project, a block of the user's own, or libraries. */
export function DropPlace() {
  const page = usePage();
  const over = useSignal(false);
  useEffect(
    () =>
      catchFiles(
        (on) => (over.value = on),
        (files) => void take(page, files),
      ),
    [],
  );
  return over.value ? <div class="drop-place">{t("project.drop")}</div> : null;
}

async function take({ dialogs, libraries, project, shelf }: Page, files: readonly File[]): Promise<void> {
  const packed = files.filter((one) => one.name.endsWith(ENDING));
  if (packed.length) {
    dialogs.show("libraries");
    return libraries.take(packed);
  }
  const [file] = files;
  if (!file) return;
  if (!file.name.endsWith(EXPORTED)) return project.import(file);
  dialogs.show("ownBlocks");
  return shelf.import(file);
}

/** Listen before the editors do: they would insert the file's text. */
function catchFiles(show: (over: boolean) => void, take: (files: readonly File[]) => void): () => void {
  const listeners = {
    dragover: (event: DragEvent) => claim(event) && show(true),
    // Without a part of the page that it enters instead, the pointer has left the window.
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
