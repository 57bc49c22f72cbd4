/** Marks on blocks: problems, breakpoints, the running block, and the one that a teacher's note is about. */

import * as Blockly from "blockly/core";
import { say } from "../../i18n";

import type { Problem } from "../../protocol/messages";
import { BreakpointIcon } from "./breakpoint-icon";
import { takeFromIcon } from "./focus";
import { ValueLabels } from "./value-labels";

type Svg = Blockly.BlockSvg;
type Severity = Problem["severity"];

const WARNING_ID = "learnblock";
/** The characters in a line of a note, which must fit beside its block on a narrow page. */
const LINE = 45;
/** Such a block is drawn as inactive; an icon would move its content while a user puts it into place. */
const LOOSE = "loose-block";
const CLASSES: Record<Severity, string> = { error: "lbError", warning: "lbWarning" };

interface Program {
  toggleBreakpoint(block: string): void;
  /** The id of the placeholder that hides a block; null for a block that is drawn. */
  placeholderOf(block: string): string | null;
}

interface Finding {
  readonly severity: Severity;
  readonly text: string;
}

/** Marks on the blocks of a workspace; set them again after blocks have been replaced. */
export class Marks {
  private problems = new Map<Svg, Finding>();
  private stops = new Set<Svg>();
  private running: Svg | null = null;
  private noted: Svg | null = null;
  private readonly labels: ValueLabels;

  constructor(
    private readonly workspace: Blockly.WorkspaceSvg,
    private readonly program: Program,
  ) {
    this.labels = new ValueLabels((id) => this.workspace.getBlockById(id));
  }

  /** Show values beside blocks, by the ids of the blocks. */
  showValues(texts: ReadonlyMap<string, string>): void {
    this.labels.show(texts);
  }

  showProblems(problems: readonly Problem[]): void {
    const findings = new Map<Svg, Finding>();
    for (const [id, finding] of collect(problems)) {
      const block = this.find(id);
      if (block && (block.id === id || !findings.has(block))) findings.set(block, finding);
    }
    for (const [block, finding] of this.problems) {
      if (findings.get(block)?.text !== finding.text && !block.isDisposed()) unmark(block);
    }
    for (const [block, finding] of findings) {
      if (this.problems.get(block)?.text !== finding.text) mark(block, finding);
    }
    this.problems = findings;
  }

  showBreakpoints(ids: Iterable<string>): void {
    const blocks = new Set(this.onBlocks(new Map([...ids].map((id) => [id, true]))).keys());
    for (const block of this.stops) {
      if (!blocks.has(block) && !block.isDisposed()) removeStop(block);
    }
    for (const block of blocks) {
      if (!this.stops.has(block))
        block.addIcon(new BreakpointIcon(block, () => this.program.toggleBreakpoint(block.id)));
    }
    this.stops = blocks;
  }

  /** Mark the running block, or none; return the block that shows the mark. */
  showRunning(id: string | null): Svg | null {
    this.running = this.moved(id, this.running, "lbRunning");
    return this.running;
  }

  /** Mark the block that a teacher's note is about, or none. */
  showNoted(id: string | null): void {
    this.noted = this.moved(id, this.noted, "lbNoted");
  }

  /** Move a mark to another block; return the block that shows it. */
  private moved(id: string | null, before: Svg | null, look: string): Svg | null {
    const block = id === null ? null : visible(this.find(id));
    if (block === before) return block;
    if (before && !before.isDisposed()) before.removeClass(look);
    block?.addClass(look);
    return block;
  }

  /** A block, or its placeholder if it is not drawn. */
  private find(id: string): Svg | null {
    return this.workspace.getBlockById(id) ?? this.workspace.getBlockById(this.program.placeholderOf(id) ?? "");
  }

  private onBlocks<T>(byId: ReadonlyMap<string, T>): Map<Svg, T> {
    const found = new Map<Svg, T>();
    for (const [id, value] of byId) {
      const block = this.workspace.getBlockById(id);
      if (block) found.set(block, value);
    }
    return found;
  }
}

function collect(problems: readonly Problem[]): Map<string, Finding> {
  const found = new Map<string, Finding>();
  for (const { block, code, message, in_blocks, severity } of problems) {
    if (!block || code === LOOSE) continue;
    const known = found.get(block);
    const text = say(in_blocks ?? message);
    found.set(block, known ? join(known, text, severity) : { severity, text });
  }
  return found;
}

function join(known: Finding, message: string, severity: Severity): Finding {
  // The server reports a problem once for each text.
  const lines = known.text.split("\n");
  const text = lines.includes(message) ? known.text : `${known.text}\n${message}`;
  return { text, severity: known.severity === "error" ? "error" : severity };
}

function mark(block: Svg, { text, severity }: Finding): void {
  block.setWarningText(Blockly.utils.string.wrap(text, LINE), WARNING_ID);
  block.removeClass(CLASSES[severity === "error" ? "warning" : "error"]);
  block.addClass(CLASSES[severity]);
}

function removeStop(block: Svg): void {
  takeFromIcon(block, BreakpointIcon.TYPE);
  block.removeIcon(BreakpointIcon.TYPE);
}

function unmark(block: Svg): void {
  takeFromIcon(block, Blockly.icons.WarningIcon.TYPE);
  block.setWarningText(null, WARNING_ID);
  for (const name of Object.values(CLASSES)) block.removeClass(name);
}

/** The block itself, or the outermost folded block that contains it. */
export function visible(block: Svg | null): Svg | null {
  let shown = block;
  for (let outer = block; outer; outer = outer.getSurroundParent()) if (outer.isCollapsed()) shown = outer;
  return shown;
}
