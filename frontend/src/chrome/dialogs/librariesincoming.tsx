/** Files that are about to be imported: what is in them, and new names where two have the same. */

import { useSignal } from "@preact/signals";
import { useId } from "preact/hooks";

import { t } from "../../i18n";
import { clashOf, isReady, replaces, type Incoming, type Renaming } from "../../libraries/incoming";
import { ENDING } from "../../libraries/shelf";
import { said } from "../../sentences";
import { chooseFiles } from "../files";
import { usePage } from "../page";
import { IconButton } from "../widgets/button";
import { Actions } from "../widgets/dialog";
import { Icon } from "../widgets/icons";
import { described, titleOf } from "./libraries";

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
      <p class="dim">{t("libraries.nothingRuns")}</p>
      <ul class="rows">
        {files.map((one) => (
          <File key={one.filename} file={one} />
        ))}
      </ul>
      {older.length > 0 && (
        <label class="check">
          <input type="checkbox" checked={replace.value} onChange={({ currentTarget }) => (replace.value = currentTarget.checked)} />
          {t("libraries.replace", { names: older.map((one) => one.read?.library?.name ?? "").join(", ") })}
        </label>
      )}
      <Actions cancel={() => (libraries.incoming.value = [])}>
        <button type="button" class="button bordered" onClick={() => chooseFiles(ENDING, (more) => void libraries.take(more))}>
          {t("libraries.more")}
        </button>
        <button type="submit" class="button filled" disabled={!ready}>
          {t("libraries.importNow")}
        </button>
      </Actions>
    </form>
  );
}

function File({ file }: { file: Incoming }) {
  const { libraries } = usePage();
  const { filename, read, renamings } = file;
  return (
    <li>
      <div class="row-main">
        <strong>{read?.library ? titleOf(read.library) : filename}</strong>
        {read?.library && <span class="dim">{described(read.library)}</span>}
        {read?.library?.description && <span class="dim">{read.library.description}</span>}
        {replaces(file) && <span>{t("libraries.installed", { version: read?.installed ?? "" })}</span>}
        {read?.problem && (
          <span class="library-problem" role="alert">
            <Icon name="error" /> {said(read.problem)}
          </span>
        )}
        {renamings.map((one) => (
          <NewName key={one.skill} file={file} renaming={one} />
        ))}
      </div>
      <IconButton icon="close" word="libraries.leaveOut" values={{ name: filename }} onClick={() => libraries.leaveOut(filename)} />
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
        {t("libraries.clash", { skill: clash?.skill ?? skill, place: said(clash?.place ?? place) })}
      </span>
      <label class="field">
        {t("libraries.newName", { skill })}
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
