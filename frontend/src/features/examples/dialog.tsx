import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { ExampleChoice } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";
import { pictureOf } from "./pictures";
import { exampleText, exampleTitle, plainTitle } from "./words";
import "./dialog.css";

/** The examples and first programs; opening one creates a new project. */
export function ExamplesDialog() {
  const { dialogs, project } = usePage();
  const examples = project.welcome.value?.examples ?? [];
  return (
    <Dialog title={t("page-project-examples-title")} close={() => dialogs.close()} size="large">
      <p class="dim">{t("page-project-examples-help")}</p>
      <h3>{t("page-project-games")}</h3>
      <p class="dim">{t("page-project-games-help")}</p>
      <Gallery examples={examples.filter((one) => one.is_game)} />
      <h3>{t("page-project-programs")}</h3>
      <Gallery examples={examples.filter((one) => !one.is_first && !one.is_game)} />
      <h3>{t("page-project-first-programs")}</h3>
      <Gallery examples={examples.filter((one) => one.is_first)} />
    </Dialog>
  );
}

function Gallery({ examples }: { examples: readonly ExampleChoice[] }) {
  return (
    <ul class="gallery">
      {examples.map((example) => (
        <Card key={example.name} example={example} />
      ))}
    </ul>
  );
}

function Card({ example }: { example: ExampleChoice }) {
  const { dialogs, project } = usePage();
  const { name, robot, world } = example;
  const open = () => {
    dialogs.close();
    project.create(plainTitle(example), name);
  };
  const titles = (kinds: string) =>
    kinds
      .split(", ")
      .map((kind) => project.robotTitle(kind))
      .join(", ");
  const picture = pictureOf(name);
  return (
    <li>
      <button type="button" class="card" onClick={open}>
        {picture && <img class="card-picture" src={picture} alt="" width={480} height={270} loading="lazy" />}
        <strong>{exampleTitle(example)}</strong>
        <span>{exampleText(example)}</span>
        <span class="dim">{t("page-project-on-in", { robot: titles(robot), world: project.worldTitle(world) })}</span>
      </button>
    </li>
  );
}
