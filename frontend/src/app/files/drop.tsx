import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { t } from "../../i18n";
import { useOpening } from "./opening";

/** Accepts files dropped anywhere on the page. */
export function DropPlace() {
  const open = useOpening();
  const over = useSignal(false);
  useEffect(() => catchFiles((on) => (over.value = on), open), []);
  return over.value ? <div class="drop-place">{t("page-project-drop")}</div> : null;
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
