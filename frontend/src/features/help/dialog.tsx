/** The help: a search over blocks, lessons and docs, and what it has found. */

import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { language, t } from "../../i18n";
import { usePage } from "../../model/page";
import { Dialog } from "../../ui/dialog";
import { Icon, type IconName } from "../../ui/icons";
import { IslandPlace } from "../../ui/island-place";
import { plain } from "../../ui/plain";
import type { BlockSearch, FoundBlock } from "../../views/blocks/help-search";
import { inLanguage } from "../lessons/lessons";
import { Markdown } from "../lessons/markdown-later";
import { blocksOf } from "./blocks-of";
import { docs, matching, type Section } from "./docs";
import "./help.css";

/** The most results of each kind. */
const MOST = 8;

type Opened = { readonly block: FoundBlock } | { readonly section: Section } | null;

export function HelpDialog() {
  const { dialogs, lessons } = usePage();
  const words = useSignal("");
  const opened = useSignal<Opened>(null);
  const blocks = useSignal<BlockSearch | null>(null);
  const sections = useSignal<readonly Section[]>([]);
  useEffect(() => {
    void import("../../views/blocks/help-search").then(async ({ BlockSearch }) => {
      blocks.value = await BlockSearch.load(language.peek());
    });
    void docs().then((all) => (sections.value = all));
    lessons.list();
  }, []);
  const close = () => dialogs.close();
  const back = () => {
    opened.value = null;
  };
  // The dialog keeps the first one.
  const cancel = () => (opened.peek() ? back() : close());
  const chosen = opened.value;
  return (
    <Dialog title={t("page-help-title")} close={close} cancel={cancel} size="large">
      {chosen ? (
        <Reading opened={chosen} search={blocks.value} back={back} />
      ) : (
        <Search words={words.value} type={(text) => (words.value = text)}>
          <Results
            words={words.value}
            blocks={blocks.value}
            sections={sections.value}
            open={(one) => (opened.value = one)}
          />
        </Search>
      )}
    </Dialog>
  );
}

interface SearchProps {
  readonly words: string;
  readonly type: (words: string) => void;
  readonly children: ComponentChildren;
}

function Search({ words, type, children }: SearchProps) {
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => field.current?.select(), []);
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the arrow keys go through the field and the results in it
    <div class="help-search" onKeyDown={walk}>
      <label class="help-field">
        <Icon name="find" />
        <input
          type="search"
          ref={field}
          placeholder={t("page-help-search")}
          aria-label={t("page-help-search")}
          value={words}
          onInput={({ currentTarget }) => type(currentTarget.value)}
        />
      </label>
      {children}
    </div>
  );
}

/** Go from the field to the results, and through them, with the arrow keys. */
function walk(event: KeyboardEvent): void {
  const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (!by) return;
  const stops = [...(event.currentTarget as HTMLElement).querySelectorAll<HTMLElement>("input, .help-results button")];
  stops[stops.indexOf(document.activeElement as HTMLElement) + by]?.focus();
  event.preventDefault();
}

interface ResultsProps {
  readonly words: string;
  readonly blocks: BlockSearch | null;
  readonly sections: readonly Section[];
  readonly open: (opened: Opened) => void;
}

function Results({ words, blocks, sections, open }: ResultsProps) {
  const { dialogs, lessons } = usePage();
  if (!words.trim()) return <Beginning />;
  const foundBlocks = blocks?.find(words).slice(0, MOST) ?? [];
  const foundLessons = (lessons.choices.value ?? []).filter((one) => says(inLanguage(one.title), words)).slice(0, MOST);
  const foundSections = matching(sections, words, MOST);
  const count = foundBlocks.length + foundLessons.length + foundSections.length;
  return (
    <div class="help-results">
      <p class="hidden" role="status">
        {t("page-help-found", { count })}
      </p>
      {count === 0 && <p>{t("page-help-nothing", { words })}</p>}
      <Group word="page-help-blocks">
        {foundBlocks.map((block) => (
          <Result key={block.title} icon={block.group as IconName} text={block.title} open={() => open({ block })} />
        ))}
      </Group>
      <Group word="page-help-lessons">
        {foundLessons.map((lesson) => {
          const start = () => {
            dialogs.close();
            lessons.start(lesson);
          };
          return <Result key={lesson.name} icon="lesson" text={inLanguage(lesson.title)} open={start} />;
        })}
      </Group>
      <Group word="page-help-docs">
        {foundSections.map((section) => (
          <Result
            key={`${section.page} ${section.heading}`}
            icon="help"
            text={section.heading}
            within={section.page === section.heading ? "" : section.page}
            open={() => open({ section })}
          />
        ))}
      </Group>
    </div>
  );
}

function says(text: string, words: string): boolean {
  return plain(words)
    .split(/\s+/)
    .every((word) => plain(text).includes(word));
}

/** Before anything is typed. */
function Beginning() {
  const { dialogs } = usePage();
  const tour = () => {
    dialogs.close();
    dialogs.tour.value = true;
  };
  return (
    <>
      <p class="dim">{t("page-help-hint")}</p>
      <ul class="help-results">
        <Result icon="lesson" text={t("page-tour-title")} open={tour} />
        <Result icon="keyboard" text={t("page-settings-shortcuts")} open={() => dialogs.show("shortcuts")} />
      </ul>
    </>
  );
}

function Group({ word, children }: { word: string; children: readonly ComponentChildren[] }) {
  if (children.length === 0) return null;
  return (
    <section>
      <h3>{t(word)}</h3>
      <ul>{children}</ul>
    </section>
  );
}

interface ResultProps {
  readonly icon: IconName;
  readonly text: string;
  /** Where it is. */
  readonly within?: string;
  readonly open: () => void;
}

function Result({ icon, text, within, open }: ResultProps) {
  return (
    <li>
      <button type="button" class="help-result" onClick={open}>
        <Icon name={icon} />
        <span>{text}</span>
        {within && <small>{within}</small>}
      </button>
    </li>
  );
}

interface ReadingProps {
  readonly opened: NonNullable<Opened>;
  readonly search: BlockSearch | null;
  readonly back: () => void;
}

function Reading({ opened, search, back }: ReadingProps) {
  const button = useRef<HTMLButtonElement>(null);
  // The result that had the focus has gone.
  useLayoutEffect(() => button.current?.focus(), []);
  return (
    <div class="help-reading">
      <button type="button" class="button bordered" ref={button} onClick={back}>
        <Icon name="previous" />
        {t("page-help-back")}
      </button>
      {"section" in opened ? (
        <Doc section={opened.section} />
      ) : (
        search && <OneBlock found={opened.block} search={search} />
      )}
    </div>
  );
}

/** Opens an example as a project, in place of the help. */
function useExamples(): (program: string) => void {
  const { context, dialogs } = usePage();
  return (program) => {
    dialogs.close();
    context.openExample(program);
  };
}

function OneBlock({ found, search }: { found: FoundBlock; search: BlockSearch }) {
  const open = useExamples();
  return (
    <>
      <h3>{found.title}</h3>
      <IslandPlace load={async () => search.explain(found.item, open)} />
    </>
  );
}

function Doc({ section: { page, heading, text } }: { section: Section }) {
  const open = useExamples();
  return (
    <article lang="en">
      <h3>{heading}</h3>
      {page !== heading && <p class="dim">{page}</p>}
      <Markdown text={text} lesson="" drawings={{}} blocksOf={blocksOf} open={open} />
    </article>
  );
}
