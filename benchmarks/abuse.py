"""Measure how long other pages wait for an answer while one page does its worst.

    python benchmarks/abuse.py [seconds per message] [words in a message's name]

One page sends the slowest messages of each kind that the limits allow, each to a project of its
own, while another page asks for the list of projects twenty times a second. The longest answer
should take at most 0.5 s.
"""

import asyncio
import json
import os
import platform
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from time import perf_counter

from websockets.asyncio.client import ClientConnection, connect

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from sessions import TOKEN, megabytes, serving

from worst_messages import worst_messages

#: Seconds that another page may wait.
AIM = 0.5
#: Seconds between its questions.
PERIOD = 0.05


class Other:
    """Another page, which measures how long each of its answers takes."""

    def __init__(self) -> None:
        self.longest = 0.0

    async def ask(self, port: int) -> None:
        async with await page(port) as socket:
            while True:
                began = perf_counter()
                await socket.send(json.dumps({"kind": "ListProjects"}))
                await heard(socket, "Projects")
                self.longest = max(self.longest, perf_counter() - began)
                await asyncio.sleep(PERIOD)

    def take(self) -> float:
        """Return the longest time since the last call."""
        longest, self.longest = self.longest, 0.0
        return longest


async def page(port: int) -> ClientConnection:
    address = f"ws://127.0.0.1:{port}/ws"
    return await connect(address, subprotocols=["learnblock", TOKEN], max_size=None)


async def heard(socket: ClientConnection, kind: str) -> str:
    start = f'{{"kind":"{kind}"'
    while not (message := await socket.recv(decode=True)).startswith(start):
        pass
    return message


async def attack(port: int, message: str, patience: float) -> tuple[float, str]:
    """Send a message; return the seconds until the page is answered again, and what it heard."""
    async with await page(port) as socket:
        await socket.send(json.dumps({"kind": "New", "name": "attack"}))
        await heard(socket, "Document")
        began = perf_counter()
        await socket.send(message)
        await socket.send(json.dumps({"kind": "ListHistory"}))
        outcome = "unanswered"
        with suppress(TimeoutError):
            async with asyncio.timeout(patience):
                await heard(socket, "History")
                outcome = "answered"
        return perf_counter() - began, outcome


async def measure(port: int, server: int, patience: float, words: str) -> None:
    other = Other()
    async with asyncio.TaskGroup() as tasks:
        asking = tasks.create_task(other.ask(port))
        await asyncio.sleep(2)
        print(f"{other.take() * 1e3:6.0f} ms  with no attack")
        worst = 0.0
        for name, message in chosen(words):
            text = json.dumps(message)
            other.take()
            seconds, outcome = await attack(port, text, patience)
            waited = other.take()
            worst = max(worst, waited)
            mark = "!" if waited > AIM else " "
            print(
                f"{mark}{waited * 1e3:5.0f} ms  {name}: {len(text) / 1e6:.1f} MB,"
                f" {outcome} after {seconds:.1f} s, server {megabytes(server):.0f} MB",
                flush=True,
            )
        asking.cancel()
    print(f"{worst * 1e3:6.0f} ms  at most")


def chosen(words: str) -> Iterator[tuple[str, dict[str, object]]]:
    return ((name, message) for name, message in worst_messages() if words in name)


def main() -> None:
    patience = float(sys.argv[1]) if len(sys.argv) > 1 else 60.0
    words = sys.argv[2] if len(sys.argv) > 2 else ""
    print(f"Python {platform.python_version()}, {os.cpu_count()} processors")
    with serving() as (port, server):
        asyncio.run(measure(port, server, patience, words))


if __name__ == "__main__":
    main()
