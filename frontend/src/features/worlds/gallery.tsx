/** All worlds to choose from, by their pictures: the user's own first, then by what one does there. */

import { useSignal } from "@preact/signals";
import { useId, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { RobotChoice, WorldChoice } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";
import { Icon, type IconName } from "../../ui/icons";
import { moveAmong } from "./arrows";
import { WorldCard } from "./card";
import { GROUPS, type Group, groupOf, searched } from "./guide";
import { OwnWorlds } from "./own";
import { remember } from "./recent";
import "./gallery.css";

/** How many worlds of a group are shown beside the other groups; the style sheet hides the last on a wide screen. */
const SAMPLE = 3;

/** The gallery of the project. */
export function WorldGalleryDialog() {
  const { context, controls, dialogs } = usePage();
  const use = (name: string) => {
    dialogs.close();
    remember(name);
    controls.chooseWorld(name);
  };
  return (
    <WorldGallery
      used={context.running.world.value}
      robot={context.running.robot.value}
      canEdit
      close={() => dialogs.close()}
      use={use}
    />
  );
}

interface Props {
  readonly used: string;
  /** The robot that is to drive there. */
  readonly robot: string;
  readonly canEdit: boolean;
  readonly close: () => void;
  readonly use: (name: string) => void;
}

export function WorldGallery({ used, robot: name, canEdit, close, use }: Props) {
  const { project } = usePage();
  const words = useSignal("");
  const group = useSignal<Group | null>(null);
  const content = useRef<HTMLDivElement>(null);
  const robot = project.welcome.value?.robots.find((one) => one.name === name);
  const shown = searched(project.worlds.value, words.value, robot, (world) => project.worldTitle(world));
  const isWhole = group.value === null && !words.value.trim();
  const own = shown.filter((one) => one.own);
  const canMake = canEdit && isWhole;
  const keys = (event: KeyboardEvent) => {
    const all = [...(content.current?.querySelectorAll<HTMLElement>("[data-world], .make-world") ?? [])];
    const cards = all.filter((card) => card.checkVisibility());
    const isFromSearch = event.key === "ArrowDown" && event.target instanceof HTMLInputElement;
    if (isFromSearch) cards[0]?.focus();
    else if (!moveAmong(cards, document.activeElement, event.key)) return;
    event.preventDefault();
  };
  return (
    <Dialog title={t("page-gallery-title")} close={close} size="worlds">
      {/* biome-ignore lint/a11y/noStaticElementInteractions: its buttons have the focus, which the arrow keys move */}
      <div class="world-gallery" ref={content} onKeyDown={keys}>
        <label class="world-search">
          <Icon name="find" />
          <input
            type="search"
            autofocus
            aria-label={t("page-gallery-search")}
            placeholder={t("page-gallery-search")}
            value={words.value}
            onInput={({ currentTarget }) => (words.value = currentTarget.value)}
          />
        </label>
        <Chips worlds={shown} chosen={group.value} choose={(one) => (group.value = one)} />
        <p class="hidden" role="status">
          {t("page-gallery-count", { count: shown.length })}
        </p>
        {group.value === null && (own.length > 0 || canMake) && (
          <OwnWorlds worlds={own} used={used} canEdit={canMake} use={use} />
        )}
        <div class={isWhole ? "world-groups" : "world-groups narrowed"}>
          {GROUPS.filter(([one]) => group.value === null || one === group.value).map(([one, icon]) => (
            <Section
              key={one}
              group={one}
              icon={icon}
              worlds={shown.filter((world) => !world.own && groupOf(world) === one)}
              most={isWhole ? SAMPLE : Number.POSITIVE_INFINITY}
              all={() => (group.value = one)}
              used={used}
              robot={robot}
              use={use}
            />
          ))}
        </div>
        {shown.length === 0 && <p>{t("page-gallery-none", { words: words.value.trim() })}</p>}
      </div>
    </Dialog>
  );
}

interface ChipsProps {
  readonly worlds: readonly WorldChoice[];
  readonly chosen: Group | null;
  readonly choose: (group: Group | null) => void;
}

function Chips({ worlds, chosen, choose }: ChipsProps) {
  const ours = worlds.filter((one) => !one.own);
  return (
    <div class="world-chips" role="group" aria-label={t("page-gallery-groups")}>
      <Chip text={t("page-gallery-all")} count={worlds.length} isOn={chosen === null} press={() => choose(null)} />
      {GROUPS.map(([group, icon]) => (
        <Chip
          key={group}
          icon={icon}
          text={t(`page-gallery-group-${group}`)}
          count={ours.filter((one) => groupOf(one) === group).length}
          isOn={chosen === group}
          press={() => choose(chosen === group ? null : group)}
        />
      ))}
    </div>
  );
}

interface ChipProps {
  readonly icon?: IconName;
  readonly text: string;
  readonly count: number;
  readonly isOn: boolean;
  readonly press: () => void;
}

function Chip({ icon, text, count, isOn, press }: ChipProps) {
  return (
    <button type="button" class="world-chip" aria-pressed={isOn} onClick={press}>
      {icon && <Icon name={icon} />}
      {text} <span>{count}</span>
    </button>
  );
}

interface SectionProps {
  readonly group: Group;
  readonly icon: IconName;
  readonly worlds: readonly WorldChoice[];
  readonly most: number;
  readonly all: () => void;
  readonly used: string;
  readonly robot: RobotChoice | undefined;
  readonly use: (name: string) => void;
}

function Section({ group, icon, worlds, most, all, used, robot, use }: SectionProps) {
  const title = useId();
  if (worlds.length === 0) return null;
  return (
    <section aria-labelledby={title}>
      <div class="world-group-head">
        <h3 id={title}>
          <Icon name={icon} />
          {t(`page-gallery-group-${group}`)}
        </h3>
        {worlds.length >= most && (
          <button type="button" class="more-link" onClick={all}>
            {t("page-gallery-all-of", { count: worlds.length })}
            <Icon name="next" />
          </button>
        )}
      </div>
      <ul class="world-cards">
        {worlds.slice(0, most).map((world) => (
          <li key={world.name}>
            <WorldCard world={world} isUsed={world.name === used} robot={robot} use={use} />
          </li>
        ))}
      </ul>
    </section>
  );
}
