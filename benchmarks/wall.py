"""Measure the wall of a class: its delay, its traffic, and the processors that it takes.

    python benchmarks/wall.py [pupils] [seconds]

Each pupil's page runs an endless program. A wall in a browser shows all, without a graphics card. A
second wall, without a browser, measures how long after the pupil's page it hears where a robot is.
The wall should be at most 1 s behind, and take less than half a core and 1 MB/s.
"""

import asyncio
import json
import os
import shutil
import statistics
import sys
from contextlib import AsyncExitStack
from pathlib import Path
from time import perf_counter

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from _browser import ARGUMENTS, BROWSERS, Processors
from _class import in_a_class
from _pages import Page, visit
from playwright.async_api import async_playwright
from sessions import PROGRAM, megabytes
from websockets.asyncio.client import ClientConnection

from classes import Class, Joined

DELAY, CORES, TRAFFIC = 1.0, 0.5, 1e6
#: Waits until every tile has been painted.
PAINTED = "count => document.querySelectorAll('canvas[data-shown]').length === count"
TIMEOUT = 180_000

Place = tuple[int, int, int]


class Delays:
    """When each robot was where, and how much later the wall says so."""

    def __init__(self) -> None:
        self.all: list[float] = []
        self.traffic = 0
        self._seen: dict[str, dict[Place, float]] = {}

    def seen(self, pupil: str, place: Place) -> None:
        """A pupil's page hears where its robot is."""
        self._seen.setdefault(pupil, {}).setdefault(place, perf_counter())

    def told(self, pupil: str, place: Place) -> None:
        """The wall hears where a pupil's robot is."""
        places = self._seen.get(pupil, {})
        if place in places:
            self.all.append(perf_counter() - places[place])
            # A robot may come back to a place later.
            places.clear()

    def forget(self) -> None:
        """Begin to measure."""
        self.all.clear()
        self.traffic = 0


async def pupil_page(pupil: Joined, delays: Delays, stack: AsyncExitStack) -> asyncio.Task[None]:
    socket = await stack.enter_async_context(visit(pupil.room, f"/{pupil.address}ws", pupil.cookie))
    page = Page(socket)
    await page.say("New", name="mine", example="avoid")
    await page.hear("Scene")
    await page.say("EditText", edit=1, notation="blocktext", text=PROGRAM)
    await page.say("Run")
    await page.hear("RunState", state="running")
    return asyncio.create_task(follow_pupil(socket, pupil.id, delays))


async def follow_pupil(socket: ClientConnection, pupil: str, delays: Delays) -> None:
    async for message in socket:
        if '"kind":"Telemetry"' in message[:24]:
            robot = json.loads(message)["robots"][0]
            place = round(robot["x"]), round(robot["y"]), round(robot["heading"])
            delays.seen(pupil, place)


async def follow_wall(socket: ClientConnection, delays: Delays) -> None:
    async for message in socket:
        delays.traffic += len(message)
        said = json.loads(message)
        for seat in said["seats"] if said["kind"] == "Seats" else ():
            if pose := seat.get("pose"):
                delays.told(seat["id"], tuple(map(round, pose)))


async def measure(room: Class, pupils: list[Joined], seconds: float) -> None:
    delays = Delays()
    async with AsyncExitStack() as stack:
        pages = (pupil_page(pupil, delays, stack) for pupil in pupils)
        tasks = list(await asyncio.gather(*pages))
        socket = await stack.enter_async_context(visit(room, "/wall", room.teacher()))
        tasks.append(asyncio.create_task(follow_wall(socket, delays)))
        playwright = await stack.enter_async_context(async_playwright())
        found = os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)
        browser = await playwright.chromium.launch(executable_path=found, args=ARGUMENTS)
        page = await browser.new_page(viewport={"width": 1366, "height": 768})
        began = perf_counter()
        await page.goto(f"{room.address}/teacher?key={room.key}")
        await page.wait_for_function(PAINTED, arg=len(pupils), timeout=TIMEOUT)
        print(f"all painted    {perf_counter() - began:.1f} s after the wall was opened")
        delays.forget()
        processors = Processors()
        await asyncio.sleep(seconds)
        report(delays, processors, room.process.pid, seconds)
        await browser.close()
        for task in tasks:
            task.cancel()


def report(delays: Delays, processors: Processors, server: int, seconds: float) -> None:
    delay = sorted(delays.all)
    median, late = statistics.median(delay), delay[len(delay) * 95 // 100]
    traffic = delays.traffic / seconds
    wall = processors.cores("chrom")
    print(f"delay          median {median:.2f} s, 95 % {late:.2f} s, longest {delay[-1]:.2f} s")
    print(f"traffic        {traffic / 1e3:.1f} kB/s")
    print(f"the wall       {wall:.2f} cores, with everything of its browser")
    print(f"class's server {processors.of(server):.2f} cores, {megabytes(server):.0f} MB")
    print(f"all processes  {processors.cores(''):.2f} of {os.cpu_count()} cores")
    print(f"load           {os.getloadavg()[0]:.1f}")
    good = late <= DELAY and wall <= CORES and traffic <= TRAFFIC
    print("as it should be" if good else "NOT as it should be")


if __name__ == "__main__":
    in_a_class(measure, pupils=30)
