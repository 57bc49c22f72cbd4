/** A new project: robot, world and level in one step, preset as last time, so that Enter is enough. */

import { type Signal, useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";

import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import { chooseStage, prefer, preferences, STAGES, type Stage } from "../../model/preferences";
import type { Project } from "../../model/project";
import { projectNameFault } from "../../model/project-name";
import { LIMITS, type RobotChoice, type WorldChoice } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";
import { Icon } from "../../ui/icons";
import { RobotPicture } from "../../ui/robots/picture";
import { WorldPicture } from "../worlds/card";
import { WorldGallery } from "../worlds/gallery";
import { goalOf } from "../worlds/guide";
import { few, remember } from "../worlds/recent";
import "./new.css";

/** The world without anything in it. */
const EMPTY = "empty";

interface Draft {
  readonly robot: Signal<string>;
  readonly world: Signal<string>;
  readonly stage: Signal<Stage>;
  /** Null until the user has changed it: then it is that of the world. */
  readonly name: Signal<string | null>;
}

export function NewDialog() {
  const page = usePage();
  const { dialogs, project } = page;
  const { world } = preferences.value;
  const known = project.worlds.value.find(({ name }) => name === world)?.name;
  const draft: Draft = {
    robot: useSignal(chosenRobot(project)),
    world: useSignal(known ?? EMPTY),
    stage: useSignal(preferences.value.stage),
    name: useSignal<string | null>(null),
  };
  const isChoosing = useSignal(false);
  const close = () => (isChoosing.value = false);
  const use = (name: string) => {
    draft.world.value = name;
    remember(name);
    close();
  };
  if (isChoosing.value) {
    return <WorldGallery used={draft.world.value} robot={draft.robot.value} canEdit={false} close={close} use={use} />;
  }
  return (
    <Dialog title={t("page-project-new-title")} close={() => dialogs.close()} size="large">
      <NewProject draft={draft} chooseWorld={() => (isChoosing.value = true)} />
    </Dialog>
  );
}

function NewProject({ draft, chooseWorld }: { draft: Draft; chooseWorld: () => void }) {
  const page = usePage();
  const { robot, world, stage } = draft;
  const { project } = page;
  const worlds = project.worlds.value;
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    create(page, draft);
  };
  return (
    <form class="new-project" onSubmit={submit}>
      <Preview world={worlds.find(({ name }) => name === world.value)} robot={project.robotTitle(robot.value)} />
      <div class="new-choices">
        <p class="dim">{t(preferences.value.world ? "page-project-new-help-again" : "page-project-new-help")}</p>
        <Choices legend={t("page-bar-robot")} look="robots">
          {offered(project, robot.value).map(({ name }) => (
            <Choice key={name} group="new-robot" chosen={robot} value={name}>
              <RobotPicture robot={name} />
              {project.robotTitle(name)}
            </Choice>
          ))}
        </Choices>
        <button type="button" class="more-link new-all-worlds" onClick={chooseWorld}>
          {t("page-gallery-all-worlds", { count: worlds.length })}
          <Icon name="next" />
        </button>
        <Choices legend={t("page-bar-world")} look="worlds">
          {few(worlds, world.value).map((one) => (
            <Choice key={one.name} group="new-world" chosen={world} value={one.name}>
              <WorldPicture world={one} />
              {project.worldTitle(one.name)}
            </Choice>
          ))}
        </Choices>
        <Choices legend={t("page-bar-stage")} look="stages">
          {STAGES.map((one) => (
            <Choice key={one} group="new-stage" chosen={stage} value={one}>
              <strong>{t(`page-bar-stage-${one}`)}</strong>
              <span class="dim">{t(`page-project-new-${one}`)}</span>
            </Choice>
          ))}
        </Choices>
        <Start draft={draft} />
      </div>
    </form>
  );
}

/** The world that is chosen, large. */
function Preview({ world, robot }: { world: WorldChoice | undefined; robot: string }) {
  const { project } = usePage();
  if (!world) return null;
  return (
    <div class="new-preview" aria-hidden="true">
      <WorldPicture world={world} />
      <p>
        <span>{t("page-project-new-in", { robot })}</span>
        <strong>{project.worldTitle(world.name)}</strong>
        <span>{goalOf(world)}</span>
      </p>
    </div>
  );
}

function Choices({ legend, look, children }: { legend: string; look: string; children: ComponentChildren }) {
  return (
    <fieldset class={`new-group ${look}`}>
      <legend>{legend}</legend>
      <div>{children}</div>
    </fieldset>
  );
}

interface ChoiceProps<Value extends string> {
  readonly group: string;
  readonly chosen: Signal<Value>;
  readonly value: Value;
  readonly children: ComponentChildren;
}

function Choice<Value extends string>({ group, chosen, value, children }: ChoiceProps<Value>) {
  const isChosen = chosen.value === value;
  return (
    <label class="new-choice choice-card">
      <input
        type="radio"
        class="hidden"
        name={group}
        value={value}
        checked={isChosen}
        onChange={() => (chosen.value = value)}
      />
      {children}
      {isChosen && (
        <span class="choice-tick">
          <Icon name="check" />
        </span>
      )}
    </label>
  );
}

/** The name of the project, and the button that makes it. */
function Start({ draft }: { draft: Draft }) {
  const { project } = usePage();
  const about = useId();
  const wish = nameOf(project, draft);
  const fault = projectNameFault(wish.trim());
  return (
    <div class="new-start">
      <label class="field">
        {t("page-project-name")}
        <input
          type="text"
          required
          aria-describedby={about}
          aria-invalid={fault ? "true" : undefined}
          maxLength={LIMITS.New.name}
          value={wish}
          onFocus={({ currentTarget }) => currentTarget.select()}
          onInput={({ currentTarget }) => (draft.name.value = currentTarget.value)}
        />
      </label>
      <button type="submit" class="button filled" autofocus disabled={Boolean(fault)}>
        <Icon name="run" />
        {t("page-project-new-now")}
      </button>
      <p id={about} role="status" class={fault ? "refused" : "hidden"}>
        {wish.trim() && fault}
      </p>
    </div>
  );
}

function create({ dialogs, project }: Page, draft: Draft): void {
  const { robot, world, stage } = draft;
  const name = nameOf(project, draft).trim();
  prefer({ robot: robot.value, world: world.value });
  if (stage.value !== preferences.value.stage) chooseStage(stage.value);
  remember(world.value);
  dialogs.close();
  project.create(name, null, world.value);
}

/** The name of the world, if a project can have it; a number is added to one that is taken. */
function nameOf(project: Project, { name, world }: Draft): string {
  if (name.value !== null) return name.value;
  const title = project.worldTitle(world.value);
  return world.value === EMPTY || projectNameFault(title) ? t("page-project-new-name") : title;
}

/** The simulated robots, and the one that is chosen. */
function offered({ welcome }: Project, chosen: string): readonly RobotChoice[] {
  return (welcome.value?.robots ?? []).filter(({ name, simulated }) => simulated || name === chosen);
}

/** The user's robot; of one that is not known here, its twin, or the first one. */
function chosenRobot({ welcome }: Project): string {
  const robots = welcome.value?.robots ?? [];
  const { robot } = preferences.value;
  const known = [robot, `sim-${robot}`].find((name) => robots.some((one) => one.name === name));
  return known ?? robots.find(({ name }) => name.startsWith("sim-"))?.name ?? "";
}
