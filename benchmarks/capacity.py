"""Measure how many pupils a core and a gigabyte carry: editing, driving, and driving by camera.

    python benchmarks/capacity.py [pupils] [seconds]

Each pupil has a page without a browser. Counted is all that the class has started: the class's
server, the pupils' servers and their programs. Memory that several of them share counts once.
"""

import asyncio
import sys
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import AsyncExitStack, asynccontextmanager
from pathlib import Path
from time import perf_counter

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from _class import in_a_class
from _pages import Page, visit
from sessions import PROGRAM, processor_time

from classes import Class, Joined
from hubs import descendants

#: Seconds between two edits of a pupil who writes quickly.
BETWEEN_EDITS = 2.0
#: Searches a tag again and again, so a picture of the camera is looked at all the time.
CAMERA = """\
main:
    while True:
        if function.is_tag(8):
            function.move_straight(40)
        else:
            function.turn_left(23)
        end
        function.sleep(0.1)
    end
end
"""

Work = Callable[[Page], Awaitable[None]]


async def idle(_: Page) -> None:
    """Look at the page."""


async def edit(page: Page) -> None:
    """Change the program again and again."""
    number = 1
    while True:
        number += 1
        text = PROGRAM.replace("150", str(number))
        await page.say("EditText", edit=number, notation="blocktext", text=text)
        await asyncio.sleep(BETWEEN_EDITS)


async def drive(page: Page) -> None:
    """Run an endless program."""
    await page.say("Run")


async def look(page: Page) -> None:
    """Run an endless program that uses the camera."""
    await page.say("EditText", edit=2, notation="blocktext", text=CAMERA)
    await page.say("Run")


WORKS: dict[str, tuple[str, Work]] = {
    "idle": ("avoid", idle),
    "editing": ("avoid", edit),
    "driving": ("avoid", drive),
    "by camera": ("first-tag", look),
}


class Used:
    """What a class and all that it has started use.

    Args:
        room: the class.
    """

    def __init__(self, room: Class) -> None:
        self._server = room.process.pid
        self._began = perf_counter()
        self._before = self._times()

    def _processes(self) -> set[int]:
        return {self._server, *descendants(self._server)}

    def _times(self) -> dict[int, float]:
        return {process: processor_time(process) for process in self._processes()}

    def cores(self) -> float:
        """The processors that were used since the beginning, as a number of cores."""
        spent = sum(
            time - self._before.get(process, 0.0) for process, time in self._times().items()
        )
        return spent / (perf_counter() - self._began)

    def gigabytes(self) -> float:
        """The memory that is used now."""
        return sum(map(proportional, self._processes())) / 1e6


def proportional(process: int) -> int:
    """Return the memory of a process in kB; what it shares counts in parts."""
    lines = Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
    return sum(int(line.split()[1]) for line in lines if line.startswith("Pss:"))


@asynccontextmanager
async def working(pupils: list[Joined], example: str, work: Work) -> AsyncIterator[None]:
    """Have all pupils do this with a project of their own."""
    async with AsyncExitStack() as stack:
        tasks = []
        for pupil in pupils:
            visited = visit(pupil.room, f"/{pupil.address}ws", pupil.cookie)
            socket = await stack.enter_async_context(visited)
            page = Page(socket)
            await page.say("New", name=work.__name__, example=example)
            await page.hear("Scene")
            await page.say("EditText", edit=1, notation="blocktext", text=PROGRAM)
            await page.hear("Saved")
            tasks.append(asyncio.create_task(listening(page, work)))
        # Programs start, and robots begin to drive.
        await asyncio.sleep(5)
        yield
        for task in tasks:
            task.cancel()


async def listening(page: Page, work: Work) -> None:
    """Do something, and read what the server sends meanwhile."""
    async with asyncio.TaskGroup() as tasks:
        tasks.create_task(work(page))
        tasks.create_task(page.hear("Nothing that a server sends"))


async def measure(room: Class, pupils: list[Joined], seconds: float) -> None:
    empty = Used(room).gigabytes()
    print(f"the class alone    {1000 * empty:.0f} MB")
    print("                   cores a pupil   MB a pupil   pupils by core   by GB   all cores")
    for name, (example, work) in WORKS.items():
        async with working(pupils, example, work):
            used = Used(room)
            await asyncio.sleep(seconds)
            cores, gigabytes = used.cores(), used.gigabytes() - empty
        report(name, len(pupils), cores, gigabytes)


def report(name: str, pupils: int, cores: float, gigabytes: float) -> None:
    each = f"{cores / pupils:13.3f} {1000 * gigabytes / pupils:12.0f}"
    print(f"{name:18} {each} {pupils / cores:16.0f} {pupils / gigabytes:7.1f} {cores:11.2f}")


if __name__ == "__main__":
    in_a_class(measure, pupils=6)
