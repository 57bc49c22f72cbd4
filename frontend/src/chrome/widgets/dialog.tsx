/** A modal dialog: the browser's own, which keeps the focus in it and gives it back. */

import type { ComponentChildren } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { IconButton } from "./button";
import "./dialog.css";

interface Props {
  readonly title: string;
  readonly close: () => void;
  readonly size?: "small" | "large" | "whole";
  readonly children: ComponentChildren;
}

export function Dialog({ title, close, size = "small", children }: Props) {
  const dialog = useRef<HTMLDialogElement>(null);
  useLayoutEffect(() => (dialog.current ? hold(dialog.current, close) : undefined), []);
  return (
    <dialog
      ref={dialog}
      class={`dialog ${size}`}
      aria-labelledby="dialog-title"
      onClick={({ target }) => target === dialog.current && close()}
    >
      <div class="dialog-inside">
        <header>
          <h2 id="dialog-title">{title}</h2>
          <IconButton icon="close" word="chrome.close" onClick={close} />
        </header>
        {children}
      </div>
    </dialog>
  );
}

/** Show it until what is returned is called; that gives the focus back to where it was. */
export function hold(dialog: HTMLDialogElement, close: () => void): () => void {
  const cancel = (event: Event) => {
    // The browser would tell only with its next frame that it has closed it.
    event.preventDefault();
    close();
  };
  dialog.showModal();
  dialog.addEventListener("cancel", cancel);
  // Some browsers do not let a page prevent the second Escape.
  dialog.addEventListener("close", close);
  return () => {
    dialog.removeEventListener("close", close);
    dialog.close();
  };
}

interface ActionsProps {
  readonly cancel: () => void;
  readonly children: ComponentChildren;
}

/** The buttons at a dialog's end; the one that does it comes last. */
export function Actions({ cancel, children }: ActionsProps) {
  return (
    <div class="actions">
      <button type="button" class="button bordered" onClick={cancel}>
        {t("chrome.cancel")}
      </button>
      {children}
    </div>
  );
}
