/** Starts a class with a button: its name, the first lesson and the blocks. */

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { StartClass as Message } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { titleOf } from "../block-sets/block-sets";
import { inLanguage } from "../lessons/lessons";
import { newTitle } from "./classes";

type Blocks = NonNullable<Message["blocks"]>;

const EVERYTHING: Blocks = "everything";

export function StartClass() {
  const { classes, lessons, blockSets } = usePage();
  const entries = classes.entries.value;
  const title = useSignal<string | null>(null);
  const lesson = useSignal<string | null>(null);
  const blocks = useSignal<Blocks>(EVERYTHING);
  const name = useRef<HTMLInputElement>(null);
  useEffect(() => {
    // Typing replaces the suggested name.
    if (title.peek() === null) name.current?.select();
  }, [entries === null]);
  const choices = (lessons.choices.value ?? []).filter(({ own = false }) => !own);
  const first = choices.find((each) => each.name === (lesson.value ?? choices[0]?.name));
  const typed = title.value ?? newTitle(entries ?? []);
  const start = (event: Event) => {
    event.preventDefault();
    const project = first && inLanguage(first.title).slice(0, 80);
    void classes.start({ title: typed.trim(), lesson: first?.name ?? null, project, blocks: blocks.value });
    title.value = null;
  };
  return (
    <section class="start-card" aria-labelledby="teachers-start">
      <h2 id="teachers-start">{t("page-teachers-start")}</h2>
      <form class="teachers-start" onSubmit={start}>
        <label class="field">
          {t("page-teachers-name")}
          <input
            ref={name}
            required
            maxLength={40}
            value={typed}
            onInput={({ currentTarget }) => (title.value = currentTarget.value)}
          />
        </label>
        <label class="field">
          {t("page-teachers-lesson")}
          <select value={first?.name ?? ""} onChange={({ currentTarget }) => (lesson.value = currentTarget.value)}>
            <option value="">{t("page-teachers-no-lesson")}</option>
            {choices.map((each) => (
              <option key={each.name} value={each.name}>
                {inLanguage(each.title)}
              </option>
            ))}
          </select>
        </label>
        <label class="field">
          {t("page-teachers-blocks")}
          <select value={blocks.value} onChange={({ currentTarget }) => (blocks.value = currentTarget.value as Blocks)}>
            {blockSets.ours.value.map((set) => (
              <option key={set.name} value={set.name}>
                {titleOf(set)}
              </option>
            ))}
          </select>
        </label>
        <button type="submit" class="button filled" disabled={!typed.trim() || classes.busy.value !== ""}>
          <Icon name="run" />
          {t("page-teachers-start-button")}
        </button>
        <p class="dim">{t("page-teachers-next")}</p>
      </form>
    </section>
  );
}
