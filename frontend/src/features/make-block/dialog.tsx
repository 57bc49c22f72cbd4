/** Makes a block of the program, or changes one: its name and its inputs, with pictures of it. */

import { useSignalEffect } from "@preact/signals";
import { useId, useLayoutEffect, useMemo, useRef } from "preact/hooks";

import { t } from "../../i18n";
import type { MakeBlockDialogName } from "../../model/dialogs";
import { nameInTexts, takenNames } from "../../model/own-block-names";
import { callInText, type OwnBlock, type SampleKind, withChanged, withNew } from "../../model/own-blocks";
import { usePage } from "../../model/page";
import { preferences } from "../../model/preferences";
import { IconButton } from "../../ui/button";
import { Actions, Dialog } from "../../ui/dialog";
import { Icon } from "../../ui/icons";
import { IslandPlace } from "../../ui/island-place";
import { Making, type TypedInput } from "./making";
import type { PicturesOfOwn } from "./preview";
import "./make-block.css";

const KINDS: readonly SampleKind[] = ["number", "text", "truth"];
const EMPTY: OwnBlock = { name: "", inputs: [] };
/** The most characters of a name. */
const LONGEST = 60;

export function MakeBlockDialog({ of: { makeBlock: definition } }: { of: MakeBlockDialogName }) {
  const page = usePage();
  const { context, dialogs, views } = page;
  const made = useRef("");
  const making = useMemo(() => {
    const own = definition ? views.ownBlock(definition) : null;
    return new Making(own ?? EMPTY, takenNames(context.program.state.peek().workspace, definition));
  }, []);
  // The dialog returns the focus first, but a letter typed after Enter is already for the block.
  useLayoutEffect(() => () => queueMicrotask(() => made.current && views.enterBlock(made.current)), []);
  const close = () => dialogs.close();
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    if (!making.isReady.peek()) return;
    made.current = definition;
    views.changeBlocks((program) => {
      if (definition) return withChanged(program, definition, making.own.peek());
      const found = withNew(program, making.own.peek(), { hasLocals: preferences.peek().stage !== "starter" });
      made.current = found.id;
      return found.program;
    });
    close();
  };
  return (
    <Dialog title={t(definition ? "page-make-title-change" : "page-make-button")} close={close}>
      <form class="make-block" onSubmit={submit} noValidate>
        <Pictures making={making} />
        <Name making={making} />
        <Inputs making={making} />
        <div class="make-block-end">
          <code>{callInText(making.own.value)}</code>
          <Actions cancel={close}>
            <button type="submit" class="button filled" aria-disabled={making.isReady.value ? undefined : "true"}>
              {t(definition ? "page-make-change-it" : "page-make-it")}
            </button>
          </Actions>
        </div>
      </form>
    </Dialog>
  );
}

function Pictures({ making }: { making: Making }) {
  const pictures = useRef<PicturesOfOwn | null>(null);
  const load = async () => {
    const { createPictures } = await import("./preview");
    return createPictures([t("page-make-used"), t("page-make-defined")]);
  };
  const ready = (island: PicturesOfOwn | null) => {
    pictures.current = island;
    island?.show(making.own.peek());
  };
  useSignalEffect(() => {
    const own = making.own.value;
    pictures.current?.show(own);
  });
  return (
    <div class="make-block-pictures">
      <IslandPlace load={load} ready={ready} />
    </div>
  );
}

function Name({ making }: { making: Making }) {
  const about = useId();
  const typed = making.name.value;
  const inTexts = nameInTexts(typed);
  const note = inTexts === typed.trim() ? "" : t("page-make-in-texts", { name: inTexts });
  const fault = typed === "" ? "" : making.fault.value;
  return (
    <>
      <label class="field">
        {t("page-make-name")}
        <input
          type="text"
          autofocus
          required
          maxLength={LONGEST}
          aria-describedby={about}
          aria-invalid={fault ? "true" : undefined}
          value={typed}
          onFocus={({ currentTarget }) => currentTarget.select()}
          onInput={({ currentTarget }) => (making.name.value = currentTarget.value)}
        />
      </label>
      <p id={about} role="status" class={fault ? "refused" : "dim"}>
        {fault || note || (typed === "" ? t("page-make-unnamed") : "")}
      </p>
    </>
  );
}

function Inputs({ making }: { making: Making }) {
  return (
    <fieldset>
      <legend>{t("page-make-inputs")}</legend>
      <ul class="make-block-inputs">
        {making.inputs.value.map((input, place) => (
          <Row key={input.key} making={making} input={input} place={place} />
        ))}
      </ul>
      <div class="make-block-kinds">
        {KINDS.map((kind) => (
          <button key={kind} type="button" class="button bordered" onClick={() => making.add(kind)}>
            <Icon name="plus" /> {t(`page-make-kind-${kind}`)}
          </button>
        ))}
      </div>
    </fieldset>
  );
}

function Row({ making, input, place }: { making: Making; input: TypedInput; place: number }) {
  const about = useId();
  const field = useRef<HTMLInputElement>(null);
  const { key, name, kind } = input;
  const fault = making.inputFaults.value.get(key);
  // A new one is named at once.
  useLayoutEffect(() => {
    if (input.was === undefined) field.current?.focus();
  }, []);
  return (
    <li>
      <select
        aria-label={t("page-make-kind", { name })}
        value={kind}
        onChange={({ currentTarget }) => making.set(key, { kind: currentTarget.value as SampleKind })}
      >
        {KINDS.map((one) => (
          <option key={one} value={one}>
            {t(`page-make-kind-${one}`)}
          </option>
        ))}
      </select>
      <input
        ref={field}
        type="text"
        class="make-block-input-name"
        aria-label={t("page-make-input-name", { number: place + 1 })}
        aria-describedby={about}
        aria-invalid={fault ? "true" : undefined}
        maxLength={LONGEST}
        value={name}
        onFocus={({ currentTarget }) => currentTarget.select()}
        onInput={({ currentTarget }) => making.set(key, { name: currentTarget.value })}
      />
      <SampleField making={making} input={input} />
      <IconButton icon="up" word="page-make-up" values={{ name }} off={place === 0} onClick={() => making.raise(key)} />
      <IconButton icon="trash" word="page-make-delete" values={{ name }} onClick={() => making.remove(key)} />
      <p id={about} role="status" class="refused" hidden={!fault}>
        {fault}
      </p>
    </li>
  );
}

/** The value that the input begins with in a new call. */
function SampleField({ making, input: { key, name, kind, value } }: { making: Making; input: TypedInput }) {
  const label = t("page-make-sample", { name });
  const set = (typed: string) => making.set(key, { value: typed });
  if (kind === "truth")
    return (
      <select aria-label={label} value={value} onChange={({ currentTarget }) => set(currentTarget.value)}>
        <option value="true">{t("page-make-yes")}</option>
        <option value="false">{t("page-make-no")}</option>
      </select>
    );
  const field = {
    class: "make-block-sample",
    "aria-label": label,
    value,
    onInput: ({ currentTarget }: { currentTarget: HTMLInputElement }) => set(currentTarget.value),
  };
  return kind === "number" ? <input type="number" step="any" {...field} /> : <input type="text" {...field} />;
}
