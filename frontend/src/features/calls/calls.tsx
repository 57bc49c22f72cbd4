/** What called what in the run, as a graph that one can walk through with the arrow keys. */

import { useSignal, useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { CallEdge, CallGraph } from "../../protocol/messages";
import { BOX, type Laid, type Place } from "./places";
import { type Span, SpanFields, useSpan } from "./span";
import "./calls.css";

/** The names of the columns, from the program to the robot's driver. */
export const LAYERS = [
  "calls-layer-program",
  "calls-layer-functions",
  "calls-layer-skills",
  "calls-layer-client",
  "calls-layer-devices",
  "calls-layer-driver",
] as const;
/** From this share of the time on a function has the strongest colour. */
const MUCH = 0.5;
const LEVELS = 4;
/** Milliseconds between two questions about a run that goes on. */
const PERIOD = 1000;
/** The longest name in a box, in characters. */
const LONGEST = 20;
/** The names of functions would be too small below this. */
const LEAST_SCALE = 0.7;
/** The room for the names of the columns, in pixels. */
const HEADING = 20;

export function Calls() {
  const { lookingBack } = usePage();
  const span = useSpan();
  const graph = useCalls(span);
  const panel = useRef<HTMLDivElement>(null);
  const laid = useLaid(graph, useWidth(panel, graph !== null));
  if (!graph) return <p class="calls-none">{t("page-calls-none")}</p>;
  return (
    <div class="calls-panel" ref={panel}>
      <SpanFields span={span} shown={graph.last} />
      {!graph.edges?.length && <p class="calls-none">{t("calls-none")}</p>}
      {laid?.graph.edges?.length && graph.edges?.length ? (
        <Picture graph={laid.graph} laid={laid} look={({ first, event }) => lookingBack.look(first, event)} />
      ) : null}
    </div>
  );
}

/** The graph with its layout, whose library is loaded when it is first needed. */
export function useLaid(graph: CallGraph | null, room = Infinity): (Laid & { graph: CallGraph }) | null {
  const laid = useSignal<(Laid & { graph: CallGraph }) | null>(null);
  useEffect(() => {
    let given = true;
    if (graph)
      void import("./layout").then(({ lay }) => {
        if (given) laid.value = { ...lay(graph, room), graph };
      });
    return () => {
      given = false;
    };
  }, [graph, laid, room]);
  return laid.value;
}

/** The width of an element that is on the page, in pixels. */
function useWidth(element: { readonly current: HTMLElement | null }, isShown: boolean): number {
  const width = useSignal(Infinity);
  useEffect(() => {
    if (!isShown || !element.current) return undefined;
    const sizes = new ResizeObserver(([entry]) => {
      // It has none while another tab is shown.
      if (entry?.contentRect.width) width.value = entry.contentRect.width;
    });
    sizes.observe(element.current);
    return () => sizes.disconnect();
  }, [element, isShown, width]);
  return width.value;
}

/** The calls of a span; without an end, up to the moment that is shown, or of the whole run. */
function useCalls(span: Span): CallGraph | null {
  const { context, views } = usePage();
  const { connection, running } = context;
  const graph = useSignal<CallGraph | null>(null);
  useEffect(() => connection.on("CallGraph", (news) => (graph.value = news)), [connection, graph]);
  useSignalEffect(() => {
    if (!views.showsPanel("calls")) return;
    const ask = () => {
      const first = span.first.value ?? 0;
      const last = span.last.value ?? running.past.value?.time ?? null;
      connection.send({ kind: "ReadCalls", first, last });
    };
    if (!running.active.value && !running.timeline.value?.end) {
      graph.value = null;
      return;
    }
    ask();
    if (!running.active.value || running.past.value) return;
    const timer = setInterval(ask, PERIOD);
    return () => clearInterval(timer);
  });
  return graph.value;
}

interface PictureProps {
  readonly graph: CallGraph;
  readonly laid: Laid;
  /** The functions to mark, by their index. */
  readonly marked?: ReadonlySet<number>;
  /** Shows where the first of some calls was made. */
  readonly look: (call: CallEdge) => void;
}

export function Picture({ graph, laid, marked, look }: PictureProps) {
  const chosen = useSignal(0);
  const root = useRef<SVGSVGElement>(null);
  const { functions = [], edges = [] } = graph;
  const choose = (index: number) => {
    chosen.value = index;
    root.current?.querySelector<SVGGElement>(`[data-function="${index}"]`)?.focus();
  };
  const lookAtFirst = (index: number) => {
    // Nothing calls the program: it begins where it calls something.
    const call = edges.find(({ callee }) => callee === index) ?? edges.find(({ caller }) => caller === index);
    if (call) look(call);
  };
  return (
    <div class="calls" data-selectable>
      <svg
        ref={root}
        style={{ inlineSize: `${laid.width}px`, minInlineSize: `${LEAST_SCALE * laid.width}px` }}
        viewBox={`0 ${-HEADING} ${laid.width} ${laid.height + HEADING}`}
        role="group"
        aria-label={t("page-calls-title", { robot: graph.robot })}
      >
        {laid.columns.map(({ layer, x, y, isRow }) => (
          <text key={layer} class={`call-layer ${isRow ? "row" : ""}`} x={x} y={y}>
            {t(LAYERS[layer] ?? LAYERS[0])}
          </text>
        ))}
        {edges.map((edge, index) => (
          <Line key={`${edge.caller} ${edge.callee}`} points={laid.lines[index] ?? []} edge={edge} />
        ))}
        {functions.map((one, index) => (
          <Box
            key={`${one.layer} ${one.name}`}
            graph={graph}
            index={index}
            place={laid.places[index] ?? { x: 0, y: 0 }}
            isApart={marked?.has(index) ?? false}
            isNext={index === Math.min(chosen.value, functions.length - 1)}
            look={() => lookAtFirst(index)}
            onFocus={() => (chosen.value = index)}
            onKeyDown={(event) => walk(event, laid, index, choose, lookAtFirst)}
          />
        ))}
      </svg>
    </div>
  );
}

interface BoxProps {
  readonly graph: CallGraph;
  readonly index: number;
  readonly place: Place;
  /** Whether only one of two runs has called it. */
  readonly isApart: boolean;
  /** Whether Tab leads to it. */
  readonly isNext: boolean;
  look(): void;
  onFocus(): void;
  onKeyDown(event: KeyboardEvent): void;
}

/** A function. */
function Box({ graph, index, place, isApart, isNext, look, onFocus, onKeyDown }: BoxProps) {
  const one = graph.functions?.[index];
  if (!one) return null;
  const top = place.y - BOX.height / 2;
  const label = described(graph, index);
  return (
    <>
      <g
        class={`call level-${levelOf(one.share)}${isApart ? " apart" : ""}`}
        transform={`translate(${place.x - BOX.width / 2} ${top})`}
        role="button"
        tabindex={isNext ? 0 : -1}
        data-function={index}
        aria-label={label}
        onClick={look}
        onFocus={onFocus}
        onKeyDown={onKeyDown}
      >
        <title>{label}</title>
        <rect width={BOX.width} height={BOX.height} rx={8} />
        <text x={BOX.width / 2} y={19} class="name">
          {shortened(one.name)}
        </text>
      </g>
      {/* Beside the button, whose label says it in words. */}
      <text x={place.x} y={top + 35} class="call-count">
        {t("page-calls-count", { count: one.count, seconds: one.seconds })}
      </text>
    </>
  );
}

function Line({ points, edge }: { points: readonly Place[]; edge: CallEdge }) {
  const [first, ...others] = points;
  if (!first) return null;
  const middle = points[Math.floor(points.length / 2)] ?? first;
  const way = others.map(({ x, y }) => `L${x} ${y}`).join(" ");
  return (
    <g class="call-line">
      <path d={`M${first.x} ${first.y} ${way}`} stroke-width={1.5 + 3 * edge.share} />
      <text x={middle.x} y={middle.y - 4}>
        {edge.count}×
      </text>
      <text x={middle.x} y={middle.y + 12}>
        {t("page-calls-share", { percent: Math.round(100 * edge.share) })}
      </text>
    </g>
  );
}

/** Go to the nearest function in the direction of an arrow key. */
function walk(
  event: KeyboardEvent,
  laid: Laid,
  index: number,
  choose: (index: number) => void,
  open: (index: number) => void,
): void {
  const [dx, dy] = DIRECTIONS[event.key] ?? [0, 0];
  if (event.key === "Enter" || event.key === " ") open(index);
  else if (dx || dy) {
    const next = nearest(laid.places, index, dx, dy);
    if (next !== undefined) choose(next);
  } else return;
  event.preventDefault();
}

const DIRECTIONS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

function nearest(places: readonly Place[], from: number, dx: number, dy: number): number | undefined {
  const here = places[from];
  if (!here) return undefined;
  const found = places
    .map(({ x, y }, index) => ({ index, along: (x - here.x) * dx + (y - here.y) * dy, x, y }))
    .filter(({ along }) => along > 1)
    .map((one) => ({ ...one, far: Math.hypot(one.x - here.x, one.y - here.y) + 2 * Math.abs((one.x - here.x) * dy) }))
    .sort((a, b) => a.far - b.far);
  return found[0]?.index;
}

function described({ functions = [], edges = [] }: CallGraph, index: number): string {
  const one = functions[index];
  if (!one) return "";
  const callers = edges.filter(({ callee }) => callee === index).map(({ caller }) => functions[caller]?.name ?? "");
  return t("page-calls-function", {
    layer: t(LAYERS[one.layer] ?? LAYERS[0]),
    name: one.name,
    count: one.count,
    seconds: one.seconds,
    callers: callers.length ? callers.join(", ") : "–",
  });
}

function levelOf(share: number): number {
  return Math.round(Math.min(1, share / MUCH) * LEVELS);
}

function shortened(name: string): string {
  return name.length <= LONGEST ? name : `${name.slice(0, LONGEST - 1)}…`;
}
