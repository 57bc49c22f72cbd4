import { describe, expect, it } from "vitest";

import { projectNameFault } from "../../src/model/project-name";

describe("a name of a project", () => {
  it.each(["square", "my robot 2", "Ana_1", "ñandú", "v1.2"])("may be %s", (name) => {
    expect(projectNameFault(name)).toBe("");
  });

  it.each(["a/b", "../a", ".hidden", "ends with.", "_a", "a\\b", "é".repeat(51)])("can't be %s", (name) => {
    expect(projectNameFault(name)).not.toBe("");
  });
});
