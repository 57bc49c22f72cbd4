/** A divider between two neighbours, moved by pointer or arrow keys. */

import { useRef } from "preact/hooks";

import "./splitter.css";

interface Props {
  readonly label: string;
  /** The direction of the divider. */
  readonly orientation: "vertical" | "horizontal";
  /** The relative sizes of the neighbours. */
  readonly sizes: readonly [number, number];
  readonly resize: (before: number, after: number) => void;
}

/** The smallest share of a neighbour. */
const SMALLEST = 0.12;
const KEY_STEP = 0.03;

export function Splitter({ label, orientation, sizes, resize }: Props) {
  /** The distance between pointer and divider at the start of a drag, as a share. */
  const grip = useRef(0);
  const whole = sizes[0] + sizes[1];
  const share = sizes[0] / whole;
  const move = (wish: number) => {
    const kept = Math.min(1 - SMALLEST, Math.max(SMALLEST, wish));
    resize(whole * kept, whole * (1 - kept));
  };
  return (
    <div
      class={`splitter ${orientation}`}
      role="separator"
      tabIndex={0}
      aria-label={label}
      aria-orientation={orientation}
      aria-valuenow={Math.round(share * 100)}
      aria-valuemin={SMALLEST * 100}
      aria-valuemax={(1 - SMALLEST) * 100}
      onKeyDown={(event) => {
        const wish = keyed(event.key, share);
        if (wish === undefined) return;
        event.preventDefault();
        move(wish);
      }}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        grip.current = share - pointed(event.currentTarget, event);
      }}
      onPointerMove={(event) => {
        const { currentTarget, pointerId } = event;
        if (currentTarget.hasPointerCapture(pointerId)) move(pointed(currentTarget, event) + grip.current);
      }}
    />
  );
}

function keyed(key: string, share: number): number | undefined {
  const wishes: Record<string, number> = {
    ArrowLeft: share - KEY_STEP,
    ArrowUp: share - KEY_STEP,
    ArrowRight: share + KEY_STEP,
    ArrowDown: share + KEY_STEP,
    Home: 0,
    End: 1,
  };
  return wishes[key];
}

/** The share of the first neighbour with the divider at the pointer. */
function pointed(bar: HTMLElement, event: PointerEvent): number {
  const before = bar.previousElementSibling?.getBoundingClientRect();
  const after = bar.nextElementSibling?.getBoundingClientRect();
  if (!before || !after) return 0.5;
  return bar.ariaOrientation === "vertical"
    ? (event.clientX - before.left) / (after.right - before.left)
    : (event.clientY - before.top) / (after.bottom - before.top);
}
