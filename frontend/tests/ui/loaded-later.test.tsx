// @vitest-environment happy-dom

import { type FunctionComponent, render } from "preact";
import { act } from "preact/test-utils";
import { expect, test, vi } from "vitest";

import { loadedLater } from "../../src/ui/loaded-later";

const Name = ({ name }: { name: string }) => <b>{name}</b>;

async function shown(Part: FunctionComponent<{ name: string }>): Promise<HTMLElement> {
  const place = document.createElement("div");
  await act(() => render(<Part name="Ada" />, place));
  return place;
}

test("a part is there when its code is, and the next one at once", async () => {
  const load = vi.fn(async () => Name);
  const Later = loadedLater(load);
  expect((await shown(Later)).innerHTML).toBe("<b>Ada</b>");
  const place = document.createElement("div");
  render(<Later name="Ben" />, place);
  expect(place.innerHTML).toBe("<b>Ben</b>");
  expect(load).toHaveBeenCalledTimes(1);
});

test("a part that can't be loaded says so, and is loaded again when it is shown again", async () => {
  const error = vi.spyOn(console, "error").mockReturnValue();
  const load = vi.fn().mockRejectedValueOnce(new TypeError("offline")).mockResolvedValue(Name);
  const Later = loadedLater<{ name: string }>(load);
  expect((await shown(Later)).querySelector("[role=alert]")).not.toBeNull();
  expect(error).toHaveBeenCalledTimes(1);
  expect((await shown(Later)).innerHTML).toBe("<b>Ada</b>");
  error.mockRestore();
});
