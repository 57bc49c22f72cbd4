import { expect, test } from "vitest";

import { guestPath } from "../../src/features/in-class/host-world";
import { Pairs } from "../../src/features/in-class/pairs";
import { FakeConnection } from "../fake-connection";

function open() {
  const connection = new FakeConnection();
  const pairs = new Pairs(connection.real);
  const tell = (news: object) => connection.tell({ kind: "InPair", ...news } as never);
  return { connection, pairs, tell };
}

test("a classmate can be invited once the teacher allows it, and by a pupil who is alone", () => {
  const { pairs, tell } = open();
  expect(pairs.canInvite).toBe(false);
  tell({});
  expect(pairs.canInvite).toBe(false);
  tell({ allowed: true });
  expect(pairs.canInvite).toBe(true);
  tell({ allowed: true, state: "inviting", other: "Ben" });
  expect(pairs.canInvite).toBe(false);
});

test("a guest's page shows the host's world, until the guest wants to see the own one", () => {
  const { pairs, tell } = open();
  tell({ allowed: true, state: "invited", other: "Ana" });
  expect(pairs.isAway.value).toBe(false);
  tell({ allowed: true, state: "guest", other: "Ana" });
  expect(pairs.isAway.value).toBe(true);
  pairs.isAway.value = false;
  // News of the same pair leave the page as it is.
  tell({ allowed: true, state: "guest", other: "Ana", away: true });
  expect(pairs.isAway.value).toBe(false);
  tell({ allowed: true });
  tell({ allowed: true, state: "guest", other: "Eva" });
  expect(pairs.isAway.value).toBe(true);
});

test("the list of classmates is requested again each time", () => {
  const { connection, pairs } = open();
  pairs.ask();
  connection.tell({ kind: "Classmates", pupils: [{ id: "b", name: "Ben" }] } as never);
  expect(pairs.classmates.value).toEqual([{ id: "b", name: "Ben" }]);
  pairs.ask();
  expect(pairs.classmates.value).toBe(null);
  connection.tell({ kind: "Classmates" } as never);
  expect(pairs.classmates.value).toEqual([]);
  pairs.invite("b");
  pairs.answer(true);
  pairs.leave();
  expect(connection.sent.slice(2)).toEqual([
    { kind: "Invite", pupil: "b" },
    { kind: "AnswerInvitation", on: true },
    { kind: "LeaveWorld" },
  ]);
});

test.each([
  ["/p/abc/", "/p/guest-abc/"],
  ["/hub/p/abc/", "/hub/p/guest-abc/"],
  ["/p/abc/index.html", "/p/guest-abc/"],
])("the page of a guest at %s is %s", (path, expected) => expect(guestPath(path)).toBe(expected));
