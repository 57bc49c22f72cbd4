/** Blocks as an SVG that needs nothing else: its colours, icons and letters are inside. */

const SVG = "http://www.w3.org/2000/svg";
const XLINK = "http://www.w3.org/1999/xlink";
const MARGIN = 16;
/** What a field has above and below its words, in pixels. */
const AROUND = 14;
/** What style sheets say of a shape, and its value without them. */
const STYLES: Readonly<Record<string, string>> = {
  fill: "rgb(0, 0, 0)",
  "fill-opacity": "1",
  stroke: "none",
  "stroke-width": "1px",
  "stroke-opacity": "1",
  "stroke-dasharray": "none",
  opacity: "1",
  "font-family": "",
  "font-size": "",
  "font-weight": "400",
  "font-style": "normal",
  "text-anchor": "start",
  "dominant-baseline": "auto",
};
const OF_TEXT = /^(font|text|dominant)/;
const OF_THE_PAGE = /^(class|style|id|filter|tabindex|role|aria-.*|data-.*)$/;

export interface PortablePicture {
  readonly svg: SVGElement;
  /** In pixels at the usual size. */
  readonly width: number;
  readonly height: number;
  /** Where its words are, from above, with what surrounds them. */
  readonly words: readonly Band[];
}

/** A part of a picture's height. */
export interface Band {
  readonly top: number;
  readonly bottom: number;
}

interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/**
 * Copy what the page shows. Call `complete` for what is not in the page itself.
 *
 * @param shapes the drawn blocks.
 * @param box where they are.
 * @param text the alternative text.
 * @param ground the colour behind them; null for none.
 */
export function portable(shapes: SVGElement, box: Box, text: string, ground: string | null): PortablePicture {
  const width = Math.ceil(box.right - box.left + 2 * MARGIN);
  const height = Math.ceil(box.bottom - box.top + 2 * MARGIN);
  const blocks = copied(shapes) as SVGElement;
  blocks.setAttribute("transform", `translate(${MARGIN - box.left} ${MARGIN - box.top})`);
  const svg = element("svg", { width, height, viewBox: `0 0 ${width} ${height}`, role: "img" });
  const title = element("title", {});
  title.textContent = text;
  svg.append(title);
  if (ground) svg.append(element("rect", { width, height, fill: ground }));
  svg.append(blocks);
  return { svg, width, height, words: wordsOf(shapes, MARGIN - box.top) };
}

/** The part of a picture between two heights. */
export function slice({ svg, width }: PortablePicture, { top, bottom }: Band): SVGElement {
  const part = svg.cloneNode(true) as SVGElement;
  part.setAttribute("height", String(bottom - top));
  part.setAttribute("viewBox", `0 ${top} ${width} ${bottom - top}`);
  return part;
}

function wordsOf(shapes: SVGElement, down: number): Band[] {
  const origin = shapes.getBoundingClientRect().top - (shapes as SVGGraphicsElement).getBBox().y;
  const texts = [...shapes.querySelectorAll("text")].map((text) => text.getBoundingClientRect());
  const from = origin - down;
  return texts.map(({ top, bottom }) => ({ top: top - from - AROUND, bottom: bottom - from + AROUND }));
}

/** Put the pictures and letters of other files into the picture. */
export async function complete(picture: PortablePicture): Promise<PortablePicture> {
  const { svg } = picture;
  await Promise.all([...svg.querySelectorAll("image")].map(takeImage));
  const style = element("style", {});
  style.textContent = await fontFace();
  svg.insertBefore(style, svg.firstChild);
  return picture;
}

function element(name: string, attributes: Readonly<Record<string, string | number>>): SVGElement {
  const shape = document.createElementNS(SVG, name) as SVGElement;
  for (const [attribute, value] of Object.entries(attributes)) shape.setAttribute(attribute, String(value));
  return shape;
}

/** A copy with the styles of the page's style sheets in its attributes, and without what is not shown. */
function copied(shape: Element): Element | null {
  const style = getComputedStyle(shape);
  if (style.display === "none" || style.visibility === "hidden") return null;
  const copy = shape.cloneNode(false) as Element;
  for (const { name } of [...copy.attributes]) if (OF_THE_PAGE.test(name)) copy.removeAttribute(name);
  copyStyle(shape, style, copy);
  for (const child of shape.childNodes) {
    const inner = child instanceof Element ? copied(child) : child.cloneNode();
    if (inner) copy.append(inner);
  }
  return copy;
}

function copyStyle(shape: Element, style: CSSStyleDeclaration, copy: Element): void {
  if (shape.tagName === "image" && style.filter !== "none") copy.setAttribute("style", `filter: ${style.filter}`);
  const isText = shape.tagName === "text";
  const isGroup = !isText && !(shape instanceof SVGGeometryElement);
  for (const [name, usual] of Object.entries(STYLES)) {
    if (isGroup ? name !== "opacity" : !isText && OF_TEXT.test(name)) continue;
    const value = style.getPropertyValue(name);
    if (value === usual) copy.removeAttribute(name);
    else copy.setAttribute(name, value);
  }
  if (isText) keepLength(shape as SVGTextElement, copy);
}

/** Where the picture's letters can't be loaded, others then have the room that the block has for them. */
function keepLength(text: SVGTextElement, copy: Element): void {
  const length = text.getComputedTextLength();
  if (!length) return;
  copy.setAttribute("textLength", String(Math.round(length * 10) / 10));
  copy.setAttribute("lengthAdjust", "spacingAndGlyphs");
}

async function takeImage(image: SVGImageElement): Promise<void> {
  const address = image.href.baseVal || image.getAttribute("xlink:href") || "";
  image.removeAttributeNS(XLINK, "href");
  image.setAttribute("href", address.startsWith("data:") ? address : await dataOf(address));
}

/** The rule of the page's letters, with the letters. */
async function fontFace(): Promise<string> {
  const rule = fontRules().find((face) => face.style.getPropertyValue("unicode-range").includes("U+0-FF"));
  const source = rule && /url\("?([^")]+)"?\)/.exec(rule.style.getPropertyValue("src"))?.[1];
  if (!rule || !source) return "";
  const address = new URL(source, rule.parentStyleSheet?.href ?? document.baseURI).href;
  const letters = address.startsWith("data:") ? address : await dataOf(address);
  const family = rule.style.getPropertyValue("font-family");
  return `@font-face{font-family:${family};font-weight:200 1000;src:url(${letters})}`;
}

function fontRules(): CSSFontFaceRule[] {
  const rules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules]);
  return rules.filter(
    (rule): rule is CSSFontFaceRule =>
      rule instanceof CSSFontFaceRule && /Nunito/.test(rule.style.getPropertyValue("font-family")),
  );
}

async function dataOf(address: string): Promise<string> {
  const content = await (await fetch(address)).blob();
  return new Promise((resolve) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.readAsDataURL(content);
  });
}
