// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { screen } from "@testing-library/preact";
import { expect, test } from "vitest";

import { Robots } from "../../src/features/start/robots";
import type { RobotChoice } from "../../src/protocol/messages";
import { open } from "../dialog";

function show(robots: readonly RobotChoice[]) {
  open(Robots, () => ({
    project: { welcome: signal({ robots }) },
    connect: { used: signal(null) },
  }));
  return screen.queryAllByRole("radio").map((one) => one.closest("label")!.textContent);
}

test("the start page offers each twin of LearnBlock's, and neither a user's nor a real robot", () => {
  const shown = show([
    { name: "sim-ebo", title: "EBO", simulated: true, ours: true },
    { name: "sim-beetle", title: "Beetle", simulated: true, ours: true },
    { name: "mine", title: "Mine", simulated: true },
    { name: "ebo", title: "EBO", simulated: false, ours: true },
  ]);
  expect(shown).toEqual(["EBO", "Beetle"]);
});
