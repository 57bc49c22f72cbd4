"""Measure whether a day of runs costs the server memory or descriptors.

    python benchmarks/runs.py [runs]

A page runs a short program again and again. After the first tenth of the runs, the server's memory
and open descriptors should stay as they are.
"""

import asyncio
import os
import platform
import sys
from pathlib import Path
from time import perf_counter

from websockets.asyncio.client import connect

sys.path.insert(0, str(Path(__file__).parent))

from _pages import Page
from sessions import TOKEN, children, megabytes, serving

PROGRAM = (
    'main:\n    function.move_straight(100)\n    function.sleep(0.05)\n    print("done")\nend\n'
)


async def measure(port: int, server: int, runs: int) -> None:
    address = f"ws://127.0.0.1:{port}/ws"
    async with connect(address, subprotocols=["learnblock", TOKEN], max_size=None) as socket:
        page = Page(socket)
        await page.say("New", name="day")
        await page.hear("Scene")
        await page.say("EditText", edit=1, notation="blocktext", text=PROGRAM)
        print("    runs        MB  descriptors  children  seconds a run")
        began = perf_counter()
        for done in range(1, runs + 1):
            await page.say("Run")
            await page.hear("Ended")
            if done % max(1, runs // 10) == 0:
                report(server, done, (perf_counter() - began) / done)


def report(server: int, done: int, spent: float) -> None:
    open_now = len(list(Path(f"/proc/{server}/fd").iterdir()))
    print(
        f"{done:8} {megabytes(server):9.1f} {open_now:12} {len(children(server)):9} {spent:14.2f}",
        flush=True,
    )


def main() -> None:
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
    print(f"Python {platform.python_version()}, {os.cpu_count()} processors, {runs} runs")
    with serving() as (port, server):
        asyncio.run(measure(port, server, runs))


if __name__ == "__main__":
    main()
