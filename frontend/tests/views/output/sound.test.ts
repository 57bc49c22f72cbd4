// @vitest-environment happy-dom

import { expect, test, vi } from "vitest";

import { startSound } from "../../../src/views/output/sound";
import { FakeConnection } from "../../fake-connection";

vi.mock("../../../src/views/output/synthesizer", () => ({
  Synthesizer: class {
    play(): void {}
    silence(): void {}
    destroy(): void {}
  },
}));

test("that a robot has no loudspeaker is said once for each project", () => {
  const connection = new FakeConnection();
  const running = { state: { value: { state: "running" } } };
  const sayWhere = vi.fn();
  const sound = startSound({ connection, running } as never, () => true, sayWhere);
  const tone = { kind: "Sound", device: "Speaker", action: "tone", values: [440, 100] } as const;

  connection.tell(tone);
  expect(sayWhere).toHaveBeenCalledTimes(0);
  connection.tell({ ...tone, stand_in: true });
  connection.tell({ ...tone, stand_in: true });
  expect(sayWhere).toHaveBeenCalledTimes(1);

  connection.tell({ kind: "Opened" });
  connection.tell({ ...tone, stand_in: true });
  expect(sayWhere).toHaveBeenCalledTimes(2);
  sound.destroy();
  expect(connection.listening).toBe(0);
});
