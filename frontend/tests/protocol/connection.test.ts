import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";

import { Connection } from "../../src/protocol/connection";
import type { ToPage } from "../../src/protocol/messages";

/** A socket whose other end is the test. */
class FakeSocket {
  static readonly OPEN = 1;
  static made: FakeSocket[] = [];
  readyState = 0;
  readonly sent: unknown[] = [];
  onopen = () => {};
  onmessage = (_event: { data: unknown }) => {};
  onclose = (_event: { code: number }) => {};

  constructor(
    readonly address: URL,
    readonly protocols: string[],
  ) {
    FakeSocket.made.push(this);
  }

  send(text: string): void {
    this.sent.push(JSON.parse(text));
  }

  accept(): void {
    this.readyState = FakeSocket.OPEN;
    this.onopen();
  }

  close(code = 1006): void {
    this.readyState = 3;
    this.onclose({ code });
  }

  tell(message: ToPage): void {
    this.onmessage({ data: JSON.stringify(message) });
  }
}

beforeEach(() => {
  FakeSocket.made = [];
  vi.stubGlobal("WebSocket", FakeSocket);
  vi.useFakeTimers();
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

function newest(): FakeSocket {
  return FakeSocket.made.at(-1) as FakeSocket;
}

function opened(): [Connection, FakeSocket] {
  const connection = new Connection(new URL("ws://robot.test/ws"), "secret");
  connection.open();
  newest().accept();
  return [connection, newest()];
}

describe("the token", () => {
  test("travels as a subprotocol and never in the address", () => {
    const [, socket] = opened();
    expect(socket.protocols).toEqual(["learnblock", "secret"]);
    expect(String(socket.address)).not.toContain("secret");
  });
});

describe("sending", () => {
  test("writes JSON", () => {
    const [connection, socket] = opened();
    expect(connection.send({ kind: "Stop" })).toBe(true);
    expect(socket.sent).toEqual([{ kind: "Stop" }]);
  });

  test("drops a message while there is no connection", () => {
    const [connection, socket] = opened();
    socket.close();
    expect(connection.send({ kind: "Stop" })).toBe(false);
    expect(socket.sent).toEqual([]);
  });
});

describe("listening", () => {
  test("receives messages of its kind only", () => {
    const [connection, socket] = opened();
    const printed = vi.fn();
    connection.on("Printed", printed);
    socket.tell({ kind: "Printed", text: "hello" });
    socket.tell({ kind: "InputWanted", prompt: "?" });
    expect(printed.mock.calls).toEqual([[{ kind: "Printed", text: "hello" }]]);
  });

  test("ends with the call of what `on` returns", () => {
    const [connection, socket] = opened();
    const printed = vi.fn();
    connection.on("Printed", printed)();
    socket.tell({ kind: "Printed", text: "hello" });
    expect(printed).not.toHaveBeenCalled();
  });

  test("reacts to refusals of the messages that it names, and of no answer that is awaited", () => {
    const [connection, socket] = opened();
    const refused = vi.fn();
    connection.onRefused(["SaveTags"], refused);
    const failed = { kind: "Failed", message: { code: "file-disk-full" } } as const;
    socket.tell({ ...failed, refused: "Step" });
    socket.tell({ ...failed, refused: "SaveTags", request: 1 });
    expect(refused).not.toHaveBeenCalled();
    socket.tell({ ...failed, refused: "SaveTags" });
    expect(refused).toHaveBeenCalledOnce();
  });

  test("receives pictures as they come", () => {
    const [connection, socket] = opened();
    const frame = vi.fn();
    connection.onFrame(frame);
    const picture = new Blob(["jpeg"]);
    socket.onmessage({ data: picture });
    expect(frame).toHaveBeenCalledExactlyOnceWith(picture);
  });
});

describe("asking", () => {
  const STEP = { kind: "Step" } as const;
  const UNSENT = { kind: "Failed", message: { code: "page-shell-unsent" } };

  test("gives each of two requests its own answer, in whatever order they come", async () => {
    const [connection, socket] = opened();
    const answers = [connection.ask(STEP), connection.ask(STEP)];
    expect(socket.sent).toEqual([
      { kind: "Step", request: 1 },
      { kind: "Step", request: 2 },
    ]);
    const failed = { kind: "Failed", message: { code: "server-other" }, refused: "Step", request: 2 } as const;
    socket.tell(failed);
    socket.tell({ kind: "Done", request: 1 });
    expect(await Promise.all(answers)).toEqual([{ kind: "Done", request: 1 }, failed]);
  });

  test("is refused without a connection, and when the connection is lost", async () => {
    const [connection, socket] = opened();
    const asked = connection.ask(STEP);
    socket.close();
    expect(await asked).toEqual(UNSENT);
    expect(await connection.ask(STEP)).toEqual(UNSENT);
  });
});

describe("reconnecting", () => {
  function delay(): number {
    const count = FakeSocket.made.length;
    const start = Date.now();
    while (FakeSocket.made.length === count) vi.advanceTimersToNextTimer();
    return Date.now() - start;
  }

  test("waits twice as long each time, up to 4 seconds", () => {
    opened();
    const delays = Array.from({ length: 6 }, () => {
      newest().close();
      return delay();
    });
    expect(delays).toEqual([250, 500, 1000, 2000, 4000, 4000]);
  });

  test("begins with the shortest delay again after a success", () => {
    opened();
    newest().close();
    delay();
    newest().accept();
    newest().close();
    expect(delay()).toBe(250);
  });

  test("keeps listeners", () => {
    const [connection] = opened();
    const printed = vi.fn();
    connection.on("Printed", printed);
    newest().close();
    delay();
    newest().tell({ kind: "Printed", text: "again" });
    expect(printed).toHaveBeenCalledOnce();
  });

  test("shows its state", () => {
    const connection = new Connection(new URL("ws://robot.test/ws"), "secret");
    const states = [connection.state.value];
    connection.open();
    newest().accept();
    states.push(connection.state.value);
    newest().close();
    states.push(connection.state.value);
    expect(states).toEqual(["connecting", "open", "lost"]);
  });
});

test.each([
  [4403, "refused"],
  [4429, "crowded"],
])("a connection that the server closes with %i is not tried again", (code, state) => {
  const [connection, socket] = opened();
  socket.close(code);
  expect(connection.state.value).toBe(state);
  expect(vi.getTimerCount()).toBe(0);
});
