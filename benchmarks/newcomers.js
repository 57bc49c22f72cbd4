/** Counts what a hand does, and finds what a newcomer would stumble over, for `newcomers.py`. */

globalThis.steps = { clicks: 0, keys: 0, ...JSON.parse(sessionStorage.steps ?? "{}") };
addEventListener("pointerdown", () => count("clicks"), { capture: true });
addEventListener("keydown", () => count("keys"), { capture: true });

/** Count one more; a page that is opened next in the same tab goes on. */
function count(kind) {
  steps[kind] += 1;
  sessionStorage.steps = JSON.stringify(steps);
}

const CONTROLS = "button, select, input, textarea, a[href], summary";

/** The dialog or menu that is open, or else the page. */
function shownPart() {
  const above = document.querySelectorAll("dialog[open], .blocklyContextMenu, [role=menu]");
  return [...above].filter(isSeen).at(-1) ?? document.body;
}

function isSeen(part) {
  const { width, height } = part.getBoundingClientRect();
  return width > 1 && height > 1 && part.checkVisibility({ visibilityProperty: true, opacityProperty: true });
}

function nameOf(part) {
  return (part.ariaLabel || part.title || part.textContent || part.tagName).trim().slice(0, 40);
}

/** The part of an element's box that scrolling parts and the window leave to be seen. */
function inSight(part) {
  let { left, top, right, bottom } = part.getBoundingClientRect();
  for (let around = part.parentElement; around; around = around.parentElement) {
    if (getComputedStyle(around).overflow === "visible") continue;
    const box = around.getBoundingClientRect();
    [left, top] = [Math.max(left, box.left), Math.max(top, box.top)];
    [right, bottom] = [Math.min(right, box.right), Math.min(bottom, box.bottom)];
  }
  [right, bottom] = [Math.min(right, innerWidth), Math.min(bottom, innerHeight)];
  return { x: (left + right) / 2, y: (top + bottom) / 2, width: right - left, height: bottom - top };
}

/** Whether something else covers the middle of a control, where one clicks. */
function isCovered(part) {
  const { x, y, width, height } = inSight(part);
  if (width < 8 || height < 8) return false;
  const hit = document.elementFromPoint(x, y);
  // The label of a choice takes clicks for it.
  return hit !== null && !part.contains(hit) && !hit.contains(part) && !part.labels?.[0]?.contains(hit);
}

/** Whether the words of an element end in an ellipsis. */
function isCut(part) {
  return getComputedStyle(part).textOverflow === "ellipsis" && part.scrollWidth > part.clientWidth + 1;
}

globalThis.stumbles = () => {
  const part = shownPart();
  const controls = [...part.querySelectorAll(CONTROLS)].filter(isSeen);
  const texts = [...part.querySelectorAll("*")].filter((one) => isSeen(one) && isCut(one));
  const isWide = document.documentElement.scrollWidth > innerWidth + 1;
  const isLost = part.matches("dialog") && !part.contains(document.activeElement);
  return [
    ...(isWide ? ["the page is wider than the screen"] : []),
    ...(isLost ? ["the focus is not in the dialog"] : []),
    ...controls.filter(isCovered).map((one) => `covered: ${nameOf(one)}`),
    ...texts.map((one) => `cut: ${nameOf(one)}`),
  ];
};
