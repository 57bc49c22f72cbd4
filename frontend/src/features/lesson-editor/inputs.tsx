/** The inputs of the lesson editor: texts in several languages, and the choice of one of them. */

import { languages, say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { FormField } from "../../ui/form/field";
import type { Form, Path } from "../../ui/form/form";
import { languageName } from "../../ui/language-name";
import type { Texts } from "../lessons/lesson-edit";
import { inLanguage } from "../lessons/lessons";
import type { LessonMaking } from "../lessons/making";

const LONGEST = 200;
/** The lines of a long text, and of a program. */
const LONG = 9;
const PROGRAM = 8;

/** The server judges all values of a lesson together. */
export function formOf(making: LessonMaking): Form {
  return { problems: (path) => making.problemsAt(path).map(({ message }) => say(message)) };
}

interface Props {
  /** The code of the label. */
  readonly word: string;
  readonly path: Path;
  readonly text: Texts | undefined;
  readonly take: (text: Texts) => void;
  readonly isLong?: boolean;
  readonly longest?: number;
}

/** A text in the language in which the teacher writes; that of another language shows what is missing. */
export function Translated({ word, path, text = {}, take, isLong = false, longest = LONGEST }: Props) {
  const code = usePage().lessonMaking.writing.value;
  const other = text[code] ? "" : inLanguage(text);
  return (
    <FormField
      label={t(word)}
      path={path}
      shape={{ kind: "text", longest, ...(isLong && { rows: LONG }) }}
      value={text[code] ?? ""}
      take={(written) => take({ ...text, [code]: written ?? "" })}
      lang={code}
      placeholder={other ? t("page-maker-fallback", { text: other.slice(0, 80) }) : ""}
    />
  );
}

interface ProgramProps {
  readonly word: string;
  readonly path: Path;
  readonly text: string;
  readonly take: (text: string) => void;
  readonly rows?: number;
  readonly help?: string;
}

/** A program, or lines of one. */
export function ProgramText({ word, path, text, take, rows = PROGRAM, help }: ProgramProps) {
  return (
    <FormField
      label={t(word)}
      path={path}
      help={help}
      shape={{ kind: "text", rows, isCode: true }}
      value={text}
      take={(written) => take(written ?? "")}
    />
  );
}

/** The choice of the language in which the teacher writes. */
export function Languages() {
  const { writing } = usePage().lessonMaking;
  return (
    <div class="maker-languages" role="group" aria-label={t("page-maker-languages")}>
      {languages.map((code) => (
        <button
          key={code}
          type="button"
          class="button bordered"
          aria-pressed={writing.value === code}
          onClick={() => (writing.value = code)}
        >
          {languageName(code)}
        </button>
      ))}
    </div>
  );
}
