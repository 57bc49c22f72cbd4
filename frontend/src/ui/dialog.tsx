/** A modal dialog of the browser, which traps the focus and returns it. */

import type { ComponentChildren } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../i18n";
import { IconButton } from "./button";
import { followTyping } from "./typing";
import "./dialog.css";

interface Props {
  readonly title: string;
  readonly close: () => void;
  /** What Escape does instead. */
  readonly cancel?: () => void;
  readonly size?: "small" | "large" | "worlds" | "whole";
  /** Beside the title. */
  readonly head?: ComponentChildren;
  readonly children: ComponentChildren;
}

export function Dialog({ title, close, cancel = close, size = "small", head, children }: Props) {
  const dialog = useRef<HTMLDialogElement>(null);
  useLayoutEffect(() => (dialog.current ? opened(dialog.current, close, cancel) : undefined), []);
  return (
    // biome-ignore lint/a11y/useKeyWithClickEvents: a click beside the dialog closes it, like Escape
    <dialog
      ref={dialog}
      class={`dialog ${size}`}
      aria-labelledby="dialog-title"
      onClick={({ target }) => target === dialog.current && close()}
    >
      <div class="dialog-inside">
        <div class="dialog-head">
          <h2 id="dialog-title">{title}</h2>
          {head}
          <IconButton icon="close" word="page-shell-close" onClick={close} />
        </div>
        {children}
      </div>
    </dialog>
  );
}

function opened(dialog: HTMLDialogElement, close: () => void, cancel: () => void): () => void {
  const release = hold(dialog, close, cancel);
  const stop = followTyping(dialog);
  return () => {
    stop();
    release();
  };
}

/** Show it; call the result to close it and return the focus. */
export function hold(dialog: HTMLDialogElement, close: () => void, cancel: () => void = close): () => void {
  const cancelled = (event: Event) => {
    // The browser reports that it has closed the dialog only in the next frame.
    event.preventDefault();
    cancel();
  };
  dialog.showModal();
  dialog.addEventListener("cancel", cancelled);
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

/** The buttons at the end of a dialog; the confirming one comes last. */
export function Actions({ cancel, children }: ActionsProps) {
  return (
    <div class="actions">
      <button type="button" class="button bordered" onClick={cancel}>
        {t("page-shell-cancel")}
      </button>
      {children}
    </div>
  );
}
