import { beforeEach, expect, test, vi } from "vitest";

import { ClassNews, PERIOD } from "../../src/features/in-class/in-class";
import { FakeConnection } from "../fake-connection";

const NEWS = { kind: "InClass", name: "Ana", role: "pupil", eyes_up: false, hand: false, writing: "no" } as never;

beforeEach(() => void vi.useFakeTimers());

function open() {
  const connection = new FakeConnection();
  return { connection, news: new ClassNews(connection.real) };
}

test("a class that does not answer twice is silent, until it answers", () => {
  const { connection, news } = open();
  connection.tell(NEWS);
  vi.advanceTimersByTime(2 * PERIOD);
  expect(news.silent.value).toBe(false);
  vi.advanceTimersByTime(PERIOD);
  expect(news.silent.value).toBe(true);
  connection.tell(NEWS);
  expect(news.silent.value).toBe(false);
  expect(connection.sent[0]).toEqual({ kind: "AskNews" });
});

test("a class that answers is never silent", () => {
  const { connection, news } = open();
  for (let i = 0; i < 5; i++) {
    connection.tell(NEWS);
    vi.advanceTimersByTime(PERIOD);
    expect(news.silent.value).toBe(false);
  }
});

test("a lost connection is not silent, too", () => {
  const { connection, news } = open();
  connection.tell(NEWS);
  vi.advanceTimersByTime(3 * PERIOD);
  connection.state.value = "lost";
  expect(news.silent.value).toBe(false);
});

test("outside a class nothing is asked", () => {
  const { connection } = open();
  vi.advanceTimersByTime(3 * PERIOD);
  expect(connection.sent).toEqual([]);
});
