import { expect, test } from "vitest";

import { Trying } from "../../src/features/custom-blocks/trying";
import type { Context } from "../../src/model/context";
import { FakeConnection } from "../fake-connection";

test("a trial that is closed listens to nothing any more", () => {
  const connection = new FakeConnection();
  const trying = new Trying({ connection: connection.real } as Context);
  expect(connection.listening).toBeGreaterThan(0);
  trying.destroy();
  expect(connection.listening).toBe(0);
});
