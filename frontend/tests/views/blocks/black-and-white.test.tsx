// @vitest-environment happy-dom
import { expect, test } from "vitest";

import { inBlackAndWhite } from "../../../src/views/blocks/black-and-white";

const BUTTON = encodeURIComponent('<svg viewBox="0 0 16 16"></svg>');
const ICON = encodeURIComponent('<svg class="icon icon-move" viewBox="0 0 24 24"></svg>');

function picture(inside: string): SVGElement {
  document.body.innerHTML = `<svg xmlns="http://www.w3.org/2000/svg">${inside}</svg>`;
  return document.querySelector("svg")!;
}

test("blocks are white with black lines and words", () => {
  const svg = picture('<path fill="rgb(1, 2, 3)" fill-opacity="0.5"/><path fill="none"/><text fill="white">set</text>');
  inBlackAndWhite(svg);
  const [block, line] = svg.querySelectorAll("path");
  expect(block!.getAttribute("fill")).toBe("#ffffff");
  expect(block!.getAttribute("stroke")).toBe("#000000");
  expect(block!.hasAttribute("fill-opacity")).toBe(false);
  expect(line!.getAttribute("fill")).toBe("none");
  expect(svg.querySelector("text")!.getAttribute("fill")).toBe("#000000");
});

test("buttons are left out, icons stay", () => {
  const svg = picture(
    `<image href="data:image/svg+xml,${BUTTON}"/><image id="icon" href="data:image/svg+xml,${ICON}"/>`,
  );
  inBlackAndWhite(svg);
  expect([...svg.querySelectorAll("image")].map(({ id }) => id)).toEqual(["icon"]);
});
