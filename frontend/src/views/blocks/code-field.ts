/** A field for a few lines of Python. */

import * as Blockly from "blockly/core";

const { Svg } = Blockly.utils;
const LINE_HEIGHT = 18;
const PADDING = 8;
const SHORTEST = 60;

/** Shows lines and edits them in a text area; Enter starts a new line, Ctrl+Enter stops editing. */
class FieldCode extends Blockly.FieldTextInput {
  private lines: SVGGElement | null = null;

  override initView(): void {
    this.createBorderRect_();
    this.lines = Blockly.utils.dom.createSvgElement(Svg.G, { class: "lbCode" }, this.fieldGroup_);
  }

  protected override render_(): void {
    this.lines?.replaceChildren(...this.shownLines().map(line));
    this.updateSize_();
  }

  // The base class has a shortcut for fields of one line.
  override isFullBlockField(): boolean {
    return false;
  }

  protected override updateSize_(): void {
    const texts = [...(this.lines?.children ?? [])] as SVGTextElement[];
    const widths = texts.map((text) => Blockly.utils.dom.getTextWidth(text));
    const width = Math.max(SHORTEST, ...widths) + 2 * PADDING;
    this.size_ = new Blockly.utils.Size(width, texts.length * LINE_HEIGHT + 2 * PADDING);
    this.positionBorderRect_();
  }

  private shownLines(): string[] {
    return String(this.getText()).split("\n");
  }

  protected override widgetCreate_(): HTMLTextAreaElement {
    const input = super.widgetCreate_();
    const area = document.createElement("textarea");
    area.className = `${input.className} lbCodeEditor`;
    area.spellcheck = false;
    area.style.fontSize = input.style.fontSize;
    area.defaultValue = this.getEditorText_(this.value_);
    area.setAttribute("data-untyped-default-value", String(this.value_));
    area.setAttribute("aria-label", this.getAriaTypeName() ?? "");
    this.unbindInputEvents_();
    input.replaceWith(area);
    this.bindInputEvents_(area);
    return area;
  }

  protected override onHtmlInputKeyDown_(event: KeyboardEvent): void {
    if (event.key === "Enter" && !event.ctrlKey && !event.metaKey) event.stopPropagation();
    else super.onHtmlInputKeyDown_(event);
  }
}

function line(text: string, place: number): SVGTextElement {
  const element = Blockly.utils.dom.createSvgElement(Svg.TEXT, {
    class: "blocklyText lbCodeLine",
    x: PADDING,
    y: PADDING + (place + 0.75) * LINE_HEIGHT,
  });
  // SVG would drop leading spaces, which Python needs.
  element.textContent = text.replaceAll(" ", "\u00a0") || "\u00a0";
  return element;
}

function addCode(this: Blockly.Block): void {
  this.getInput("PLACE")?.appendField(new FieldCode(""), "CODE");
}

export function registerCodeField(): void {
  Blockly.Extensions.register("lb_code_field", addCode);
}
