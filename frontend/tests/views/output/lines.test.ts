// @vitest-environment happy-dom
import { expect, test, vi } from "vitest";

import { Lines } from "../../../src/views/output/lines";

test("a line of the page leads to where it happened, in the words of the view that is open", () => {
  const lines = new Lines(vi.fn());
  const go = vi.fn();
  let view = "Block-Text, line 3";
  lines.add({ words: () => "Stopped by an error.", sort: "bad", lead: { words: () => view, go } });
  expect(lines.text()).toBe("Stopped by an error. Block-Text, line 3");
  lines.dom.querySelector<HTMLElement>(".lead")?.click();
  expect(go).toHaveBeenCalledOnce();

  view = "Block “turn around”";
  lines.translate();
  expect(lines.text()).toBe("Stopped by an error. Block “turn around”");
});

test("a lead without a place is hidden", () => {
  const lines = new Lines(vi.fn());
  lines.add({ words: () => "Stopped.", sort: "bad", lead: { words: () => "", go: vi.fn() } });
  expect(lines.dom.querySelector<HTMLElement>(".lead")?.hidden).toBe(true);
});

test("a question about a printed line counts only what the same run printed since", async () => {
  const ask = vi.fn();
  const lines = new Lines(ask);
  const part = (text: string) => ({ robot: "", text, until: text.length });
  lines.print(part("old\n"));
  lines.beginRun();
  lines.add({ words: () => "Run 2", sort: "run" });
  lines.print(part("a\nb\n"));
  expect(lines.text()).toBe("old\nRun 2\na\nb");
  document.body.append(lines.dom);
  lines.dom.querySelectorAll<HTMLElement>(".printed")[1]?.dispatchEvent(new Event("pointerover", { bubbles: true }));
  lines.dom.querySelector<HTMLElement>(".why-line")?.click();
  expect(ask).toHaveBeenCalledWith("a", 1);
});
