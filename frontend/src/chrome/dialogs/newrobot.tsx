/** The dialog in which a robot is made from its description. */

import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { said } from "../../sentences";
import { chooseFile } from "../files";
import { usePage } from "../page";
import { Actions, Dialog } from "../widgets/dialog";
import "./newrobot.css";

export function NewRobotDialog() {
  const { dialogs, robotMaker } = usePage();
  useEffect(() => robotMaker.begin(), []);
  return (
    <Dialog title={t("newrobot.title")} close={() => dialogs.close()} size="large">
      {robotMaker.made.value ? <Made /> : <Description />}
    </Dialog>
  );
}

function Description() {
  const { dialogs, robotMaker } = usePage();
  const text = useRef<HTMLTextAreaElement>(null);
  const make = (event: SubmitEvent) => {
    event.preventDefault();
    robotMaker.make();
  };
  return (
    <form onSubmit={make}>
      <p class="dim">{t("newrobot.help")}</p>
      <label class="field">
        {t("newrobot.name")}
        <input
          required
          maxLength={40}
          spellcheck={false}
          value={robotMaker.name.value}
          onInput={({ currentTarget }) => (robotMaker.name.value = currentTarget.value)}
        />
      </label>
      <label class="field">
        {t("newrobot.description")}
        <textarea
          ref={text}
          class="new-robot-text"
          required
          spellcheck={false}
          rows={16}
          value={robotMaker.description.value}
          onInput={({ currentTarget }) => (robotMaker.description.value = currentTarget.value)}
        />
      </label>
      <Problems text={text} />
      <Actions cancel={() => dialogs.close()}>
        <button type="button" class="button bordered" onClick={() => chooseFile(".toml", (file) => void robotMaker.readFile(file))}>
          {t("newrobot.file")}
        </button>
        <button type="submit" class="button filled">
          {t("newrobot.make")}
        </button>
      </Actions>
    </form>
  );
}

function Problems({ text }: { text: RefObject<HTMLTextAreaElement | null> }) {
  const { robotMaker } = usePage();
  return (
    <ul role="alert" class="new-robot-problems refused">
      {robotMaker.problems.value.map(({ message, line = 0 }) => (
        <li key={`${line} ${message}`}>
          {line > 0 && (
            <button type="button" class="button bordered" onClick={() => text.current && selectLine(text.current, line)}>
              {t("newrobot.line", { line })}
            </button>
          )}
          {said(message)}
        </li>
      ))}
    </ul>
  );
}

/** Select a line, from 1, and show it. */
function selectLine(text: HTMLTextAreaElement, line: number): void {
  const lines = text.value.split("\n");
  const start = lines.slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
  text.focus();
  text.setSelectionRange(start, start + (lines[line - 1]?.length ?? 0));
  text.scrollTop = (text.scrollHeight / lines.length) * Math.max(0, line - 4);
}

function Made() {
  const { controls, dialogs, robotMaker } = usePage();
  const { name = "", files = [] } = robotMaker.made.value ?? {};
  const use = () => {
    controls.chooseRobot(`sim-${name}`);
    dialogs.close();
  };
  const button = useRef<HTMLButtonElement>(null);
  // The button that had the focus has gone with the description.
  useEffect(() => button.current?.focus(), []);
  return (
    <>
      <p role="status">{t("newrobot.made", { name })}</p>
      <ul class="new-robot-files">
        {files.map((file) => (
          <li key={file}>
            <code>{file}</code>
          </li>
        ))}
      </ul>
      <p class="dim">{t("newrobot.next")}</p>
      <div class="actions">
        <button type="button" class="button bordered" onClick={() => dialogs.close()}>
          {t("chrome.close")}
        </button>
        <button type="button" class="button filled" ref={button} onClick={use}>
          {t("newrobot.use")}
        </button>
      </div>
    </>
  );
}
