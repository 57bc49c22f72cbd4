/** A class with what can be done to it. */

import { useSignal } from "@preact/signals";

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import type { ClassEntry } from "../../protocol/messages";
import { day } from "../../ui/dates";
import { Dialog } from "../../ui/dialog";
import { Icon } from "../../ui/icons";
import { Menu, type MenuGroup } from "../../ui/menu";
import { inLanguage } from "../lessons/lessons";
import { CLASS_FILE } from "./classes";

export function ClassCard({ entry }: { entry: ClassEntry }) {
  const { classes } = usePage();
  const leaving = useSignal(false);
  const { title, wall = "", problem = null } = entry;
  const isBusy = classes.busy.value === title;
  return (
    <li class={wall ? "start-card teachers-class open" : "start-card teachers-class"} aria-busy={isBusy}>
      <div class="teachers-class-head">
        <h3>
          <bdi>{t("page-class-title", { title })}</bdi>
        </h3>
        <span class="teachers-state">
          <Icon name={wall ? "run" : "saved"} />
          {t(wall ? "page-teachers-is-open" : "page-teachers-is-closed")}
        </span>
        {!wall && (
          <Menu
            label={t("page-start-more", { name: title })}
            icon="more"
            groups={groups(entry, () => (leaving.value = true))}
            side="right"
          />
        )}
      </div>
      {problem ? <p class="teachers-problem">{say(problem)}</p> : <Facts entry={entry} />}
      <div class="teachers-actions">
        <Actions entry={entry} isBusy={isBusy} />
      </div>
      {leaving.value && <DeleteDialog title={title} close={() => (leaving.value = false)} />}
    </li>
  );
}

function Facts({ entry: { pupils = 0, used = 0, lesson } }: { entry: ClassEntry }) {
  const { lessons } = usePage();
  const begun = lessons.choices.value?.find(({ name }) => name === lesson);
  return (
    <p class="dim">
      {t("page-teachers-pupils", { count: pupils })} · {t("page-teachers-used", { day: day(used) })}
      {begun && ` · ${t("page-teachers-begins", { lesson: inLanguage(begun.title) })}`}
    </p>
  );
}

function Actions({ entry, isBusy }: { entry: ClassEntry; isBusy: boolean }) {
  const { classes } = usePage();
  const { title, wall = "", lesson, project, blocks, problem } = entry;
  const isAnyBusy = classes.busy.value !== "";
  if (isBusy) return <p role="status">{t(wall ? "page-teachers-closing" : "page-teachers-opening")}</p>;
  if (wall) {
    return (
      <>
        <button type="button" class="button bordered" disabled={isAnyBusy} onClick={() => void classes.close(title)}>
          {t("page-teachers-close")}
        </button>
        <a class="button filled" href={wall} target="_blank" rel="noreferrer">
          {t("page-teachers-wall")}
          <Icon name="next" />
        </a>
      </>
    );
  }
  return (
    <button
      type="button"
      class="button bordered"
      disabled={isAnyBusy || problem != null}
      onClick={() => void classes.start({ title, lesson, project, blocks })}
    >
      {t("page-teachers-open")}
    </button>
  );
}

function groups({ title }: ClassEntry, remove: () => void): readonly MenuGroup[] {
  const address = `classes/${encodeURIComponent(title)}${CLASS_FILE}`;
  return [
    { items: [{ text: t("page-teachers-download"), icon: "download", run: () => location.assign(address) }] },
    { items: [{ text: t("page-teachers-delete"), icon: "trash", run: remove }] },
  ];
}

/** Deletes a class whose name is typed, since it contains everything that its pupils have made. */
function DeleteDialog({ title, close }: { title: string; close: () => void }) {
  const { classes } = usePage();
  const typed = useSignal("");
  const remove = (event: Event) => {
    event.preventDefault();
    close();
    void classes.delete(title);
  };
  return (
    <Dialog title={t("page-teachers-delete-title", { title })} close={close}>
      <form class="teachers-delete" onSubmit={remove}>
        <p>{t("page-teachers-delete-text")}</p>
        <label class="field">
          {t("page-teachers-delete-type", { title })}
          <input autofocus value={typed.value} onInput={({ currentTarget }) => (typed.value = currentTarget.value)} />
        </label>
        <div class="dialog-buttons">
          <button type="button" class="button bordered" onClick={close}>
            {t("page-teachers-keep")}
          </button>
          <button type="submit" class="button filled" disabled={typed.value.trim() !== title}>
            {t("page-teachers-delete")}
          </button>
        </div>
      </form>
    </Dialog>
  );
}
