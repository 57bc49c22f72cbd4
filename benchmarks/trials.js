/** Counts what a hand does, for `trials.py`; put into the page before all else. */

globalThis.steps = { clicks: 0, keys: 0 };
addEventListener("pointerdown", () => (steps.clicks += 1), { capture: true });
addEventListener("keydown", () => (steps.keys += 1), { capture: true });
