/** The libraries dialog: the installed ones, files to import, and making a new one. */

import { useSignal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import type { InstalledLibrary } from "../../protocol/messages";
import { IconButton } from "../../ui/button";
import { Dialog } from "../../ui/dialog";
import { chooseFiles } from "../../ui/files";
import { Icon } from "../../ui/icons";
import { LibraryForm } from "./form";
import { IncomingLibraries } from "./incoming-list";
import { ENDINGS } from "./libraries";
import { described, titleOf } from "./summary";
import "./libraries.css";

export function LibrariesDialog() {
  const { dialogs, libraries } = usePage();
  const making = useSignal(false);
  useEffect(() => libraries.list(), []);
  const close = () => {
    libraries.leave();
    dialogs.close();
  };
  return (
    <Dialog title={t("page-libraries-title")} close={close} size="large">
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
      {outcome && say(outcome.text)}
    </p>
  );
}

function Installed({ make }: { make: () => void }) {
  const { libraries } = usePage();
  const found = libraries.installed.value;
  return (
    <>
      <p class="dim">{t("page-libraries-help")}</p>
      <div class="library-tools">
        <button
          type="button"
          class="button filled"
          onClick={() => chooseFiles(ENDINGS.join(","), (files) => void libraries.take(files))}
        >
          {t("page-libraries-import")}
        </button>
        <button type="button" class="button bordered" onClick={make}>
          {t("page-libraries-make")}
        </button>
      </div>
      {found?.length === 0 && <p role="status">{t("page-libraries-none")}</p>}
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
            <Icon name="error" /> {say(problem)}
          </span>
        )}
      </div>
      {!problem && (
        <>
          <button
            type="button"
            class="button bordered"
            aria-label={t("page-libraries-use-one", { name })}
            onClick={() => libraries.use(name)}
          >
            {t("page-libraries-use")}
          </button>
          <IconButton
            icon="download"
            word="page-libraries-download"
            values={{ name }}
            onClick={() => libraries.download(name)}
          />
        </>
      )}
      <IconButton icon="trash" word="page-libraries-remove" values={{ name }} onClick={() => (asked.value = true)} />
    </li>
  );
}

function Removal({ name, keep }: { name: string; keep: () => void }) {
  const { libraries } = usePage();
  const button = useRef<HTMLButtonElement>(null);
  // The focused button has disappeared.
  useLayoutEffect(() => button.current?.focus(), []);
  return (
    <li>
      <div class="row-main" role="alert">
        {t("page-libraries-really-remove", { name })}
      </div>
      <button type="button" class="button bordered" ref={button} onClick={keep}>
        {t("page-libraries-keep")}
      </button>
      <button type="button" class="button filled" onClick={() => libraries.remove(name)}>
        {t("page-libraries-remove-now")}
      </button>
    </li>
  );
}
