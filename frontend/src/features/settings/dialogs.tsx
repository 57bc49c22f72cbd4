/** The dialogs for preferences and keyboard shortcuts. */

import { language, languages, t } from "../../i18n";
import { hear, isHeard } from "../../model/loudness";
import { usePage } from "../../model/page";
import { type Preferences, prefer, preferences, THEMES } from "../../model/preferences";
import { Dialog } from "../../ui/dialog";
import { languageName } from "../../ui/language-name";
import { SelectField } from "../../ui/select-field";
import { keysOf, OTHER_KEYS, SHORTCUTS } from "../../ui/shortcuts";

export function SettingsDialog() {
  const { classNews, dialogs, project } = usePage();
  const { theme, audible, celebrate } = preferences.value;
  const inClass = classNews.now.value !== null;
  const welcome = project.welcome.value;
  return (
    <Dialog title={t("page-settings-title")} close={() => dialogs.close()}>
      <SelectField label={t("page-bar-language")} value={language.value} choose={(code) => prefer({ language: code })}>
        {languages.map((code) => [code, languageName(code)])}
      </SelectField>
      <SelectField
        label={t("page-bar-theme")}
        value={theme}
        choose={(name) => prefer({ theme: name as Preferences["theme"] })}
      >
        {THEMES.map((name) => [name, t(`page-settings-theme-${name}`)])}
      </SelectField>
      <Check label={t("page-settings-sound")} on={isHeard(inClass)} set={(on) => prefer(hear(on, inClass))} />
      <Volume />
      <Check label={t("page-settings-audible")} on={audible} set={(on) => prefer({ audible: on })} />
      <Check label={t("page-settings-celebrate")} on={celebrate} set={(on) => prefer({ celebrate: on })} />
      {welcome && <p class="dim">{t("page-settings-about", { version: welcome.version, folder: welcome.folder })}</p>}
    </Dialog>
  );
}

function Volume() {
  return (
    <label class="field">
      {t("page-settings-volume")}
      <input
        type="range"
        min={0}
        max={100}
        step={10}
        value={preferences.value.volume}
        onInput={({ currentTarget }) => prefer({ volume: Number(currentTarget.value) })}
      />
    </label>
  );
}

function Check({ label, on, set }: { label: string; on: boolean; set: (on: boolean) => void }) {
  return (
    <label class="check">
      <input type="checkbox" checked={on} onChange={({ currentTarget }) => set(currentTarget.checked)} />
      {label}
    </label>
  );
}

export function ShortcutsDialog() {
  const { dialogs } = usePage();
  const ours = SHORTCUTS.map((one) => [keysOf(one), one.word] as const);
  const groups = Object.entries(OTHER_KEYS);
  return (
    <Dialog title={t("page-settings-shortcuts")} close={() => dialogs.close()} size="large">
      <div class="two-columns">
        <KeyTable title={t("page-settings-page")} keys={ours} />
        {groups.map(([word, keys]) => (
          <KeyTable key={word} title={t(word)} keys={keys} />
        ))}
      </div>
    </Dialog>
  );
}

function KeyTable({ title, keys }: { title: string; keys: readonly (readonly [string, string])[] }) {
  return (
    <table class="keys">
      <caption>{title}</caption>
      <tbody>
        {keys.map(([key, word]) => (
          <tr key={key}>
            <th scope="row">
              <kbd>{key}</kbd>
            </th>
            <td>{t(word)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
