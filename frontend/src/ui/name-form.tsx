import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useId, useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../i18n";
import { Actions } from "./dialog";

interface NameFormProps {
  /** The name to begin with. */
  readonly name: string;
  readonly help: string;
  /** The word on the button that takes the name. */
  readonly action: string;
  /** Says why a name is not possible; empty if it is. The dialog then stays open, with the reason. */
  readonly fault?: (name: string) => string;
  /** The limit of its characters. */
  readonly longest: number;
  /** Closes the dialog around the form. */
  readonly close: () => void;
  readonly run: (name: string) => void;
  /** What else is asked, below the name. */
  readonly children?: ComponentChildren;
}

/** Asks for a name in a dialog, closes it, and passes the name on. */
export function NameForm({ name: first, help, action, fault, longest, close, run, children }: NameFormProps) {
  const name = useSignal(first);
  const input = useRef<HTMLInputElement>(null);
  const about = useId();
  const wrong = name.value.trim() && fault?.(name.value.trim());
  // The names that are taken may be known only after the name was typed.
  useLayoutEffect(() => input.current?.setCustomValidity(wrong || ""), [wrong]);
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    close();
    run(name.value.trim());
  };
  return (
    <form onSubmit={submit}>
      <label class="field">
        {t("page-project-name")}
        <input
          ref={input}
          required
          aria-describedby={about}
          autofocus
          pattern=".*\S.*"
          maxLength={longest}
          value={name.value}
          onFocus={({ currentTarget }) => currentTarget.select()}
          onInput={({ currentTarget }) => (name.value = currentTarget.value)}
        />
      </label>
      <p id={about} role="status" class={wrong ? "refused" : "dim"}>
        {wrong || help}
      </p>
      {children}
      <Actions cancel={close}>
        <button type="submit" class="button filled">
          {action}
        </button>
      </Actions>
    </form>
  );
}
