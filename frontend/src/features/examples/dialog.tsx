import { t, translated } from "../../i18n";
import { usePage } from "../../model/page";
import type { ExampleChoice } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";

/** The examples; opening one creates a new project. */
export function ExamplesDialog() {
  const { dialogs, project } = usePage();
  const examples = project.welcome.value?.examples ?? [];
  return (
    <Dialog title={t("page-project-examples-title")} close={() => dialogs.close()} size="large">
      <p class="dim">{t("page-project-examples-help")}</p>
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
        <strong>{translated(`page-catalog-example-${name}`, title)}</strong>
        <span>{translated(`page-catalog-example-text-${name}`, description)}</span>
        <span class="dim">
          {t("page-project-on-in", { robot: project.robotTitle(robot), world: project.worldTitle(world) })}
        </span>
      </button>
    </li>
  );
}
