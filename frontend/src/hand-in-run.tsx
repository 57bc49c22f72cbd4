/** The entry point of the run beside a hand-in: the page's world, timeline and "why", without the rest. */

import { render } from "preact";

import { begin } from "./app/begin";
import { compose } from "./app/compose";
import { HandInRunPage } from "./app/hand-in-run-page";
import { revealAround, runHandIn } from "./features/hand-ins/run";
import { NO_DRAFTS } from "./model/drafts";
import { PageProvider } from "./model/page";

async function show(root: HTMLElement): Promise<void> {
  const page = compose({ drafts: NO_DRAFTS, query: location.search });
  runHandIn(page);
  revealAround(page);
  page.context.connection.open();
  await begin();
  render(
    <PageProvider value={page}>
      <HandInRunPage />
    </PageProvider>,
    root,
  );
}

void show(document.getElementById("page")!);
