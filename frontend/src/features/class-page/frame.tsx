/** What all pages of a class have around them: the logo, the title, the language. */

import type { ComponentChildren } from "preact";

import { language, languages, type Phrase, say, t } from "../../i18n";
import { prefer } from "../../model/preferences";
import { languageName } from "../../ui/language-name";
import { Logo } from "../start/logo";

interface Props {
  readonly title?: string;
  /** Beside the title. */
  readonly tools?: ComponentChildren;
  readonly children?: ComponentChildren;
}

export function Frame({ title = "LearnBlock", tools, children }: Props) {
  return (
    <div class="class-page">
      <header class="class-bar">
        <Logo />
        <h1>{title}</h1>
        {tools}
        <LanguageChoice />
      </header>
      <main>{children}</main>
    </div>
  );
}

export function LanguageChoice() {
  return (
    <label class="class-language">
      <span class="hidden">{t("page-bar-language")}</span>
      <select value={language.value} onChange={({ currentTarget }) => prefer({ language: currentTarget.value })}>
        {languages.map((code) => (
          <option key={code} value={code}>
            {languageName(code)}
          </option>
        ))}
      </select>
    </label>
  );
}

/** Says that the connection is lost, or why the server has refused something. */
export function Problem({ isLost, problem }: { isLost: boolean; problem: Phrase | null | undefined }) {
  return (
    <p role="alert" class={isLost || problem ? "class-problem" : "hidden"}>
      {isLost ? t("page-class-lost") : problem && say(problem)}
    </p>
  );
}
