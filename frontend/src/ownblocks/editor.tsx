import { t } from "../i18n";
import type { OwnBlockProblem } from "../messages";
import { said } from "../sentences";
import { Icon } from "../chrome/widgets/icons";
import { IslandPlace } from "../chrome/widgets/island";
import { Tabs } from "../chrome/widgets/tabs";
import { usePage } from "../chrome/page";
import type { Editing, TabName } from "./editing";
import { Form } from "./form";
import { TryIt } from "./tryit";

/** Code and what is wrong with it at one side, what becomes of it at the other. */
export function Editor({ editing }: { editing: Editing }) {
  const { source } = editing;
  return (
    <>
      <Head editing={editing} />
      <section class="own-block-code" aria-label={t("ownblocks.source")}>
        <IslandPlace load={async () => source} ready={(code) => code?.focus()} />
        <Problems editing={editing} />
      </section>
      <section class="own-block-side" aria-label={t("ownblocks.block")}>
        <FunctionChoice editing={editing} />
        <IslandPlace load={async () => editing.preview} />
        <Tabs
          label={t("ownblocks.block")}
          tabs={tabs(editing)}
          selected={editing.tab.value}
          select={(name: TabName) => (editing.tab.value = name)}
        />
      </section>
    </>
  );
}

function tabs(editing: Editing) {
  return [
    { name: "ownForm", text: t("ownblocks.tab_form"), panel: <Form editing={editing} /> },
    { name: "ownTry", text: t("ownblocks.tab_try"), panel: <TryIt editing={editing} /> },
    { name: "ownJson", text: t("ownblocks.tab_json"), panel: <Json editing={editing} /> },
  ] as const;
}

function Json({ editing }: { editing: Editing }) {
  return (
    <div class="own-block-json">
      <p class="dim">{t("ownblocks.jsonHelp")}</p>
      <IslandPlace load={async () => editing.json} />
    </div>
  );
}

function Head({ editing: { draft } }: { editing: Editing }) {
  const { context } = usePage();
  const { goesOn, dirty } = draft;
  return (
    <header class="own-block-head">
      <button type="button" class="button bordered" onClick={() => context.listOwnBlocks()}>
        {t("ownblocks.all")}
      </button>
      <Status draft={draft} />
      {dirty.value && (
        <button type="button" class="button bordered" title={goesOn.value ? t("ownblocks.goesOn") : undefined} onClick={() => draft.discard()}>
          {t("ownblocks.discard")}
        </button>
      )}
      <button type="button" class="button filled" title="Ctrl+S" onClick={() => draft.save()}>
        {t("ownblocks.save")}
      </button>
    </header>
  );
}

function Status({ draft }: Pick<Editing, "draft">) {
  const { dirty, goesOn, outcome } = draft;
  const ended = outcome.value;
  const refused = ended && "refused" in ended;
  return (
    <p class={refused ? "own-block-status failed" : "own-block-status"} role={refused ? "alert" : "status"}>
      {!ended && dirty.value && t(goesOn.value ? "ownblocks.goesOn" : "ownblocks.unsaved")}
      {ended && "saved" in ended && t("ownblocks.saved", { name: ended.saved })}
      {refused && (ended.refused ? said(ended.refused) : t("ownblocks.refused"))}
    </p>
  );
}

/** A file may make several blocks: one of them is shown and described. */
function FunctionChoice({ editing: { draft, chosen, block } }: { editing: Editing }) {
  const names = draft.blocks.value.map(({ name }) => name);
  if (names.length < 2) return null;
  return (
    <label class="field">
      {t("ownblocks.function")}
      <select value={block.value?.name ?? ""} onChange={({ currentTarget }) => (chosen.value = currentTarget.value)}>
        {names.map((name) => (
          <option key={name}>{name}</option>
        ))}
      </select>
    </label>
  );
}

function Problems({ editing }: { editing: Editing }) {
  const problems = editing.problems.value;
  return (
    <div class="own-block-problems" role="status" aria-label={t("ownblocks.problems")} hidden={problems.length === 0}>
      <ul>
        {problems.map((problem) => (
          <li key={`${problem.part} ${problem.line ?? 0} ${problem.message}`}>
            <button type="button" class={`problem ${problem.severity}`} onClick={() => editing.goTo(problem)}>
              <Icon name={problem.severity} />
              <span>{said(problem.message)}</span>
              <span class="dim">{placeOf(problem)}</span>
            </button>
          </li>
        ))}
      </ul>
    </div>
  );
}

function placeOf({ part, line = 0 }: OwnBlockProblem): string {
  const name = t(`ownblocks.part_${part}`);
  return line ? t("problems.place", { view: name, line }) : name;
}
