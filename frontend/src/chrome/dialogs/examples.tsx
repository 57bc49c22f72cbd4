import { t, translated } from "../../i18n";
import type { ExampleChoice } from "../../messages";
import { Dialog } from "../widgets/dialog";
import { usePage } from "../page";

/** The examples, each opened as a new project of the user's own. */
export function ExamplesDialog() {
  const { dialogs, project } = usePage();
  const examples = project.welcome.value?.examples ?? [];
  return (
    <Dialog title={t("project.examplesTitle")} close={() => dialogs.close()} size="large">
      <p class="dim">{t("project.examplesHelp")}</p>
      <ul class="gallery">
        {examples.map((example) => (
          <Card key={example.name} example={example} />
        ))}
      </ul>
    </Dialog>
  );
}

function Card({ example: { name, title, description, robot, world } }: { example: ExampleChoice }) {
  const { dialogs, project } = usePage();
  const open = () => {
    dialogs.close();
    project.create(name, name);
  };
  return (
    <li>
      <button type="button" class="card" onClick={open}>
        <strong>{translated(`catalog.example_${name}`, title)}</strong>
        <span>{translated(`catalog.exampleText_${name}`, description)}</span>
        <span class="dim">{t("project.onIn", { robot: project.robotTitle(robot), world: project.worldTitle(world) })}</span>
      </button>
    </li>
  );
}
