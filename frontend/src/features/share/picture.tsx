/** Saves a picture of the program: its type, language, theme and part can be chosen. */

import { type Signal, useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { language, languages, t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import { THEMES, type ThemeName, theme } from "../../model/preferences";
import type { ProgramState } from "../../model/program";
import { Actions, Dialog } from "../../ui/dialog";
import { saveFile } from "../../ui/files";
import { languageName } from "../../ui/language-name";
import { svgAddress, svgPixels, svgText } from "../../ui/picture-file";
import { SelectField } from "../../ui/select-field";
import type { PortablePicture } from "../../views/blocks/portable-svg";
import type { PictureChoices } from "../../views/blocks/program-picture";
import { loadDrawing } from "./draw-program";

const TYPES = ["svg", "png"] as const;
type Choices = Omit<PictureChoices, "text">;

export function ProgramPictureDialog() {
  const page = usePage();
  const { context, dialogs, project, views } = page;
  const choices = useSignal<Choices>({ language: language.peek(), theme: theme.peek(), only: null });
  const type = useSignal<(typeof TYPES)[number]>("svg");
  const picture = usePicture(page, choices);
  const close = () => dialogs.show("share");
  const save = async (event: SubmitEvent) => {
    event.preventDefault();
    if (!picture.value) return;
    const { svg, width, height } = picture.value;
    const name = `${project.name.peek()}.${type.value}`;
    if (type.value === "svg") saveFile(name, svgText(svg), "image/svg+xml");
    else saveFile(name, await svgPixels(svg, width, height), "image/png");
    close();
  };
  const text = textOf(context.program.state.value, choices.value.only);
  return (
    <Dialog title={t("page-share-program")} close={close} size="large">
      <form class="share-picture" onSubmit={save}>
        <div class="share-picture-choices">
          <SelectField
            autofocus
            label={t("page-share-program-format")}
            value={type.value}
            choose={(value) => (type.value = value as (typeof TYPES)[number])}
          >
            {TYPES.map((name) => [name, name.toUpperCase()])}
          </SelectField>
          <ChoiceFields choices={choices} selected={views.selected.value} />
          <label class="field">
            {t("page-share-program-alternative")}
            <textarea readOnly rows={4} value={text} onFocus={({ currentTarget }) => currentTarget.select()} />
          </label>
          <Actions cancel={close}>
            <button type="submit" class="button filled" disabled={!picture.value}>
              {t("page-share-program-save")}
            </button>
          </Actions>
        </div>
        {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a keyboard user must be able to scroll it */}
        <div class="share-picture-shown" role="group" aria-label={t("page-share-program")} tabIndex={0}>
          {picture.value && <img src={svgAddress(picture.value.svg)} width={picture.value.width / 2} alt={text} />}
        </div>
      </form>
    </Dialog>
  );
}

/** The picture of the program as chosen; it is drawn again when something else is chosen. */
function usePicture({ context }: Page, choices: Signal<Choices>): Signal<PortablePicture | null> {
  const picture = useSignal<PortablePicture | null>(null);
  const chosen = choices.value;
  useEffect(() => {
    let isGone = false;
    void draw(context, chosen).then((drawn) => {
      if (!isGone) picture.value = drawn;
    });
    return () => {
      isGone = true;
    };
  }, [chosen]);
  return picture;
}

/** Draw the program of the page. */
async function draw({ program }: Page["context"], choices: Choices): Promise<PortablePicture> {
  const drawProgram = await loadDrawing();
  const state = program.state.peek();
  return drawProgram(state.workspace, { ...choices, text: textOf(state, choices.only) });
}

/** The Block-Text of the program, or only that of a block. */
function textOf({ blocktext, places }: ProgramState, only: string | null): string {
  const [, first = 1, last] = places.find(([block]) => block === only) ?? [];
  return blocktext
    .split("\n")
    .slice(first - 1, last)
    .join("\n");
}

interface FieldsProps {
  readonly choices: Signal<Choices>;
  readonly selected: string | null;
}

function ChoiceFields({ choices, selected }: FieldsProps) {
  const { language: code, theme: name, only } = choices.value;
  const choose = (change: Partial<Choices>) => (choices.value = { ...choices.peek(), ...change });
  return (
    <>
      <SelectField label={t("page-bar-language")} value={code} choose={(value) => choose({ language: value })}>
        {languages.map((one) => [one, languageName(one)])}
      </SelectField>
      <SelectField label={t("page-bar-theme")} value={name} choose={(value) => choose({ theme: value as ThemeName })}>
        {THEMES.filter((one) => one !== "system").map((one) => [one, t(`page-settings-theme-${one}`)])}
      </SelectField>
      {selected && (
        <SelectField
          label={t("page-share-program-shown")}
          value={only ? "selected" : "whole"}
          choose={(value) => choose({ only: value === "selected" ? selected : null })}
        >
          {["whole", "selected"].map((part) => [part, t(`page-share-program-${part}`)])}
        </SelectField>
      )}
    </>
  );
}
