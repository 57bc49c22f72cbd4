// @vitest-environment happy-dom
/** A page to take home says who made it only if that is wished. */

import { signal } from "@preact/signals";
import { fireEvent, screen } from "@testing-library/preact";
import { expect, test, vi } from "vitest";

import { ShareDialog } from "../../src/features/share/dialog";
import { button, open, write } from "../dialog";

function shared() {
  const exportRun = vi.fn();
  open(ShareDialog, (connection) => ({
    classNews: { now: signal(null) },
    context: {
      connection: connection.real,
      program: { flush: () => {} },
      running: { active: signal(false), robot: signal("sim-ebo"), world: signal("empty") },
    },
    project: { name: signal("Square"), robotTitle: () => "EBO", worldTitle: () => "Empty floor" },
    views: { world: signal(null) },
    share: { isFilming: signal(false), exportRun },
  }));
  return exportRun;
}

const save = () => fireEvent.click(button(/^Page to take home/));

test("without a wish it says nothing of the pupil, and no name is asked for", () => {
  const exportRun = shared();
  expect(screen.queryByLabelText("Name")).toBeNull();
  save();
  expect(exportRun.mock.calls).toEqual([[""]]);
});

test("it says the name that the pupil writes", () => {
  const exportRun = shared();
  fireEvent.click(screen.getByLabelText("Show my name"));
  write(screen.getByLabelText("Name"), " Ada ");
  save();
  expect(exportRun.mock.calls).toEqual([["Ada"]]);
});
