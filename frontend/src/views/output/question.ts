/** The input line for a program's question. */

import "./panel.css";
import "./question.css";

import { effect } from "@preact/signals";
import { t } from "../../i18n";
import type { Dialogue } from "../../model/dialogue";
import { LIMITS } from "../../protocol/messages";
import type { Island } from "../../ui/island";
import { element } from "./elements";

export interface Question extends Island {
  readonly open: boolean;
  focus(): void;
}

/** Longer answers are refused by the server. */
const LONGEST = `${LIMITS.Answer.text}`;

/** It is open while the program waits for an answer. */
export function createQuestion(dialogue: Dialogue): Question {
  const label = element("label", { class: "prompt" });
  const input = element("input", { type: "text", autocomplete: "off", maxlength: LONGEST });
  const send = element("button", { type: "submit", class: "tool" });
  const dom = element("form", { class: "question" }, label, send);
  let before: Element | null = null;
  // The panel may be hidden when the program asks, so focus the line once it is visible.
  const seen = new IntersectionObserver((entries) => {
    if (entries.at(-1)?.isIntersecting) focus();
  });
  seen.observe(dom);

  function focus(): void {
    if (!dom.contains(document.activeElement)) before = document.activeElement;
    input.focus();
  }

  function close(): void {
    const focused = dom.contains(document.activeElement);
    dom.hidden = true;
    if (focused && before instanceof HTMLElement) before.focus();
  }

  function ask(prompt: string): void {
    label.replaceChildren(element("span", {}, (prompt || t("page-console-asks")).trim()), input);
    send.textContent = t("page-console-answer");
    input.value = "";
    dom.hidden = false;
  }

  dom.hidden = true;
  dom.onsubmit = (event) => {
    event.preventDefault();
    dialogue.answer(input.value);
  };
  const stop = effect(() => {
    const prompt = dialogue.asked.value;
    if (prompt === null) close();
    else ask(prompt);
  });
  return {
    dom,
    focus,
    destroy: () => {
      seen.disconnect();
      stop();
      close();
    },
    get open() {
      return !dom.hidden;
    },
  };
}
