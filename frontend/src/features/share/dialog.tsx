/** Everything that takes the program elsewhere: a link, a file, a picture, a film, paper. */

import { type Signal, useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { sharedAddress } from "../../protocol/address";
import type { ShareLink } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";
import { Icon } from "../../ui/icons";
import { InClass } from "./in-class";
import { fingerprint } from "./links";
import { printProgram } from "./print";
import { Snapshot } from "./snapshot";
import { Tile } from "./tile";
import "./dialog.css";

/** A longer link makes a code that cameras can't read from a screen. */
const LONGEST_CODE = 1200;
/** Characters of a pupil's name. */
const LONGEST_NAME = 40;

export function ShareDialog() {
  const { context, dialogs, project } = usePage();
  const answer = useSignal<ShareLink | null>(null);
  const pupil = useSignal<string | null>(null);
  useEffect(() => {
    context.program.flush();
    void context.connection.ask({ kind: "MakeLink" }).then((reply) => {
      if (reply.kind === "ShareLink") answer.value = reply;
    });
  }, []);
  return (
    <Dialog title={t("page-share-title", { name: project.name.value })} close={() => dialogs.close()} size="large">
      <div class="share">
        <div class="share-run">
          <Snapshot />
          {answer.value && <Proof answer={answer.value} />}
          <Maker pupil={pupil} />
          <p class="dim">{t("page-share-copies")}</p>
        </div>
        <div class="share-ways">
          {answer.value?.link ? (
            <Link answer={answer.value} />
          ) : (
            <p role="status">{answer.value?.problem && say(answer.value.problem)}</p>
          )}
          <InClass link={answer.value?.link ?? ""} />
          <Keeping pupil={pupil.value ?? ""} />
        </div>
      </div>
    </Dialog>
  );
}

function Proof({ answer: { link, trace_sha256: hash = "", problem } }: { answer: ShareLink }) {
  if (!link) return null;
  return (
    <div class={hash ? "share-proof proved" : "share-proof"}>
      <Icon name={hash ? "check" : "hint"} />
      <div>
        <strong>{t(hash ? "page-share-proved" : "page-share-unproved")}</strong>
        <p>
          {hash ? t("page-share-proved-help") : problem && say(problem)} {hash && <code>{fingerprint(hash)}</code>}
        </p>
      </div>
    </div>
  );
}

/** Who made it, if the page to take home is to say so; null otherwise. */
function Maker({ pupil }: { pupil: Signal<string | null> }) {
  return (
    <div class="share-maker">
      <label class="check">
        <input
          type="checkbox"
          aria-describedby="share-maker-help"
          checked={pupil.value !== null}
          onChange={({ currentTarget }) => (pupil.value = currentTarget.checked ? "" : null)}
        />
        {t("page-share-maker")}
      </label>
      <p id="share-maker-help" class="dim">
        {t("page-share-maker-help")}
      </p>
      {pupil.value !== null && (
        <label class="field">
          {t("page-share-maker-name")}
          <input
            value={pupil.value}
            maxLength={LONGEST_NAME}
            autocomplete="off"
            onInput={({ currentTarget }) => (pupil.value = currentTarget.value)}
          />
        </label>
      )}
    </div>
  );
}

function Link({ answer: { link } }: { answer: ShareLink }) {
  const { project, toasts } = usePage();
  const address = sharedAddress(link, project.welcome.value?.address ?? null);
  const code = useSignal("");
  useEffect(() => {
    if (address.length > LONGEST_CODE) return;
    void import("uqr").then(({ renderSVG }) => {
      code.value = `data:image/svg+xml,${encodeURIComponent(renderSVG(address, { ecc: "L", border: 4 }))}`;
    });
  }, [address]);
  const copy = async () => {
    await navigator.clipboard.writeText(address);
    toasts.note(t("page-share-copied"));
  };
  return (
    <div class="share-link">
      <div>
        <label class="field">
          {t("page-share-link")}
          <input readOnly value={address} onFocus={({ currentTarget }) => currentTarget.select()} />
        </label>
        {/* Browsers allow it on this computer and with HTTPS. */}
        {navigator.clipboard && (
          <button type="button" class="button filled" autofocus onClick={() => void copy()}>
            <Icon name="copy" />
            {t("page-share-copy")}
          </button>
        )}
        <p class="dim">{t("page-share-inside", { count: address.length })}</p>
      </div>
      {code.value && <img class="share-code" src={code.value} alt={t("page-share-code")} />}
    </div>
  );
}

function Keeping({ pupil }: { pupil: string }) {
  const page = usePage();
  const { context, dialogs, project, share } = page;
  const run = (action: () => void) => () => {
    dialogs.close();
    action();
  };
  const isRunning = context.running.active.value || share.isFilming.value;
  return (
    <>
      <h3>{t("page-share-keep")}</h3>
      <div class="share-tiles">
        <Tile icon="download" word="file" onClick={() => project.export("learnblock")} />
        <Tile icon="blocktext" word="blocktext" onClick={() => project.export("bt")} />
        <Tile icon="python" word="python" onClick={() => project.export("py")} />
        <Tile icon="blocks" word="program" onClick={() => dialogs.show("programPicture")} />
        <Tile icon="print" word="print" onClick={run(() => void printProgram(page))} />
        <Tile icon="image" word="picture" onClick={run(() => void share.takePicture())} />
        <Tile icon="video" word="film" off={isRunning} onClick={run(() => share.film())} />
        <Tile icon="home" word="run" off={isRunning} onClick={run(() => share.exportRun(pupil.trim()))} />
      </div>
    </>
  );
}
