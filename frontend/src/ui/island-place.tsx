/** The element that contains an island. */

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import type { Island } from "./island";
import { PartFailed } from "./loaded-later";

interface Resizable extends Island {
  resize?(): void;
}

interface Props<Kind extends Resizable> {
  /** Creates it, after loading its code if necessary. */
  readonly load: () => Promise<Kind>;
  /** Called with the island when it is ready, and with null when it is removed. */
  readonly ready?: (island: Kind | null) => void;
}

/** An island lives as long as this element; later values of `load` and `ready` are ignored. */
export function IslandPlace<Kind extends Resizable>({ load, ready }: Props<Kind>) {
  const place = useRef<HTMLDivElement>(null);
  const failed = useSignal(false);
  useEffect(() => {
    const host = place.current;
    if (!host) return;
    const settled = settle(host, load, ready);
    settled.made.catch((reason: unknown) => {
      failed.value = true;
      console.error(reason);
    });
    return settled.leave;
  }, []);
  return (
    <>
      {failed.value && <PartFailed />}
      <div class="island" ref={place} />
    </>
  );
}

/** Create an island and report changes of its size to it. */
function settle<Kind extends Resizable>(
  host: HTMLElement,
  load: () => Promise<Kind>,
  ready?: (island: Kind | null) => void,
) {
  let island: Kind | null = null;
  let left = false;
  const observer = new ResizeObserver(() => island?.resize?.());
  const made = load().then((loaded) => {
    if (left) return loaded.destroy();
    island = loaded;
    host.append(loaded.dom);
    observer.observe(host);
    ready?.(loaded);
  });
  const leave = () => {
    left = true;
    observer.disconnect();
    ready?.(null);
    island?.destroy();
    island?.dom.remove();
  };
  return { made, leave };
}
