/** The dialog for tag names. */

import { type Signal, useSignal, useSignalEffect } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { IconButton } from "../../ui/button";
import { Actions, Dialog } from "../../ui/dialog";
import { chooseFile } from "../../ui/files";
import type { Toasts } from "../../ui/toasts";
import {
  freeTag,
  isTag,
  LAST_TAG,
  LONGEST_NAME,
  merged,
  namesOf,
  type Row,
  row,
  rowsOf,
  sameNames,
  slipOf,
} from "./rows";
import type { Names, TagDictionary } from "./tag-dictionary";
import "./dialog.css";

type Rows = Signal<readonly Row[]>;

export function TagsDialog() {
  const { dialogs, toasts, tags } = usePage();
  const rows = useSignal(rowsOf(tags.names.peek()));
  useEffect(() => {
    tags.requests.refuse("");
    tags.read.value = null;
  }, []);
  useSignalEffect(() => {
    if (tags.read.value) rows.value = merged(rows.peek(), tags.read.value);
  });
  const saves = useSignal(false);
  const seen = useRef(tags.names.peek());
  useSignalEffect(() => {
    // Show what another page has saved, unless there are unsaved edits here.
    if (sameNames(namesOf(rows.peek()), seen.current)) rows.value = rowsOf(tags.names.value);
    seen.current = tags.names.value;
  });
  const names = namesOf(rows.value);
  const changed = !sameNames(names, tags.names.value);
  const save = (event: SubmitEvent) => {
    event.preventDefault();
    saves.value = true;
    if (names) tags.save(names);
  };
  // The dialog keeps the first closure, so this reads the current values.
  const close = () => {
    dialogs.close();
    const last = namesOf(rows.peek());
    if (last && !sameNames(last, tags.names.peek())) saveInPassing(tags, toasts, last);
  };
  const problem = tags.requests.refusal.value || tags.problem.value;
  return (
    <Dialog title={t("page-tags-title")} close={close} size="large">
      <p class="dim">{t("page-tags-help")}</p>
      <form onSubmit={save} noValidate>
        <TagTable rows={rows} />
        <div class="tag-tools">
          <button
            type="button"
            class="button bordered"
            onClick={() => (rows.value = [...rows.value, row("", freeTag(rows.value))])}
          >
            {t("page-tags-add")}
          </button>
          <button
            type="button"
            class="button bordered"
            onClick={() => chooseFile(".toml,.csv", (file) => void tags.readFile(file))}
          >
            {t("page-tags-import")}
          </button>
          <Exports off={changed} />
        </div>
        <p role="alert" class="refused">
          {problem && say(problem)}
        </p>
        <p role="status" class="dim">
          {changed ? t("page-tags-unsaved") : saves.value && t("page-tags-saved")}
        </p>
        <Actions cancel={() => dialogs.close()}>
          <button type="submit" class="button filled" disabled={!changed || !names}>
            {t("page-tags-save")}
          </button>
        </Actions>
      </form>
    </Dialog>
  );
}

/** Leaving the dialog with Escape saves the names, with undo. */
function saveInPassing(tags: TagDictionary, toasts: Toasts, names: Names): void {
  const before = tags.names.peek();
  tags.save(names);
  const action = { text: t("page-tags-undo"), run: () => tags.save(before) };
  toasts.show({ sort: "note", text: t("page-tags-saved-in-passing"), action });
}

function Exports({ off }: { off: boolean }) {
  const { tags } = usePage();
  return (
    <>
      {(["toml", "csv", "html"] as const).map((format) => (
        <button type="button" key={format} class="button bordered" disabled={off} onClick={() => tags.export(format)}>
          {t(`page-tags-export-${format}`)}
        </button>
      ))}
    </>
  );
}

function TagTable({ rows }: { rows: Rows }) {
  if (rows.value.length === 0) return <p role="status">{t("page-tags-none")}</p>;
  return (
    <div class="tag-table">
      <table>
        <thead>
          <tr>
            <th scope="col">{t("page-tags-picture")}</th>
            <th scope="col">{t("page-tags-name")}</th>
            <th scope="col">{t("page-tags-number")}</th>
            <th scope="col">
              <span class="hidden">{t("page-tags-remove")}</span>
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.value.map((one) => (
            <TagRow key={one.id} one={one} rows={rows} />
          ))}
        </tbody>
      </table>
    </div>
  );
}

function TagRow({ one, rows }: { one: Row; rows: Rows }) {
  const slip = slipOf(one, rows.value);
  const input = useRef<HTMLInputElement>(null);
  // A new row starts with its name.
  useLayoutEffect(() => {
    if (!one.name) input.current?.focus();
  }, []);
  const change = (part: Partial<Row>) => {
    rows.value = rows.value.map((other) => (other.id === one.id ? { ...other, ...part } : other));
  };
  const called = one.name || t("page-tags-nameless");
  const slipId = `tag-slip-${one.id}`;
  return (
    <tr>
      <td>
        {isTag(one.tag) && (
          <img
            class="tag-picture"
            src={`textures/tag/${Number(one.tag)}.png`}
            alt={t("page-tags-picture-of", { tag: one.tag })}
          />
        )}
      </td>
      <td>
        <input
          ref={input}
          aria-label={t("page-tags-name")}
          aria-invalid={slip !== null && slip !== "page-tags-no-tag"}
          aria-describedby={slipId}
          maxLength={LONGEST_NAME}
          value={one.name}
          onInput={({ currentTarget }) => change({ name: currentTarget.value })}
        />
        <span id={slipId} class="refused">
          {slip && t(slip, { last: LAST_TAG })}
        </span>
      </td>
      <td>
        <input
          type="number"
          aria-label={t("page-tags-number-of", { name: called })}
          aria-invalid={slip === "page-tags-no-tag"}
          aria-describedby={slipId}
          min={0}
          max={LAST_TAG}
          value={one.tag}
          onInput={({ currentTarget }) => change({ tag: currentTarget.value })}
        />
      </td>
      <td>
        <IconButton
          icon="trash"
          word="page-tags-remove-one"
          values={{ name: called }}
          onClick={() => (rows.value = rows.value.filter((other) => other.id !== one.id))}
        />
      </td>
    </tr>
  );
}
