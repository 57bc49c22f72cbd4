/** The dialog for making a robot from its description. */

import type { RefObject } from "preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { Actions, Dialog } from "../../ui/dialog";
import { chooseFile } from "../../ui/files";
import "./dialog.css";

export function NewRobotDialog() {
  const { dialogs, robotMaker } = usePage();
  useEffect(() => robotMaker.begin(), []);
  return (
    <Dialog title={t("page-newrobot-title")} close={() => dialogs.close()} size="large">
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
      <p class="dim">{t("page-newrobot-help")}</p>
      <label class="field">
        {t("page-newrobot-name")}
        <input
          required
          maxLength={40}
          spellcheck={false}
          value={robotMaker.name.value}
          onInput={({ currentTarget }) => (robotMaker.name.value = currentTarget.value)}
        />
      </label>
      <label class="field">
        {t("page-newrobot-description")}
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
        <button
          type="button"
          class="button bordered"
          onClick={() => chooseFile(".toml", (file) => void robotMaker.readFile(file))}
        >
          {t("page-newrobot-file")}
        </button>
        <button type="submit" class="button filled">
          {t("page-newrobot-make")}
        </button>
      </Actions>
    </form>
  );
}

function Problems({ text }: { text: RefObject<HTMLTextAreaElement | null> }) {
  const { robotMaker } = usePage();
  return (
    <div role="alert" class="refused">
      <ul class="new-robot-problems">
        {robotMaker.problems.value.map(({ message, line = 0 }) => (
          <li key={`${line} ${say(message)}`}>
            {line > 0 && (
              <button
                type="button"
                class="button bordered"
                onClick={() => text.current && selectLine(text.current, line)}
              >
                {t("page-newrobot-line", { line })}
              </button>
            )}
            {say(message)}
          </li>
        ))}
      </ul>
    </div>
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
  // The focused button disappeared with the description.
  useLayoutEffect(() => button.current?.focus(), []);
  return (
    <>
      <p role="status">{t("page-newrobot-made", { name })}</p>
      <ul class="new-robot-files">
        {files.map((file) => (
          <li key={file}>
            <code>{file}</code>
          </li>
        ))}
      </ul>
      <p class="dim">{t("page-newrobot-next")}</p>
      <div class="actions">
        <button type="button" class="button bordered" onClick={() => dialogs.close()}>
          {t("page-shell-close")}
        </button>
        <button type="button" class="button filled" ref={button} onClick={use}>
          {t("page-newrobot-use")}
        </button>
      </div>
    </>
  );
}
