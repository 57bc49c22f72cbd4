// @vitest-environment happy-dom

import { beforeEach, expect, test, vi } from "vitest";

import { compose } from "../../src/app/compose";
import type { Page } from "../../src/model/page";
import type { FakeConnection } from "../fake-connection";

vi.mock("../../src/protocol/connection", async () => {
  const { FakeConnection } = await import("../fake-connection");
  return { Connection: FakeConnection };
});

/** The browser of these tests has no database. */
vi.mock("../../src/model/drafts", () => ({
  BrowserDrafts: class {
    left = async () => [];
    keep() {}
    forget() {}
  },
}));

const OPENED = { kind: "Opened", name: "square", robot: "sim-ev3", world: "line", breakpoints: ["b2"] } as const;

let page: Page;
let connection: FakeConnection;

beforeEach(() => {
  history.replaceState(null, "", "/#project=square");
  page = compose();
  connection = page.context.connection as unknown as FakeConnection;
});

function sentKinds(): string[] {
  return connection.sent.map(({ kind }) => kind);
}

test("a new connection opens the project of the address, and says afterwards who reads", () => {
  connection.tell({ kind: "Welcome", robots: [], worlds: [] });
  expect(sentKinds()).toEqual(["Open", "Introduce"]);
});

test("an opened project forgets what belonged to the one before, and asks for its own", () => {
  connection.tell({ kind: "Welcome", robots: [], worlds: [], warns: true });
  page.keptRuns.runs.value = [];
  page.keptRuns.chosen.value = ["run"];
  page.lessons.failed.value = true;
  page.blockSets.ticked.value = {} as never;
  connection.sent.length = 0;
  connection.tell({ ...OPENED, tab: "b" });
  expect(page.project.name.value).toBe("square");
  expect(page.tabs.open.value).toBe("b");
  expect(page.context.running.world.value).toBe("line");
  expect([page.keptRuns.runs.value, page.keptRuns.chosen.value]).toEqual([null, []]);
  expect(page.lessons.failed.value).toBe(false);
  expect(page.blockSets.ticked.value).toBeNull();
  expect(sentKinds()).toEqual(["ListProjects", "ListCustomBlocks", "ReadContainment"]);
});

test("the program is the new one's before anything shows that project", () => {
  connection.tell({ kind: "Welcome", robots: [], worlds: [] });
  connection.tell(OPENED);
  connection.tell({ kind: "Document", edit: 0, revision: 1, origin: "python", python: "x = 1" });
  page.context.program.editedText("python", () => "x = 12");
  page.context.program.flush();
  const seen: boolean[] = [];
  page.project.name.subscribe(() => seen.push(page.context.program.saved.value));
  connection.tell({ ...OPENED, name: "dance" });
  expect(seen).toEqual([false, true]);
});

test("a part is reset once", () => {
  const reset = vi.spyOn(page.customBlocks, "list");
  connection.tell(OPENED);
  expect(reset).toHaveBeenCalledTimes(1);
});
