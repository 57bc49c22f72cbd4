/** The entry point of a guest's view: the world of the classmate who has invited the pupil. */

import { render } from "preact";

import { begin } from "./app/begin";
import { compose } from "./app/compose";
import { GuestPage } from "./app/guest-page";
import { NO_DRAFTS } from "./model/drafts";
import { PageProvider } from "./model/page";

async function show(root: HTMLElement): Promise<void> {
  const page = compose({ drafts: NO_DRAFTS, query: "" });
  page.askingWhy.isOff = true;
  page.context.connection.open();
  await begin();
  render(
    <PageProvider value={page}>
      <GuestPage />
    </PageProvider>,
    root,
  );
}

void show(document.getElementById("page")!);
