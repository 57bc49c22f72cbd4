/** Parts of sentences that only state defaults, such as a speed: hidden behind "…" until a value differs. */

import * as Blockly from "blockly/core";

import { t } from "../../i18n";

type Block = Blockly.BlockSvg;
type Values = Readonly<Record<string, unknown>>;

const SIZE = 20;
const DOTS = [4, 8, 12].map((x) => `<circle cx="${x}" cy="8" r="1.4" fill="#1a2138"/>`).join("");
const PICTURE =
  `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 16">` +
  `<circle cx="8" cy="8" r="7.5" fill="white" fill-opacity=".9"/>${DOTS}</svg>`;

interface Options extends Blockly.FieldConfig {
  /** The usual values of the part's parameters, by name. */
  readonly usual: Values;
  /** The input after the part's last words. */
  readonly end: string;
}

/** The button that shows the part after it. */
class FieldMore extends Blockly.FieldImage {
  override readonly SERIALIZABLE = false;
  /** A part that was shown once stays, also if its value becomes the usual one while it is typed. */
  private opened = false;

  constructor(private readonly part: Options) {
    super(`data:image/svg+xml,${encodeURIComponent(PICTURE)}`, SIZE, SIZE, "", (field) => (field as FieldMore).open());
  }

  static override fromJson(json: Blockly.FieldConfig): FieldMore {
    return new FieldMore(json as Options);
  }

  override getAriaValue(): string {
    return t("page-blocks-more-values");
  }

  private open(): void {
    this.opened = true;
    (this.getSourceBlock() as Block | null)?.queueRender();
  }

  /** Show or hide the part. */
  arrange(block: Block): void {
    const { usual, end } = this.part;
    this.opened ||= Object.entries(usual).some(([name, value]) => !shows(block, name, value));
    for (const name of [...Object.keys(usual), end]) block.getInput(name)?.setVisible(this.opened);
    this.setVisible(!this.opened);
  }
}

/** Whether a parameter shows this value; another block in its place never does. A block is measured before it has its shadows. */
function shows(block: Block, name: string, value: unknown): boolean {
  const target = block.getInputTargetBlock(name);
  if (!target) return true;
  const field = ["NUM", "TEXT", "BOOL"].map((one) => target.getField(one)).find(Boolean);
  const spelled = typeof value === "boolean" ? String(value).toUpperCase() : value;
  return target.isShadow() && field?.getValue() === spelled;
}

/** Arrange the optional parts of a block; call it before the block is measured. */
export function arrangeOptional(block: Block): void {
  if (block.isCollapsed()) return;
  for (const field of block.getFields()) if (field instanceof FieldMore) field.arrange(block);
}

/** Call it once. */
export function registerOptional(): void {
  Blockly.fieldRegistry.register("lb_more", FieldMore);
}
