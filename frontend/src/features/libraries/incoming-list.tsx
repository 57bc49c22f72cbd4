/** The files to import: their contents, and new names for conflicting skills. */

import { useSignal } from "@preact/signals";
import { useId } from "preact/hooks";
import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { IconButton } from "../../ui/button";
import { Actions } from "../../ui/dialog";
import { chooseFiles } from "../../ui/files";
import { Icon } from "../../ui/icons";
import { PhraseList } from "../../ui/phrase-list";
import { clashOf, type Incoming, isReady, type Renaming, replaces } from "./incoming";
import { ENDINGS } from "./libraries";
import { described, titleOf } from "./summary";

export function IncomingLibraries() {
  const { libraries } = usePage();
  const replace = useSignal(false);
  const files = libraries.incoming.value;
  const older = files.filter(replaces);
  const ready = files.every(isReady) && (older.length === 0 || replace.value);
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    if (ready) libraries.import(replace.value);
  };
  return (
    <form onSubmit={submit}>
      <p class="dim">{t("page-libraries-nothing-runs")}</p>
      <ul class="rows">
        {files.map((one) => (
          <File key={one.filename} file={one} />
        ))}
      </ul>
      {older.length > 0 && (
        <label class="check">
          <input
            type="checkbox"
            checked={replace.value}
            onChange={({ currentTarget }) => (replace.value = currentTarget.checked)}
          />
          {t("page-libraries-replace", { names: older.map((one) => one.read?.library?.name ?? "").join(", ") })}
        </label>
      )}
      <Actions cancel={() => (libraries.incoming.value = [])}>
        <button
          type="button"
          class="button bordered"
          onClick={() => chooseFiles(ENDINGS.join(","), (more) => void libraries.take(more))}
        >
          {t("page-libraries-more")}
        </button>
        <button type="submit" class="button filled" disabled={!ready}>
          {t("page-libraries-import-now")}
        </button>
      </Actions>
    </form>
  );
}

function File({ file }: { file: Incoming }) {
  const { libraries } = usePage();
  const { filename, read, renamings, changed = [], missing = [] } = file;
  return (
    <li>
      <div class="row-main">
        <strong>{read?.library ? titleOf(read.library) : filename}</strong>
        {read?.library && <span class="dim">{described(read.library)}</span>}
        {read?.library?.description && <span class="dim">{read.library.description}</span>}
        {replaces(file) && <span>{t("page-libraries-installed", { version: read?.installed ?? "" })}</span>}
        {read?.problem && (
          <span class="library-problem" role="alert">
            <Icon name="error" /> {say(read.problem)}
          </span>
        )}
        <PhraseList title={t("page-project-imported-missing")} phrases={missing} />
        <PhraseList title={t("page-project-imported-changed")} phrases={changed} />
        {renamings.map((one) => (
          <NewName key={one.skill} file={file} renaming={one} />
        ))}
      </div>
      <IconButton
        icon="close"
        word="page-libraries-leave-out"
        values={{ name: filename }}
        onClick={() => libraries.leaveOut(filename)}
      />
    </li>
  );
}

function NewName({ file, renaming }: { file: Incoming; renaming: Renaming }) {
  const { libraries } = usePage();
  const reason = useId();
  const { skill, place, name } = renaming;
  const clash = clashOf(file, renaming);
  return (
    <span class="library-renaming">
      <span id={reason} class={clash ? "library-problem" : "dim"}>
        {t("page-libraries-clash", { skill: clash?.skill ?? skill, place: say(clash?.place ?? place) })}
      </span>
      <label class="field">
        {t("page-libraries-new-name", { skill })}
        <input
          aria-describedby={reason}
          aria-invalid={Boolean(clash)}
          maxLength={100}
          value={name}
          onInput={({ currentTarget }) => libraries.rename(file.filename, skill, currentTarget.value)}
        />
      </label>
    </span>
  );
}
