/** The dialog for the names of tags. */

import { useSignal, useSignalEffect, type Signal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { said } from "../../sentences";
import type { Names } from "../../tags/dictionary";
import { freeTag, isTag, LAST_TAG, LONGEST_NAME, merged, namesOf, row, rowsOf, sameNames, slipOf, type Row } from "../../tags/rows";
import { chooseFile } from "../files";
import { usePage, type Page } from "../page";
import { IconButton } from "../widgets/button";
import { Actions, Dialog } from "../widgets/dialog";
import "./tags.css";

type Rows = Signal<readonly Row[]>;

export function TagsDialog() {
  const page = usePage();
  const { dialogs, tags } = page;
  const rows = useSignal(rowsOf(tags.names.peek()));
  useEffect(() => {
    tags.refusal.value = "";
    tags.read.value = null;
  }, []);
  useSignalEffect(() => {
    if (tags.read.value) rows.value = merged(rows.peek(), tags.read.value);
  });
  const seen = useRef(tags.names.peek());
  useSignalEffect(() => {
    // What another page has saved is shown, unless there is something here that is not saved yet.
    if (sameNames(namesOf(rows.peek()), seen.current)) rows.value = rowsOf(tags.names.value);
    seen.current = tags.names.value;
  });
  const names = namesOf(rows.value);
  const changed = !sameNames(names, tags.names.value);
  const save = (event: SubmitEvent) => {
    event.preventDefault();
    if (names) tags.save(names);
  };
  // The dialog keeps the first of these: it looks at what there is when it is called.
  const close = () => {
    dialogs.close();
    const last = namesOf(rows.peek());
    if (last && !sameNames(last, tags.names.peek())) saveInPassing(page, last);
  };
  const problem = tags.refusal.value || tags.problem.value;
  return (
    <Dialog title={t("tags.title")} close={close} size="large">
      <p class="dim">{t("tags.help")}</p>
      <form onSubmit={save} noValidate>
        <TagTable rows={rows} />
        <div class="tag-tools">
          <button type="button" class="button bordered" onClick={() => (rows.value = [...rows.value, row("", freeTag(rows.value))])}>
            {t("tags.add")}
          </button>
          <button type="button" class="button bordered" onClick={() => chooseFile(".toml,.csv", (file) => void tags.readFile(file))}>
            {t("tags.import")}
          </button>
          <Exports off={changed} />
        </div>
        <p role="alert" class="refused">
          {problem && said(problem)}
        </p>
        <p role="status" class="dim">
          {t(changed ? "tags.unsaved" : "tags.saved")}
        </p>
        <Actions cancel={() => dialogs.close()}>
          <button type="submit" class="button filled" disabled={!changed || !names}>
            {t("tags.save")}
          </button>
        </Actions>
      </form>
    </Dialog>
  );
}

/** Whoever leaves the dialog by Escape has not said that all was in vain. */
function saveInPassing({ tags, toasts }: Page, names: Names): void {
  const before = tags.names.peek();
  tags.save(names);
  const action = { text: t("tags.undo"), run: () => tags.save(before) };
  toasts.show({ sort: "note", text: t("tags.savedInPassing"), action });
}

function Exports({ off }: { off: boolean }) {
  const { tags } = usePage();
  return (
    <>
      {(["toml", "csv", "html"] as const).map((format) => (
        <button type="button" key={format} class="button bordered" disabled={off} onClick={() => tags.export(format)}>
          {t(`tags.export_${format}`)}
        </button>
      ))}
    </>
  );
}

function TagTable({ rows }: { rows: Rows }) {
  if (rows.value.length === 0) return <p role="status">{t("tags.none")}</p>;
  return (
    <div class="tag-table">
      <table>
        <thead>
          <tr>
            <th scope="col">{t("tags.picture")}</th>
            <th scope="col">{t("tags.name")}</th>
            <th scope="col">{t("tags.number")}</th>
            <th scope="col">
              <span class="hidden">{t("tags.remove")}</span>
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
  // Whoever adds a line goes on by giving it its name.
  useLayoutEffect(() => {
    if (!one.name) input.current?.focus();
  }, []);
  const change = (part: Partial<Row>) => {
    rows.value = rows.value.map((other) => (other.id === one.id ? { ...other, ...part } : other));
  };
  const called = one.name || t("tags.nameless");
  const slipId = `tag-slip-${one.id}`;
  return (
    <tr>
      <td>{isTag(one.tag) && <img class="tag-picture" src={`textures/tag/${Number(one.tag)}.png`} alt={t("tags.pictureOf", { tag: one.tag })} />}</td>
      <td>
        <input
          ref={input}
          aria-label={t("tags.name")}
          aria-invalid={slip !== null && slip !== "tags.noTag"}
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
          aria-label={t("tags.numberOf", { name: called })}
          aria-invalid={slip === "tags.noTag"}
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
          word="tags.removeOne"
          values={{ name: called }}
          onClick={() => (rows.value = rows.value.filter((other) => other.id !== one.id))}
        />
      </td>
    </tr>
  );
}
