/** A lesson on paper, in black and white. */

import { type ComponentChildren, render } from "preact";
import { Markdown } from "../../features/lessons/markdown";
import type { WorksheetContent, WorksheetQuiz, WorksheetStep } from "../../features/standalone/content";
import { t } from "../../i18n";
import type { Workspace } from "../../protocol/messages";
import { svgAddress } from "../../ui/picture-file";
import { inBlackAndWhite } from "../../views/blocks/black-and-white";
import { givePalette, prepareBlockly } from "../../views/blocks/palette";
import { drawProgram } from "../../views/blocks/program-picture";
import "../../features/lessons/lessons.css";
import "./worksheet.css";

/** Of the size on the page: blocks to cut out must fit fingers, those of the solutions the page. */
const SCALE = { cut: 0.75, shown: 0.6 };
/** Lines to write on where there is no program. */
const NOTES = 3;

type Drawings = ReadonlyMap<Workspace, ComponentChildren>;

/** Draw all blocks, and show the sheet. */
export async function showWorksheet(content: WorksheetContent, root: HTMLElement): Promise<void> {
  givePalette(content.palette);
  prepareBlockly();
  document.title = content.title;
  // Paper is light.
  document.documentElement.dataset.theme = "light";
  const drawings = new Map<Workspace, ComponentChildren>();
  for (const { text, pieces, solution } of content.steps) {
    for (const { workspace } of [...text, ...(solution ? [solution] : [])]) {
      if (workspace) drawings.set(workspace, await drawn(workspace, content.language, SCALE.shown));
    }
    for (const piece of pieces) drawings.set(piece, await drawn(piece, content.language, SCALE.cut));
  }
  render(<Worksheet content={content} drawings={drawings} />, root);
}

async function drawn(workspace: Workspace, language: string, scale: number): Promise<ComponentChildren> {
  const picture = await drawProgram(workspace, { language, theme: "light", text: "", only: null });
  const { svg, width } = picture;
  inBlackAndWhite(svg);
  return <img src={svgAddress(svg)} width={width * scale} alt="" />;
}

function Worksheet({ content, drawings }: { content: WorksheetContent; drawings: Drawings }) {
  const { title, pictures, steps } = content;
  const solved = steps.map((step, index) => ({ step, number: index + 1 })).filter(({ step }) => hasAnswer(step));
  return (
    <main class="worksheet">
      <header>
        <h1>{title}</h1>
        <p>{t("page-worksheet-name")}</p>
      </header>
      {steps.map((step, index) => (
        <Task key={index} step={step} number={index + 1} drawings={drawings} pictures={pictures} />
      ))}
      {solved.length > 0 && (
        <section class="worksheet-solutions">
          <h1>{t("page-worksheet-solutions", { title })}</h1>
          {solved.map(({ step, number }) => (
            <Solution key={number} step={step} number={number} drawings={drawings} />
          ))}
        </section>
      )}
    </main>
  );
}

function hasAnswer({ quiz, solution }: WorksheetStep): boolean {
  return quiz !== null || solution !== null;
}

interface StepProps {
  readonly step: WorksheetStep;
  readonly number: number;
  readonly drawings: Drawings;
}

interface TaskProps extends StepProps {
  readonly pictures: WorksheetContent["pictures"];
}

function Task({ step, number, drawings, pictures }: TaskProps) {
  const { title, text, goals, quiz, pieces, solution } = step;
  const lines = solution ? solution.text.trimEnd().split("\n").length : NOTES;
  return (
    <section>
      <h2>{t("page-worksheet-step", { number, title })}</h2>
      {text.map(({ text: words, workspace }, index) => (
        <div key={index}>
          {workspace ? drawings.get(workspace) : <Markdown text={words} lesson="" drawings={{}} pictures={pictures} />}
        </div>
      ))}
      {goals.length > 0 && (
        <>
          <p>{t("page-worksheet-goals")}</p>
          <ul>
            {goals.map((goal) => (
              <li key={goal}>{goal}</li>
            ))}
          </ul>
        </>
      )}
      {quiz && <Question quiz={quiz} />}
      {pieces.length > 0 && (
        <>
          <p>{t("page-worksheet-cut")}</p>
          <div class="worksheet-pieces">
            {pieces.map((piece, index) => (
              <div key={index}>{drawings.get(piece)}</div>
            ))}
          </div>
        </>
      )}
      {!quiz && (
        <>
          <p>{t(solution ? "page-worksheet-write" : "page-worksheet-notes")}</p>
          <ol class={solution ? "worksheet-lines" : "worksheet-lines plain"}>
            {Array.from({ length: lines }, (_, line) => (
              <li key={line} />
            ))}
          </ol>
        </>
      )}
    </section>
  );
}

function Question({ quiz: { question, choices } }: { quiz: WorksheetQuiz }) {
  return (
    <>
      <p>{question}</p>
      <ul class="worksheet-choices">
        {choices.map(({ text }) => (
          <li key={text}>{text}</li>
        ))}
      </ul>
    </>
  );
}

function Solution({ step: { title, quiz, solution }, number, drawings }: StepProps) {
  return (
    <section>
      <h2>{t("page-worksheet-step", { number, title })}</h2>
      {quiz && (
        <p>
          {t("page-worksheet-answer")}{" "}
          {quiz.choices
            .filter(({ right }) => right)
            .map(({ text }) => text)
            .join("; ")}
        </p>
      )}
      {solution && (
        <div class="worksheet-solution">
          <div>{drawings.get(solution.workspace)}</div>
          <ol>
            {solution.text
              .trimEnd()
              .split("\n")
              .map((line, index) => (
                <li key={index}>{line || " "}</li>
              ))}
          </ol>
        </div>
      )}
    </section>
  );
}
