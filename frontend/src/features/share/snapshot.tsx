import { useEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { drawWorld, fillSky } from "./frame";

const WIDTH = 640;
const HEIGHT = 400;

/** The world as it is now. */
export function Snapshot() {
  const { context, project, views } = usePage();
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const brush = canvas.current?.getContext("2d");
    const world = views.world.peek();
    if (brush && world && drawWorld(world, brush)) fillSky(brush);
  }, []);
  const world = project.worldTitle(context.running.world.value);
  const where = t("page-project-on-in", { robot: project.robotTitle(context.running.robot.value), world });
  return (
    <figure class="share-snapshot">
      <canvas ref={canvas} width={WIDTH} height={HEIGHT} role="img" aria-label={where} />
      <figcaption>{where}</figcaption>
    </figure>
  );
}
