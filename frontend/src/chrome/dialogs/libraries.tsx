/** The dialog about libraries: those that are installed, files to import, and a library of one's own. */

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { language, t } from "../../i18n";
import { ENDING } from "../../libraries/shelf";
import type { InstalledLibrary } from "../../messages";
import { said } from "../../sentences";
import { chooseFiles } from "../files";
import { usePage } from "../page";
import { IconButton } from "../widgets/button";
import { Dialog } from "../widgets/dialog";
import { Icon } from "../widgets/icons";
import { IncomingLibraries } from "./librariesincoming";
import { LibraryForm } from "./libraryform";
import "./libraries.css";

export function LibrariesDialog() {
  const { dialogs, libraries } = usePage();
  const making = useSignal(false);
  useEffect(() => libraries.list(), []);
  const close = () => {
    libraries.incoming.value = [];
    dialogs.close();
  };
  return (
    <Dialog title={t("libraries.title")} close={close} size="large">
      <OutcomeLine />
      {making.value ? (
        <LibraryForm done={() => (making.value = false)} />
      ) : libraries.incoming.value.length ? (
        <IncomingLibraries />
      ) : (
        <Installed make={() => (making.value = true)} />
      )}
    </Dialog>
  );
}

function OutcomeLine() {
  const outcome = usePage().libraries.outcome.value;
  return (
    <p class={`library-outcome ${outcome?.sort ?? ""}`} role={outcome?.sort === "failed" ? "alert" : "status"}>
      {outcome && said(outcome.text)}
    </p>
  );
}

function Installed({ make }: { make: () => void }) {
  const { libraries } = usePage();
  const found = libraries.installed.value;
  return (
    <>
      <p class="dim">{t("libraries.help")}</p>
      <div class="library-tools">
        <button type="button" class="button filled" onClick={() => chooseFiles(ENDING, (files) => void libraries.take(files))}>
          {t("libraries.import")}
        </button>
        <button type="button" class="button bordered" onClick={make}>
          {t("libraries.make")}
        </button>
      </div>
      {found?.length === 0 && <p role="status">{t("libraries.none")}</p>}
      <ul class="rows">
        {found?.map((one) => (
          <Row key={one.name} library={one} />
        ))}
      </ul>
    </>
  );
}

function Row({ library }: { library: InstalledLibrary }) {
  const { libraries } = usePage();
  const asked = useSignal(false);
  const { name, problem } = library;
  if (asked.value) return <Removal name={name} keep={() => (asked.value = false)} />;
  return (
    <li>
      <div class="row-main">
        <strong>{titleOf(library)}</strong>
        <span class="dim">{described(library)}</span>
        {problem && (
          <span class="library-problem">
            <Icon name="error" /> {said(problem)}
          </span>
        )}
      </div>
      {!problem && (
        <>
          <button type="button" class="button bordered" aria-label={t("libraries.useOne", { name })} onClick={() => libraries.use(name)}>
            {t("libraries.use")}
          </button>
          <IconButton icon="download" word="libraries.download" values={{ name }} onClick={() => libraries.download(name)} />
        </>
      )}
      <IconButton icon="trash" word="libraries.remove" values={{ name }} onClick={() => (asked.value = true)} />
    </li>
  );
}

function Removal({ name, keep }: { name: string; keep: () => void }) {
  const { libraries } = usePage();
  const button = useRef<HTMLButtonElement>(null);
  // The button that had the focus has gone.
  useEffect(() => button.current?.focus(), []);
  return (
    <li>
      <div class="row-main" role="alert">
        {t("libraries.reallyRemove", { name })}
      </div>
      <button type="button" class="button bordered" ref={button} onClick={keep}>
        {t("libraries.keep")}
      </button>
      <button type="button" class="button filled" onClick={() => libraries.remove(name)}>
        {t("libraries.removeNow")}
      </button>
    </li>
  );
}

/** The library's title in the user's language, or else its name. */
export function titleOf({ name, title = {} }: InstalledLibrary): string {
  return title[language.value] ?? title.en ?? name;
}

/** What a program imports, the version, and the skills. */
export function described({ name, version = "", skills = [] }: InstalledLibrary): string {
  return [`import "${name}"`, version, skills.join(", ")].filter(Boolean).join(" · ");
}
