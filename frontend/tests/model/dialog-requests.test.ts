import { signal } from "@preact/signals";
import { expect, test } from "vitest";

import { startLanguage } from "../../src/i18n";
import { DialogRequests } from "../../src/model/dialog-requests";
import { FakeConnection } from "../fake-connection";

function begin() {
  const connection = new FakeConnection();
  return { connection, requests: new DialogRequests(connection.real) };
}

test("a refusal is shown until the next request", async () => {
  const { connection, requests } = begin();
  const first = requests.ask({ kind: "ListRuns" });
  await connection.refuse("file-disk-full");
  expect(await first).toBeNull();
  expect(requests.refusal.value).toEqual({ code: "file-disk-full" });
  const second = requests.ask({ kind: "ListRuns" });
  expect(requests.refusal.value).toBe("");
  await connection.answer();
  expect(await second).toEqual({ kind: "Done" });
});

test("a file that is too long is refused without being read", async () => {
  const { requests } = begin();
  expect(await requests.textOf(new File(["12345"], "tags.toml"), 4, "too long")).toBeNull();
  expect(requests.refusal.value).toBe("too long");
  expect(await requests.textOf(new File(["1234"], "tags.toml"), 4, "too long")).toBe("1234");
  expect(requests.refusal.value).toBe("");
});

test("a file that is not UTF-8 is refused by its name", async () => {
  await startLanguage(signal("en"));
  const { requests } = begin();
  const latin = new File([new Uint8Array([0xf1])], "tags.toml");
  expect(await requests.textOf(latin, 9, "too long")).toBeNull();
  expect(requests.refusal.value).toBe("tags.toml is not UTF-8. Save the file as UTF-8.");
});
