import { expect, test } from "vitest";

import { Containment } from "../../src/features/containment/containment";
import { beginAnew } from "../../src/model/beginning-anew";
import { Toasts } from "../../src/ui/toasts";
import { FakeConnection } from "../fake-connection";

const REFUSED = { name: { code: "doctor-read" }, contained: true, reason: { code: "doctor-by-seccomp" } };
const FREE = { ...REFUSED, contained: false };

function begin(warns: boolean) {
  const [connection, toasts, opened] = [new FakeConnection(), new Toasts(), [] as string[]];
  const containment = new Containment(connection.real, toasts, () => opened.push("dialog"));
  beginAnew(connection.real, { connected: [containment], reset: [containment] });
  connection.tell({ kind: "Welcome", warns });
  connection.tell({ kind: "Opened" });
  return { connection, toasts, opened, containment };
}

test("a page that warns asks once a project is open, and links to the dialog", () => {
  const { connection, toasts, opened } = begin(true);
  expect(connection.sent).toEqual([{ kind: "ReadContainment" }]);
  connection.tell({ kind: "Containment", findings: [REFUSED, FREE] });
  expect(toasts.shown.value).toHaveLength(1);
  toasts.shown.value[0]?.action?.run();
  expect(opened).toEqual(["dialog"]);
});

test("it warns once", () => {
  const { connection, toasts } = begin(true);
  connection.tell({ kind: "Containment", findings: [FREE] });
  for (const one of toasts.shown.value) toasts.dismiss(one);
  connection.tell({ kind: "Opened" });
  connection.tell({ kind: "Containment", findings: [FREE] });
  expect(toasts.shown.value).toEqual([]);
  expect(connection.sent).toHaveLength(1);
});

test("nothing is said where everything is contained", () => {
  const { connection, toasts } = begin(true);
  connection.tell({ kind: "Containment", findings: [REFUSED] });
  expect(toasts.shown.value).toEqual([]);
});

test("another page does not ask by itself", () => {
  expect(begin(false).connection.sent).toEqual([]);
});

test("the network is allowed with the key of the last answer", async () => {
  const { connection, containment } = begin(false);
  containment.read();
  connection.tell({ kind: "Network", allowed: false, key: "abc" });
  await connection.answer();
  void containment.allowNetwork(true);
  expect(connection.sent.at(-1)).toEqual({ kind: "AllowNetwork", allowed: true, key: "abc" });
  await connection.refuse("server-network-ask-again");
  expect(containment.requests.refusal.value).toEqual({ code: "server-network-ask-again" });
});
