/** Parts of the page whose code is loaded when they are first shown. */

import { useSignal } from "@preact/signals";
import type { FunctionComponent } from "preact";
import { useEffect } from "preact/hooks";

import { t } from "../i18n";

/** A component that shows nothing until its code is there, and says so if it can't be loaded. */
export function loadedLater<Props extends object>(
  load: () => Promise<FunctionComponent<Props>>,
): FunctionComponent<Props> {
  // What is loaded stays, so that the next one is there at once.
  let ready: { readonly Part: FunctionComponent<Props> } | null = null;
  return function LoadedLater(props: Props) {
    const loaded = useSignal(ready);
    const failed = useSignal(false);
    useEffect(() => {
      if (ready) return;
      load().then(
        (Part) => {
          ready = loaded.value = { Part };
        },
        (reason: unknown) => {
          failed.value = true;
          console.error(reason);
        },
      );
    }, []);
    if (failed.value) return <PartFailed />;
    const Part = loaded.value?.Part;
    return Part ? <Part {...props} /> : null;
  };
}

/** Shown in place of a part of the page that can't be loaded, for example because its server is gone. */
export function PartFailed() {
  return (
    <p class="island-failed" role="alert">
      {t("page-shell-part-failed")}
    </p>
  );
}
