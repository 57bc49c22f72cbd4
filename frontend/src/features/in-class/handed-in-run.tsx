/** The run that the pupil handed in, as the teacher has seen it: the page's world in a frame. */

import { useEffect, useRef } from "preact/hooks";

import { language, t } from "../../i18n";
import { usePage } from "../../model/page";
import type { OwnHandIn } from "../../protocol/classroom";
import { Dialog } from "../../ui/dialog";
import type { ShowLine } from "./noted-line";
import "./handed-in-run.css";

export function RunThatWasHandedIn({ handIn }: { handIn: OwnHandIn }) {
  const { handIns, context } = usePage();
  const frame = useRef<HTMLIFrameElement>(null);
  const { lesson, step, at } = handIn;
  const isShown = handIns.run.value === handIn;
  const close = () => (handIns.run.value = null);
  useEffect(() => {
    const listen = ({ source, data }: MessageEvent<Partial<ShowLine> | null>) => {
      if (!source || source !== frame.current?.contentWindow) return;
      const line = Number(data?.showLine) || 0;
      const place = context.program.state.peek().places.find(([, number]) => number === line);
      close();
      if (place) context.reveal(place[0]);
    };
    addEventListener("message", listen);
    return () => {
      removeEventListener("message", listen);
      close();
    };
  }, []);
  if (!isShown) return null;
  const query = new URLSearchParams({ lesson, step: String(step) });
  return (
    <Dialog title={t("page-handins-own-run")} size="whole" close={close}>
      <iframe
        ref={frame}
        class="handed-in-run"
        key={`${at} ${language.value}`}
        src={`${runsPath(location.pathname)}?${query}`}
        title={t("page-handins-own-run")}
      />
    </Dialog>
  );
}

/** From the path of the pupil's page, which ends in the pupil's id. */
export function runsPath(path: string): string {
  return path.replace(/p\/([^/]+)\/[^/]*$/, "p/hand-in-$1/");
}
