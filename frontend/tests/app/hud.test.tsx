// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { render } from "@testing-library/preact";
import { expect, test } from "vitest";

import { Hud } from "../../src/app/world/hud";
import { type Page, PageProvider } from "../../src/model/page";

test("players are in the order of the halves in which two of them are followed", () => {
  const players = ["striker", "keeper"].map((name) => ({ name, score: 0 }));
  const running = { telemetry: signal({ game: { players } }) };
  const page = { context: { running, robotColor: () => null } } as unknown as Page;
  const { container } = render(
    <PageProvider value={page}>
      <Hud />
    </PageProvider>,
  );
  const names = [...container.querySelectorAll(".hud-name")].map(({ textContent }) => textContent);
  expect(names).toEqual(["keeper", "striker"]);
});
