/** What the user sees of the world, and what they can do in it. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { arrange, preferences } from "../../model/preferences";
import type { PlayerView } from "../../model/views";
import { Menu, type MenuItem } from "../../ui/menu";
import type { Tool } from "../../ui/tool";

/** The tools by their groups in the menu; of the cameras, one is on. */
const CAMERAS = ["orbit", "top", "eye"];
const ZOOMS = ["nearer", "farther", "whole"];
const SHOWN = ["trail", "beams"];
const ROBOT = ["why", "place", "where"];
const TOUCHES = ["shake", "front", "back", "left", "right"];

export function EyeMenu() {
  const world = usePage().views.world.value;
  const tools = world?.tools ?? [];
  const players = world?.playerViews.value ?? [];
  const { camera, drive } = preferences.value.layout;
  const items = (names: readonly string[]) => tools.filter(({ name }) => names.includes(name)).map(itemOf);
  const panes: readonly MenuItem[] = [
    { text: t("page-shell-camera"), icon: "camera", on: camera, run: () => arrange({ camera: !camera }) },
    { text: t("page-shell-drive"), icon: "drive", on: drive, run: () => arrange({ drive: !drive }) },
  ];
  const follow = items(["follow"]).map(asChoice);
  const follows = players.length > 0 ? players.map(itemOfPlayers) : follow;
  // Only some robots feel it.
  const felt = tools.some(({ name, enabled }) => name === "shake" && enabled?.value);
  const groups = [
    { title: t("page-world-toolbar"), items: [...follows, ...items(CAMERAS).map(asChoice)] },
    { items: items(ZOOMS) },
    { title: t("page-world-shown"), items: [...items(SHOWN), ...panes] },
    { title: t("page-bar-robot"), items: items(ROBOT) },
    { title: t("page-world-hand"), items: felt ? items(TOUCHES) : [] },
  ];
  return <Menu label={t("page-world-eye")} icon="eye" groups={groups} look="raised" side="right" />;
}

function itemOf({ name, key, pressed, enabled, act }: Tool): MenuItem {
  return {
    text: t(`page-world-tool-${name}`),
    icon: name,
    key: key.toUpperCase(),
    on: pressed?.value,
    off: enabled && !enabled.value,
    run: act,
  };
}

/** Which of several robots to follow, instead of the choice that follows the robot. */
function itemOfPlayers({ kind, text, on, choose }: PlayerView): MenuItem {
  return { text, icon: kind === "split" ? "split" : "follow", checked: on, run: choose };
}

function asChoice({ on, ...item }: MenuItem): MenuItem {
  return { ...item, checked: on };
}
