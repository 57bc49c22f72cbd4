/** What the program says and asks while the output is closed: over the world, so that nothing moves. */

import { t } from "../../i18n";
import { type Page, usePage } from "../../model/page";
import { Icon } from "../../ui/icons";
import { IslandPlace } from "../../ui/island-place";

export function Said() {
  const page = usePage();
  const { context, views } = page;
  const { dialogue, past } = context.running;
  const { said, asked } = dialogue;
  if (views.shows("panel") || past.value) return null;
  if (asked.value !== null) {
    return (
      <div class="world-asked">
        <IslandPlace load={() => loadAsked(page)} />
      </div>
    );
  }
  return said.value ? <LastLine text={said.value} open={() => views.showPanel("console")} /> : null;
}

function LastLine({ text, open }: { text: string; open: () => void }) {
  return (
    <div class="world-said">
      <button type="button" class="chip asks" title={t("page-console-open")} onClick={open}>
        <Icon name="console" />
        <span>{text}</span>
      </button>
    </div>
  );
}

async function loadAsked({ context }: Page) {
  const { createAsked } = await import("../../views/output/asked");
  return createAsked(context);
}
