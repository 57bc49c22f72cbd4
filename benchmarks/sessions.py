"""Measure how many pages one server serves, each with its own driving robot.

    python benchmarks/sessions.py [sessions] [seconds]

Every page runs an endless program in real time and counts the updates of its world, which
should be ten per second or more.
"""

import asyncio
import os
import platform
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import pairwise
from pathlib import Path
from time import perf_counter

from _pages import Page
from websockets.asyncio.client import ClientConnection, connect

TOKEN = "the-token-of-the-benchmark"  # noqa: S105 - it protects nothing
PROGRAM = """\
main:
    while True:
        if function.is_front_obstacle(150):
            function.turn(30)
        else:
            function.move_straight(80)
        end
        function.sleep(0.1)
    end
end
"""


class DrivingPage(Page):
    """A page whose robot drives; `told` are the times of the world updates that it received."""

    def __init__(self, socket: ClientConnection) -> None:
        super().__init__(socket)
        self.told: list[float] = []

    async def start(self, number: int) -> None:
        await self.say("New", name=f"project {number}", example="avoid")
        await self.hear("Scene")
        await self.say("EditText", edit=1, notation="blocktext", text=PROGRAM)
        await self.say("Run")
        await self.hear("RunState", state="running")

    async def listen(self) -> None:
        async for message in self._socket:
            if '"kind":"Telemetry"' in message[:24]:
                self.told.append(perf_counter())


async def opened(port: int, number: int) -> tuple[DrivingPage, asyncio.Task[None]]:
    address = f"ws://127.0.0.1:{port}/ws"
    page = DrivingPage(await connect(address, subprotocols=["learnblock", TOKEN], max_size=None))
    await page.start(number)
    return page, asyncio.create_task(page.listen())


async def measure(port: int, server: int, sessions: int, seconds: float) -> None:
    page, listening = await opened(port, 0)
    one = megabytes(server)
    others = [await opened(port, number) for number in range(1, sessions)]
    used, began = processor_time(server), perf_counter()
    await asyncio.sleep(seconds)
    wall = perf_counter() - began
    report(
        [[moment for moment in each.told if moment >= began] for each, _ in [(page, 0), *others]],
        wall,
    )
    programs = children(server)
    spent = sum(map(processor_time, programs))
    print(f"server      {megabytes(server):.0f} MB; with its first session alone {one:.0f} MB")
    print(f"a program   {statistics.mean(map(megabytes, programs)):.0f} MB")
    print(f"processors  server {(processor_time(server) - used) / wall:.2f} of {os.cpu_count()}")
    print(f"            programs {spent:.1f} s since their start")
    for task in (listening, *(task for _, task in others)):
        task.cancel()


def report(told: list[list[float]], wall: float) -> None:
    rates = [len(moments) / wall for moments in told]
    gaps = sorted(later - earlier for moments in told for earlier, later in pairwise(moments))
    median, late = gaps[len(gaps) // 2] * 1e3, gaps[len(gaps) * 99 // 100] * 1e3
    print(f"updates     {min(rates):.1f} to {max(rates):.1f} a second and page")
    print(f"gaps        median {median:.0f} ms, 99 % {late:.0f} ms")


def children(process: int) -> list[int]:
    tasks = Path(f"/proc/{process}/task").iterdir()
    return [int(child) for task in tasks for child in (task / "children").read_text().split()]


def megabytes(process: int) -> float:
    """Return the memory that a process does not share with others."""
    rollup = Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
    return sum(int(line.split()[1]) for line in rollup if line.startswith("Private_")) / 1024


def processor_time(process: int) -> float:
    """Return the processor seconds that a process has used."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@contextmanager
def serving() -> Iterator[tuple[int, int]]:
    """Return the port and the process of a server with an empty home folder."""
    with tempfile.TemporaryDirectory() as home:
        environment = {**os.environ, "LEARNBLOCK_TOKEN": TOKEN, "LEARNBLOCK_HOME": home}
        command = [sys.executable, "-m", "learnblock", "--no-browser", "--port", "0"]
        server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment)
        try:
            assert server.stdout  # noqa: S101
            place = server.stdout.readline().split("/")[2]
            yield int(place.rpartition(":")[2]), server.pid
        finally:
            server.terminate()
            server.wait()


def main() -> None:
    sessions = int(sys.argv[1]) if len(sys.argv) > 1 else 30
    seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 10.0
    print(f"Python {platform.python_version()}, {os.cpu_count()} processors, {sessions} sessions")
    with serving() as (port, server):
        asyncio.run(measure(port, server, sessions, seconds))


if __name__ == "__main__":
    main()
