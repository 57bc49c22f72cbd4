import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import type { CustomBlockProblem } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { IslandPlace } from "../../ui/island-place";
import { Tabs } from "../../ui/tabs";
import type { Editing, TabName } from "./editing";
import { Form } from "./form";
import { TryIt } from "./try-it";

/** The code with its problems on one side, the block that it makes on the other. */
export function CustomBlockEditor({ editing }: { editing: Editing }) {
  const { source } = editing;
  return (
    <>
      <Head editing={editing} />
      <section class="custom-block-code" aria-label={t("page-custom-source")}>
        <IslandPlace load={async () => source} ready={(code) => code?.focus()} />
        <Problems editing={editing} />
      </section>
      <section class="custom-block-side" aria-label={t("page-custom-block")}>
        <FunctionChoice editing={editing} />
        <IslandPlace load={async () => editing.preview} />
        <Tabs
          label={t("page-custom-block")}
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
    { name: "ownForm", text: t("page-custom-tab-form"), panel: <Form editing={editing} /> },
    { name: "ownTry", text: t("page-custom-tab-try"), panel: <TryIt editing={editing} /> },
    { name: "ownJson", text: t("page-custom-tab-json"), panel: <Json editing={editing} /> },
  ] as const;
}

function Json({ editing }: { editing: Editing }) {
  return (
    <div class="custom-block-json">
      <p class="dim">{t("page-custom-json-help")}</p>
      <IslandPlace load={async () => editing.json} />
    </div>
  );
}

function Head({ editing: { draft } }: { editing: Editing }) {
  const { context } = usePage();
  const { restored, dirty } = draft;
  return (
    <div class="custom-block-head">
      <button type="button" class="button bordered" onClick={() => context.listCustomBlocks()}>
        {t("page-custom-all")}
      </button>
      <Status draft={draft} />
      {dirty.value && (
        <button
          type="button"
          class="button bordered"
          title={restored.value ? t("page-custom-goes-on") : undefined}
          onClick={() => draft.discard()}
        >
          {t("page-custom-discard")}
        </button>
      )}
      <button type="button" class="button filled" title="Ctrl+S" onClick={() => draft.save()}>
        {t("page-custom-save")}
      </button>
    </div>
  );
}

function Status({ draft }: Pick<Editing, "draft">) {
  const { dirty, restored, outcome } = draft;
  const ended = outcome.value;
  const refused = ended && "refused" in ended;
  return (
    <p class={refused ? "custom-block-status failed" : "custom-block-status"} role={refused ? "alert" : "status"}>
      {!ended && dirty.value && t(restored.value ? "page-custom-goes-on" : "page-custom-unsaved")}
      {ended && "saved" in ended && t("page-custom-saved", { name: ended.saved })}
      {refused && (ended.refused ? say(ended.refused) : t("page-custom-refused"))}
    </p>
  );
}

/** A file may define several blocks; the user chooses which one is shown. */
function FunctionChoice({ editing: { draft, chosen, block } }: { editing: Editing }) {
  const names = draft.blocks.value.map(({ name }) => name);
  if (names.length < 2) return null;
  return (
    <label class="field">
      {t("page-custom-function")}
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
    <div
      class="custom-block-problems"
      role="status"
      aria-label={t("page-custom-problems")}
      hidden={problems.length === 0}
    >
      <ul>
        {problems.map((problem) => (
          <li key={`${problem.part} ${problem.line ?? 0} ${say(problem.message)}`}>
            <button type="button" class={`problem ${problem.severity}`} onClick={() => editing.goTo(problem)}>
              <Icon name={problem.severity} />
              <span>{say(problem.message)}</span>
              <span class="dim">{placeOf(problem)}</span>
            </button>
          </li>
        ))}
      </ul>
    </div>
  );
}

function placeOf({ part, line = 0 }: CustomBlockProblem): string {
  const name = t(`page-custom-part-${part}`);
  return line ? t("page-problems-place", { view: name, line }) : name;
}
