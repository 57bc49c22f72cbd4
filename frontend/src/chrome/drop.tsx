import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { t } from "../i18n";
import { EXPORTED } from "./dialogs/ownblocks";
import { usePage, type Page } from "./page";

/** A file may be dropped anywhere on the page: it becomes a project, or a block of the user's own. */
export function DropPlace() {
  const page = usePage();
  const over = useSignal(false);
  useEffect(
    () =>
      catchFiles(
        (on) => (over.value = on),
        (file) => void take(page, file),
      ),
    [],
  );
  return over.value ? <div class="drop-place">{t("project.drop")}</div> : null;
}

function take({ dialogs, project, shelf }: Page, file: File): Promise<void> {
  if (!file.name.endsWith(EXPORTED)) return project.import(file);
  dialogs.show("ownBlocks");
  return shelf.import(file);
}

/** Listen before the editors do: they would insert the file's text. */
function catchFiles(show: (over: boolean) => void, take: (file: File) => void): () => void {
  const listeners = {
    dragover: (event: DragEvent) => claim(event) && show(true),
    // Without a part of the page that it enters instead, the pointer has left the window.
    dragleave: (event: DragEvent) => event.relatedTarget === null && show(false),
    drop: (event: DragEvent) => {
      show(false);
      const file = event.dataTransfer?.files[0];
      if (claim(event) && file) take(file);
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
