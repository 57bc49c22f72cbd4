/** A dial for an angle: 0 is up, which means ahead, and 90 is right. */

import * as Blockly from "blockly/core";

const { Svg, dom } = Blockly.utils;
const RADIUS = 60;
const NOTCHES = 24;

export class Dial {
  readonly dom = document.createElement("div");
  private readonly hand: SVGElement;

  /** @param take called with each chosen angle, in degrees from -180 to 180. */
  constructor(
    private readonly step: number,
    private readonly take: (angle: number) => void,
  ) {
    const size = 2 * RADIUS;
    const svg = dom.createSvgElement(
      Svg.SVG,
      { viewBox: `${-RADIUS} ${-RADIUS} ${size} ${size}`, width: size, height: size },
      this.dom,
    );
    dom.createSvgElement(Svg.CIRCLE, { r: RADIUS - 4, class: "lbDialFace" }, svg);
    for (let at = 0; at < NOTCHES; at++) notch(svg, (at * 360) / NOTCHES);
    this.hand = dom.createSvgElement(Svg.PATH, { d: `M-5 0L0 ${12 - RADIUS}L5 0z`, class: "lbDialHand" }, svg);
    this.dom.className = "lbDial";
    // The slider below it is the accessible version.
    this.dom.ariaHidden = "true";
    this.dom.addEventListener("pointerdown", (event) => this.follow(event));
    this.dom.addEventListener("pointermove", (event) => event.buttons && this.point(event));
  }

  show(angle: number): void {
    this.hand.setAttribute("transform", `rotate(${angle})`);
  }

  private follow(event: PointerEvent): void {
    // The slider keeps the focus.
    event.preventDefault();
    this.dom.setPointerCapture(event.pointerId);
    this.point(event);
  }

  private point({ clientX, clientY }: PointerEvent): void {
    const { left, top, width, height } = this.dom.getBoundingClientRect();
    const angle = Math.atan2(clientX - left - width / 2, top + height / 2 - clientY);
    this.take(Math.round((angle * 180) / Math.PI / this.step) * this.step);
  }
}

function notch(svg: SVGElement, angle: number): void {
  const long = angle % 90 === 0 ? 10 : 5;
  const line = { y1: 4 - RADIUS, y2: 4 + long - RADIUS, transform: `rotate(${angle})`, class: "lbDialNotch" };
  dom.createSvgElement(Svg.LINE, line, svg);
}
