"""Measure whether a server's memory stays level while programs are run again and again.

    python benchmarks/memory.py [seconds per run] [minutes] [pupils]

A line follower with a camera is run twenty times, on a page's server and on a pupil's in a class;
afterwards each should use at most 20 MB more than after its first run. Then the pupils of a class
run it for some minutes, and the table shows what the whole class uses after each tenth of them. By
default runs take 9 s, and thirty pupils run programs for ten minutes.
"""

import asyncio
import os
import platform
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from time import perf_counter

from websockets.asyncio.client import ClientConnection, connect

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from _pages import Page, visit
from sessions import TOKEN, children, megabytes, serving

from classes import Joined, opened

EXAMPLE = "line-ebo"
#: Megabytes that a server may have grown by after the last run.
AIM = 20
#: The numbers of runs after which memory is measured.
MEASURED = (0, 1, 5, 10, 20)
#: Seconds in which memory becomes level, and the number of looks in a row, each half a second after
#: the one before, that have to be within 1 MB.
SETTLING, LEVEL = 60, 6
#: Pupils who join in one second.
JOINING = 0.5


class LinePage(Page):
    """A page that follows a line with the camera."""

    async def open(self) -> None:
        await self.say("New", name="line", example=EXAMPLE)
        await self.hear("Scene")
        await self.say("WatchCamera", on=True)

    async def run(self, seconds: float) -> None:
        """Run the program for some seconds, and stop it."""
        await self.say("Run")
        await self.hear("RunState", state="running")
        with suppress(TimeoutError):
            async with asyncio.timeout(seconds):
                await self.hear("Ended")
                return
        await self.say("Stop")
        await self.hear("RunState", state="ended")


async def repeated(
    socket: ClientConnection, server: Callable[[], int], seconds: float
) -> list[float]:
    """Return the memory of a server, whose process is known once it answers: see `MEASURED`."""
    found = []
    async with socket:
        page = LinePage(socket)
        await page.open()
        for number in range(MEASURED[-1] + 1):
            if number:
                await page.run(seconds)
            if number in MEASURED:
                found.append(await settled(server()))
    return found


async def settled(server: int) -> float:
    """Return the memory of a server once it has been level for a moment.

    A run gives its memory back after its end, which may take a while on a busy computer.
    """
    found = [megabytes(server)]
    async with asyncio.timeout(SETTLING):
        while len(found) < LEVEL or max(found[-LEVEL:]) - min(found[-LEVEL:]) > 1:
            await asyncio.sleep(0.5)
            found.append(megabytes(server))
    return found[-1]


async def alone(seconds: float) -> list[float]:
    with serving() as (port, server):
        address = f"ws://127.0.0.1:{port}/ws"
        socket = await connect(address, subprotocols=["learnblock", TOKEN], max_size=None)
        return await repeated(socket, lambda: server, seconds)


async def in_a_class(seconds: float) -> list[float]:
    with tempfile.TemporaryDirectory() as home, opened(Path(home)) as room:
        pupil = await asyncio.to_thread(room.pupil, "Ada")
        socket = await visit(room, f"/{pupil.address}ws", pupil.cookie)
        return await repeated(socket, lambda: servers(room.process.pid)[0], seconds)


def servers(room: int) -> list[int]:
    """The pupils' servers of a class."""
    (nursery,) = children(room)
    return children(nursery)


def used(room: int) -> Iterator[float]:
    """The memory of each server of a class, and of the class itself."""
    yield megabytes(room)
    for server in servers(room):
        with suppress(FileNotFoundError):
            yield megabytes(server)


async def learn(pupil: Joined, seconds: float, ends: float) -> int:
    """Run programs until some time; return how many."""
    runs = 0
    async with visit(pupil.room, f"/{pupil.address}ws", pupil.cookie) as socket:
        page = LinePage(socket)
        await page.open()
        while perf_counter() < ends:
            await page.run(seconds)
            runs += 1
    return runs


async def whole_class(seconds: float, minutes: float, pupils: int) -> None:
    with a_class() as room:
        joined = []
        for number in range(pupils):
            joined.append(await asyncio.to_thread(room.pupil, f"Pupil {number}"))
            await asyncio.sleep(JOINING)
        ends = perf_counter() + 60 * minutes
        learning = [asyncio.create_task(learn(pupil, seconds, ends)) for pupil in joined]
        print(f"{'minute':>8} {'class MB':>9} {'servers':>8} {'largest MB':>11}")
        for tenth in range(1, 11):
            await asyncio.sleep(max(0.0, ends - 6 * minutes * (10 - tenth) - perf_counter()))
            each = list(used(room.process.pid))
            print(
                f"{minutes * tenth / 10:8.1f} {sum(each):9.0f} {len(each) - 1:8} {max(each):11.0f}",
                flush=True,
            )
        runs = await asyncio.gather(*learning)
        print(f"{sum(runs)} runs; each pupil {min(runs)} to {max(runs)}")


@contextmanager
def a_class() -> Iterator[object]:
    with tempfile.TemporaryDirectory() as home, opened(Path(home)) as room:
        yield room


def show(name: str, found: list[float]) -> None:
    print(f"{name:12}" + "".join(f"{one:9.0f}" for one in found))
    growth = found[-1] - found[1]
    print(f"{'':12} {growth:+.0f} MB since the first run, {'met' if growth <= AIM else 'MISSED'}")


def main() -> None:
    given = [float(one) for one in sys.argv[1:]]
    seconds, minutes, pupils = (*given, *(9.0, 10.0, 30.0)[len(given) :])
    print(f"Python {platform.python_version()}, {os.cpu_count()} processors, {seconds:.0f} s a run")
    print(f"{'MB after':12}" + "".join(f"{count:4} runs" for count in MEASURED), flush=True)
    show("page", asyncio.run(alone(seconds)))
    show("pupil", asyncio.run(in_a_class(seconds)))
    if minutes:
        print(f"\n{pupils:.0f} pupils for {minutes:.0f} minutes")
        asyncio.run(whole_class(seconds, minutes, int(pupils)))


if __name__ == "__main__":
    main()
