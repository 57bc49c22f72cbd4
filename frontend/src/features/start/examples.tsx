/** The first programs and the examples as cards: a few, and all once the user asks for them. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { preferences } from "../../model/preferences";
import type { ExampleChoice } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { pictureOf } from "../examples/pictures";
import { exampleText, exampleTitle, plainTitle } from "../examples/words";

type Stage = NonNullable<ExampleChoice["stage"]>;

const STAGES: readonly Stage[] = ["starter", "explorer", "coder"];

/** The number of cards before the user asks for more. */
const FEW = 4;

export function Examples() {
  const { project } = usePage();
  const open = useSignal(false);
  const stage = useSignal<Stage>(preferences.value.stage);
  const all = project.welcome.value?.examples ?? [];
  const shown = all.filter((one) => (one.stage ?? "starter") === stage.value);
  const simplestFirst = [...shown.filter((one) => one.is_first), ...shown.filter((one) => !one.is_first)];
  return (
    <section id="examples" class="start-examples" aria-labelledby="start-examples" data-region="examples" tabIndex={-1}>
      <div class="start-head">
        <h2 id="start-examples">{t("page-start-examples-title")}</h2>
        <p class="dim start-hint">{t("page-start-examples-help")}</p>
        <button
          type="button"
          class="more-link start-all"
          aria-expanded={open.value}
          aria-controls="example-cards"
          onClick={() => (open.value = !open.value)}
        >
          {t("page-start-all-examples")}
          <Icon name={open.value ? "up" : "down"} />
        </button>
      </div>
      <div id="example-cards">
        {open.value && (
          <div class="start-stages" role="group" aria-label={t("page-start-stage")}>
            {STAGES.map((one) => (
              <button
                key={one}
                type="button"
                class="start-chip"
                aria-pressed={one === stage.value}
                onClick={() => (stage.value = one)}
              >
                {t(`page-start-stage-${one}`)}
              </button>
            ))}
          </div>
        )}
        <ul class="start-cards">
          {(open.value ? simplestFirst : simplestFirst.slice(0, FEW)).map((one) => (
            <Card key={one.name} example={one} />
          ))}
        </ul>
      </div>
    </section>
  );
}

function Card({ example }: { example: ExampleChoice }) {
  const { project } = usePage();
  const picture = pictureOf(example.name);
  return (
    <li>
      <button
        type="button"
        class="start-example"
        title={exampleText(example)}
        onClick={() => project.openExample(plainTitle(example), example.name)}
      >
        {picture ? <img src={picture} alt="" width={480} height={270} loading="lazy" /> : <span class="start-blank" />}
        <span class="start-words">
          <strong>{exampleTitle(example)}</strong>
          <span class="dim">{exampleText(example)}</span>
        </span>
      </button>
    </li>
  );
}
