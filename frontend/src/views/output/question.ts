/** The input line for a program's question. */

import { t } from "../../i18n";
import { LIMITS } from "../../protocol/messages";
import { element } from "./elements";

export interface Question {
  readonly dom: HTMLElement;
  readonly open: boolean;
  readonly prompt: string;
  ask(prompt: string): void;
  close(): void;
  focus(): void;
  destroy(): void;
}

/** Longer answers are refused by the server. */
const LONGEST = `${LIMITS.Answer.text}`;

/** `answer` receives the line when Enter is pressed. */
export function createQuestion(answer: (text: string) => void): Question {
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
    label.replaceChildren(element("span", {}, prompt.trim()), input);
    send.textContent = t("page-console-answer");
    input.value = "";
    dom.hidden = false;
  }

  dom.hidden = true;
  dom.onsubmit = (event) => {
    event.preventDefault();
    answer(input.value);
    close();
  };
  return {
    dom,
    ask,
    close,
    focus,
    destroy: () => seen.disconnect(),
    get open() {
      return !dom.hidden;
    },
    get prompt() {
      return label.firstChild?.textContent ?? "";
    },
  };
}
