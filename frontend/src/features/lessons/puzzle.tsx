/** A Parsons puzzle: pieces of a program to be put in order, by mouse, keyboard or touch. */

import { useSignal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { LessonPuzzle, Workspace } from "../../protocol/messages";
import { Icon, type IconName } from "../../ui/icons";
import { draggable } from "./dragging";
import { DrawnBlocks } from "./drawn-blocks";
import { depths } from "./nesting";
import { Judged } from "./quiz";

interface Props {
  readonly puzzle: LessonPuzzle;
  readonly drawings: Readonly<Record<string, Workspace>>;
}

type Put = (order: readonly number[], focus: string) => void;

export function Puzzle({ puzzle: { pieces, solved = false }, drawings }: Props) {
  const { lessons } = usePage();
  const order = useSignal<readonly number[]>([]);
  const root = useRef<HTMLDivElement>(null);
  const focus = useRef("");
  const judged = lessons.puzzle.value;
  // At once: later it would take the focus back from what is used next.
  useLayoutEffect(() => {
    // A piece that was moved takes the focus with it.
    if (focus.current) root.current?.querySelector<HTMLElement>(focus.current)?.focus();
    focus.current = "";
  }, [order.value]);
  const put: Put = (next, selector) => {
    lessons.puzzle.value = null;
    focus.current = selector;
    order.value = next;
  };
  useEffect(() => {
    if (!root.current) return;
    return draggable(root.current, (piece, at) => {
      const others = order.value.filter((one) => one !== piece);
      if (at === null && others.length === order.value.length) return;
      const next = at === null ? others : others.toSpliced(at, 0, piece);
      put(next, `[data-piece="${piece}"] button:not([disabled])`);
    });
  }, []);
  const parts = { pieces, drawings, order: order.value, put };
  return (
    <div class="lesson-puzzle" ref={root}>
      <h3>{t("page-lesson-puzzle")}</h3>
      <p class="dim">{t("page-lesson-puzzle-help")}</p>
      <Pieces {...parts} />
      <Order {...parts} good={judged && !judged.right ? (judged.good ?? 0) : pieces.length} />
      <div class="lesson-answer">
        <button
          type="button"
          class="button bordered"
          disabled={order.value.length === 0}
          onClick={() => lessons.answerPuzzle(order.value)}
        >
          {t("page-lesson-answer")}
        </button>
        <Judged right={judged ? (judged.right ?? false) : solved ? true : null} />
      </div>
      {judged && !judged.right && <p>{t("page-lesson-puzzle-good", { count: judged.good ?? 0 })}</p>}
    </div>
  );
}

interface PartsProps {
  readonly pieces: readonly string[];
  readonly drawings: Props["drawings"];
  /** The indices of the pieces in the program. */
  readonly order: readonly number[];
  readonly put: Put;
}

/** The pieces that are not in the program. */
function Pieces({ pieces, drawings, order, put }: PartsProps) {
  const left = pieces.map((text, piece) => ({ text, piece })).filter(({ piece }) => !order.includes(piece));
  return (
    <ul class="lesson-pieces" aria-label={t("page-lesson-pieces")}>
      {left.map(({ text, piece }) => (
        <li key={piece} data-piece={piece}>
          <button
            type="button"
            class="lesson-piece"
            onClick={() => put([...order, piece], `[data-piece="${piece}"] button:not([disabled])`)}
          >
            <span class="hidden">{t("page-lesson-piece-add")} </span>
            <Shown text={text} drawings={drawings} />
          </button>
        </li>
      ))}
    </ul>
  );
}

function Order({ pieces, drawings, order, put, good }: PartsProps & { readonly good: number }) {
  const move = (at: number, by: number) => {
    const next = [...order];
    const [piece = 0] = next.splice(at, 1);
    next.splice(at + by, 0, piece);
    const isLast = at + by === 0 || at + by === order.length - 1;
    put(next, `[data-piece="${piece}"] ${isLast ? "button:not([disabled])" : `[data-by="${by}"]`}`);
  };
  const depth = depths(order.map((piece) => pieces[piece] ?? ""));
  return (
    <ol class="lesson-order" aria-label={t("page-lesson-order")}>
      {order.map((piece, at) => (
        <li
          key={piece}
          data-piece={piece}
          class={at >= good ? "unsure" : ""}
          style={{ "--depth": String(depth[at] ?? 0) }}
        >
          <span class="lesson-piece">
            <Shown text={pieces[piece] ?? ""} drawings={drawings} />
          </span>
          <Tool icon="up" word="page-lesson-piece-up" by={-1} off={at === 0} onClick={() => move(at, -1)} />
          <Tool
            icon="down"
            word="page-lesson-piece-down"
            by={1}
            off={at === order.length - 1}
            onClick={() => move(at, 1)}
          />
          <Tool
            icon="close"
            word="page-lesson-piece-remove"
            onClick={() =>
              put(
                order.filter((one) => one !== piece),
                `[data-piece="${piece}"] button`,
              )
            }
          />
        </li>
      ))}
    </ol>
  );
}

function Shown({ text, drawings }: { text: string; drawings: Props["drawings"] }) {
  const drawing = drawings[text];
  if (text === "else:") return <span class="lesson-else">{t("page-lesson-piece-else")}</span>;
  if (!drawing) return <code>{text}</code>;
  return (
    <>
      {text.startsWith("elif ") && <span class="lesson-else">{t("page-lesson-piece-else")}</span>}
      <DrawnBlocks workspace={drawing} text={text} />
    </>
  );
}

interface ToolProps {
  readonly icon: IconName;
  readonly word: string;
  readonly by?: number;
  readonly off?: boolean;
  readonly onClick: () => void;
}

function Tool({ icon, word, by, off = false, onClick }: ToolProps) {
  return (
    <button
      type="button"
      class="button"
      data-by={by}
      disabled={off}
      aria-label={t(word)}
      title={t(word)}
      onClick={onClick}
    >
      <Icon name={icon} />
    </button>
  );
}
