"""Measure the cost of watching and controlling a run, and how soon a command takes effect.

Run it with ``python benchmarks/debugging.py``. A debugged program should take less than
twice the time of another one, and a pause less than 100 ms, whatever the program does.
"""

import queue
import threading
from collections.abc import Callable
from itertools import count
from statistics import median
from time import perf_counter

from learnblock import robots, running
from learnblock.monitor.making import make_monitor
from learnblock.running import Job, ProgramRun
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.program import Program
from learnblock.runtime.watcher import Watcher

ROUNDS = 5
HEADER = """\
from learnblock.robots.sim_ebo import Robot

robot = Robot()
"""
TIGHT_LOOP = HEADER + "n = 0\nwhile n < 1000000:\n    n += 1\n"
CALLS = HEADER + "for n in range(5000):\n    robot.move_straight(n % 100)\n    robot.sleep(0.02)\n"
SLEEP = HEADER + "print('here')\nrobot.sleep(1000)\n"
THOUGHT = HEADER + "print('here')\nn = 0\nwhile n < 10 ** 9:\n    n += 1\n"


class States(Watcher):
    """Pass messages to another thread."""

    def __init__(self) -> None:
        self.told: queue.Queue[str] = queue.Queue()

    def state(self, state: str) -> None:
        self.told.put(str(state))

    def printed(self, text: str) -> None:
        self.told.put(text.strip())

    def wait_for(self, *wanted: str) -> None:
        while self.told.get(timeout=10) not in wanted:
            continue


def best(work: Callable[[], object]) -> float:
    """Return the shortest of several times, in seconds."""
    times = []
    for _ in range(ROUNDS):
        began = perf_counter()
        work()
        times.append(perf_counter() - began)
    return min(times)


def cost(name: str, program: Program) -> None:
    job = Job(program, robots.find("sim-ebo"))
    plain, debugged = (
        best(lambda make=make: ProgramRun(job, debugger=make()).run())  # type: ignore[misc]
        for make in (lambda: None, Debugger)
    )
    print(f"{name:28} {plain:6.3f} s, debugged {debugged:6.3f} s: {debugged / plain:.2f} times")


def pause(name: str, source: str) -> None:
    times = [pause_once(source) for _ in range(10)]
    print(f"{name:28} {median(times) * 1000:6.1f} ms, at most {max(times) * 1000:.1f} ms")


def pause_once(source: str) -> float:
    states = States()
    program = Program("program.py", source, source)
    job = Job(program, robots.find("sim-ebo"))
    session = ProgramRun(job, watcher=states, debugger=Debugger())
    session.set_speed(1.0)
    thread = threading.Thread(target=session.run)
    thread.start()
    states.wait_for("here")
    began = perf_counter()
    session.pause()
    # A sleeping program pauses with its world; a calculating one pauses at its next line.
    states.wait_for("paused" if source == SLEEP else "held")
    taken = perf_counter() - began
    session.stop()
    thread.join()
    return taken


def looks() -> None:
    monitor = make_monitor(robots.find("sim-ebo"), "tags")
    print(f"{'the state of a world':28} {best(monitor.state) * 1000:6.2f} ms")
    heading = count()

    def look() -> None:
        monitor.place(0, 0, next(heading))
        monitor.camera()

    print(f"{'a picture, and what is in it':28} {best(look) * 1000:6.2f} ms")


def main() -> None:
    square = running.program(running.read(running.example("square.bt")), robots.find("sim-ebo"))
    cost("square.bt", square)
    cost("5,000 times move and sleep", Program("calls.py", CALLS, CALLS))
    cost("1,000,000 times n += 1", Program("loop.py", TIGHT_LOOP, TIGHT_LOOP))
    pause("pause while it sleeps", SLEEP)
    pause("pause while it thinks", THOUGHT)
    looks()


if __name__ == "__main__":
    main()
