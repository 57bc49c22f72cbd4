import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { ProjectEntry } from "../../protocol/messages";
import { IconButton } from "../../ui/button";
import { date } from "../../ui/dates";
import { Dialog } from "../../ui/dialog";

/** All projects, the last changed first. */
export function OpenDialog() {
  const { dialogs, project } = usePage();
  const search = useSignal("");
  useEffect(() => project.list(), []);
  const entries = project.entries.value ?? [];
  const found = entries.filter(({ name }) => name.toLowerCase().includes(search.value.toLowerCase()));
  return (
    <Dialog title={t("page-project-open-title")} close={() => dialogs.close()}>
      <label class="field">
        {t("page-project-search")}
        <input
          type="search"
          autofocus
          value={search.value}
          onInput={({ currentTarget }) => (search.value = currentTarget.value)}
        />
      </label>
      {found.length === 0 && <p role="status">{t("page-project-none-found")}</p>}
      <ul class="rows">
        {found.map((entry) => (
          <Entry key={entry.name} entry={entry} />
        ))}
      </ul>
    </Dialog>
  );
}

function Entry({ entry: { name, changed } }: { entry: ProjectEntry }) {
  const { dialogs, project } = usePage();
  const open = () => {
    dialogs.close();
    project.open(name);
  };
  return (
    <li>
      <button type="button" class="row-main" onClick={open}>
        <strong>{name}</strong>
        <span class="dim">
          {date(changed)}
          {name === project.name.value && ` · ${t("page-project-is-open")}`}
        </span>
      </button>
      <IconButton
        icon="trash"
        word="page-project-delete-one"
        values={{ name }}
        onClick={() => dialogs.show({ delete: name })}
      />
    </li>
  );
}
