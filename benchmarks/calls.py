"""Measure the cost of a call: in one process, and between a program and its robot's host.

Run it with ``python benchmarks/calls.py``. It prints microseconds, and the ratio to the same
work without LearnBlock: a bare function call, and a bare byte sent to another process and back.
"""

import socket
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable
from pathlib import Path
from time import perf_counter

from learnblock.client import Client
from learnblock.devices import Base, DistanceSensors
from learnblock.runtime.host import Host
from learnblock.runtime.pacing import Pacing
from learnblock.runtime.process import ProcessWorker
from learnblock.runtime.program import Program
from learnblock.runtime.recorder import record
from learnblock.runtime.run import Run
from learnblock.runtime.trace import Trace
from learnblock.runtime.watcher import Watcher
from learnblock.testing import VirtualClock

ROUNDS = 5
#: The limits in microseconds, and in milliseconds for the start.
AIMS = {"skill": 5.0, "read": 60.0, "move": 60.0, "sleep": 60.0, "start": 100.0}

PROGRAM = """
from learnblock.robots.fake import Robot
from learnblock.devices import Base, DistanceSensors
# The program's own `time` is the robot's: this one is the wall clock.
from _datetime import datetime

robot = Robot()
base, sensors = robot.device(Base), robot.device(DistanceSensors)

def cost(name, work):
    best = 1e9
    for _ in range({rounds}):
        began = datetime.now()
        for _ in range(1000):
            work()
        best = min(best, (datetime.now() - began).total_seconds() * 1000)
    print(name, best)

for name, work in dict(
    read=sensors.read,
    move=lambda: base.move(10, 0),
    sleep=lambda: robot.clock.sleep(0.01),
).items():
    cost(name, work)
    robot.clock.sleep(0.01)
def count():
    total = 0
    for number in range(450):
        total += number
best = 1e9
for _ in range({rounds} * 10):
    robot.clock.sleep(0.01)
    began = datetime.now()
    count()
    robot.clock.sleep(0.01)
    best = min(best, (datetime.now() - began).total_seconds() * 1e6 / 900)
print("line", best)
"""


class World:
    """A world in which nothing happens."""

    dt, seed, steps = 0.01, 0, 0

    def __init__(self) -> None:
        self.pacing, self.lock = Pacing(), threading.RLock()

    def advance(self, step: int) -> None:
        self.steps = step


class FakeRobot(Client):
    """A robot whose devices do nothing, in virtual time or in a world."""

    sensing_period = None

    def __init__(self, world: World | None = None, skills: tuple[str, ...] = ()) -> None:
        self.simulation = world
        super().__init__(skills=skills, clock=VirtualClock())

    def connect(self) -> None:
        self.add(Base(_move))
        self.add(DistanceSensors(lambda: {"front": [100.0]}))


class Printer(Watcher):
    """Store what the program prints, which are its measurements."""

    def __init__(self) -> None:
        self.figures: dict[str, float] = {}

    def printed(self, text: str) -> None:
        name, figure = text.split()
        self.figures[name] = float(figure)


def _move(adv: float, rot: float) -> None:
    pass


def cost(work: Callable[[], object], times: int = 20_000) -> float:
    """Return the microseconds of one call in the fastest round."""
    best = float("inf")
    for _ in range(ROUNDS):
        began = perf_counter()
        for _ in range(times):
            work()
        best = min(best, perf_counter() - began)
    return best / times * 1e6


def in_process() -> dict[str, float]:
    """Measure a skill's way through the three layers, next to the function at its end."""
    with FakeRobot(skills=("move_straight",)) as robot:
        return {"bare": cost(lambda: _move(40, 0)), "skill": cost(robot.move_straight)}


def over_the_link() -> dict[str, float]:
    """Measure from a program in a separate process."""
    world, printer = World(), Printer()
    text = PROGRAM.replace("{rounds}", str(ROUNDS))
    run = Run(
        Program("calls.py", text, text),
        lambda _module, _arguments: FakeRobot(world),
        lambda client: record(client, "calls", Trace()),
        watcher=printer,
    )
    Host(run).run()
    assert run.ending is not None  # noqa: S101
    if not run.ending.well:
        raise SystemExit(run.ending.sentence)
    return printer.figures


def bare_round_trip() -> float:
    """Send a byte to another Python process and back, as the link does."""
    ours, theirs = socket.socketpair()
    echo = (
        "import socket, sys\n"
        "s = socket.socket(fileno=int(sys.argv[1]))\n"
        "while data := s.recv(4096): s.sendall(data)\n"
    )
    with (
        ours,
        subprocess.Popen(
            [sys.executable, "-c", echo, str(theirs.fileno())], pass_fds=(theirs.fileno(),)
        ) as process,
    ):
        theirs.close()

        def there_and_back() -> None:
            ours.sendall(b"x" * 20)
            ours.recv(4096)

        there_and_back()
        figure = cost(there_and_back, 2000)
        ours.shutdown(socket.SHUT_RDWR)
        process.wait()
    return figure


class FirstLine(Watcher):
    """Record when the program's first print arrived."""

    def __init__(self) -> None:
        self.at = 0.0

    def printed(self, text: str) -> None:  # noqa: ARG002 - when, not what
        self.at = self.at or perf_counter()


def start() -> float:
    """Return the milliseconds from the start to a program's first line, in the fastest round."""
    text = "print('here')\nfrom learnblock.robots.fake import Robot\nRobot().move_straight()\n"
    best = float("inf")
    for _ in range(ROUNDS):
        first, world = FirstLine(), World()
        began = perf_counter()
        run = Run(
            Program("start.py", text, text),
            lambda _module, _arguments, world=world: FakeRobot(world),
            lambda client: record(client, "start", Trace()),
            watcher=first,
            worker=ProcessWorker,
        )
        Host(run).run()
        best = min(best, first.at - began)
    return best * 1000


def bare_start() -> float:
    """Return the milliseconds that Python itself needs to start and end."""
    best = float("inf")
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "nothing.py"
        script.touch()
        for _ in range(ROUNDS):
            began = perf_counter()
            subprocess.run([sys.executable, str(script)], check=True)
            best = min(best, perf_counter() - began)
    return best * 1000


def tell(name: str, figure: float, unit: str, bare: float, *, aim: float | None = None) -> None:
    verdict = "" if aim is None else f"  (aim {aim:g}: {'met' if figure <= aim else 'MISSED'})"
    print(f"{name:24} {figure:8.2f} {unit}  {figure / bare:6.1f} times bare{verdict}")


def main() -> None:
    local = in_process()
    print(f"{'bare device function':24} {local['bare']:8.2f} us")
    tell("skill in one process", local["skill"], "us", local["bare"], aim=AIMS["skill"])
    trip = bare_round_trip()
    print(f"{'bare round trip':24} {trip:8.2f} us")
    link = over_the_link()
    for name in ("read", "move", "sleep"):
        tell(f"{name} over the link", link[name], "us", trip, aim=AIMS[name])
    print(f"{'line, to the trace':24} {link['line']:8.2f} us")
    python = bare_start()
    print(f"{'start of bare Python':24} {python:8.2f} ms")
    tell("start to first line", start(), "ms", python, aim=AIMS["start"])


if __name__ == "__main__":
    main()
