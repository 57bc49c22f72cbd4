import { describe, expect, it } from "vitest";

import { projectNameFault, renameFault, robotNameFault } from "../../src/model/project-name";
import type { ProjectEntry, Tab } from "../../src/protocol/messages";

describe("a name of a project", () => {
  it.each(["square", "my robot 2", "Ana_1", "ñandú", "v1.2"])("may be %s", (name) => {
    expect(projectNameFault(name)).toBe("");
  });

  it.each(["a/b", "../a", ".hidden", "ends with.", "_a", "a\\b", "é".repeat(51)])("can't be %s", (name) => {
    expect(projectNameFault(name)).not.toBe("");
  });
});

describe("another name of a project", () => {
  const known = [{ name: "Square" }, { name: "line" }] as unknown as ProjectEntry[];

  it.each(["circle", "LINE 2", "line"])("may be %s", (name) => {
    expect(renameFault(name, "line", known)).toBe("");
  });

  it.each(["Square", "square", "a/b"])("can't be %s", (name) => {
    expect(renameFault(name, "line", known)).not.toBe("");
  });

  it("is judged by its letters before the list of projects has come", () => {
    expect(renameFault("square", "line", null)).toBe("");
    expect(renameFault("a/b", "line", null)).not.toBe("");
  });
});

describe("another name of a robot", () => {
  const tabs = [{ name: "leader" }, { name: "follower" }] as unknown as Tab[];

  it.each(["scout", "leader", "x".repeat(40)])("may be %s", (name) => {
    expect(robotNameFault(name, "leader", tabs)).toBe("");
  });

  it.each(["follower", "a/b", "x".repeat(41)])("can't be %s", (name) => {
    expect(robotNameFault(name, "leader", tabs)).not.toBe("");
  });
});
