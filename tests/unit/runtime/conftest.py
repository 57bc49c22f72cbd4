"""A tiny simulated robot, and programs run on it by a host."""

import io
import json
import subprocess
import threading
from dataclasses import dataclass, field

import pytest

from learnblock.client import Client
from learnblock.client.readings import Readings
from learnblock.devices import Base, Display, DistanceSensors, Gyroscope
from learnblock.runtime.ending import Ending
from learnblock.runtime.host import Host
from learnblock.runtime.limits import Limits
from learnblock.runtime.pacing import Pacing
from learnblock.runtime.process import ProcessWorker
from learnblock.runtime.program import Program
from learnblock.runtime.recorder import record
from learnblock.runtime.run import Run
from learnblock.runtime.trace import Trace
from listener import Listener
from waiting import SECONDS, wait_for

HEADER = "from learnblock.robots.tiny import Robot\nrobot = Robot()\n"


class TinyWorld:
    """A world in which only time passes."""

    is_over = False

    def __init__(self, dt=0.01, seed=7):
        self.dt, self.seed, self.steps = dt, seed, 0
        self.pacing, self.lock = Pacing(), threading.RLock()

    def advance(self, step):
        while self.steps < step:
            self.pacing.wait(self.steps * self.dt)
            self.steps += 1


class WorldClock:
    def __init__(self, world):
        self._world = world

    @property
    def instant(self):
        return self._world.steps

    def time(self):
        return round(self._world.steps * self._world.dt, 9)

    def sleep(self, seconds):
        raise AssertionError("the host must not sleep")

    def charge(self):
        pass


class TinyRobot(Client):
    """A base, distance sensors that return the step, and a gyroscope."""

    def __init__(self, simulation=None, broken=()):
        self.simulation = simulation
        self.log, self.broken, self.zero = [], broken, 0
        super().__init__(skills=[], clock=WorldClock(simulation) if simulation else None)

    def _make_readings(self):
        # Like a simulated robot in a host: the program's own robot waits for new readings.
        return Readings(self.clock) if self.simulation else super()._make_readings()

    def connect(self):
        self.add(Base(move=self.note("move")))
        self.add(DistanceSensors(read=self.distances))
        self.add(Gyroscope(read=self.angle, reset=self.reset), "Z_AXIS")
        self.add(Display(self.note("show_emotion"), self.note("show_image")))

    def disconnect(self):
        self.log.append(("disconnect",))
        if "disconnect" in self.broken:
            raise OSError("the cable is out")

    def note(self, name):
        return lambda *args: self.tell(name, *args)

    def tell(self, name, *args):
        self.log.append((name, *args))
        if name in self.broken:
            raise OSError("the cable is out")

    def distances(self):
        if "read" in self.broken:
            raise OSError("the cable is out")
        return {"front": [float(self.simulation.steps if self.simulation else 0)]}

    def angle(self):
        return 90.0 - self.zero

    def reset(self):
        self.zero = 90.0
        self.log.append(("reset",))


@dataclass
class Result:
    """The result of a run."""

    run: Run
    output: str
    trace: bytes
    lines: list[int] = field(default_factory=list)
    processes: tuple[int, ...] = ()

    @property
    def ending(self) -> Ending:
        return self.run.ending

    @property
    def how(self):
        return self.run.ending.how

    @property
    def log(self):
        return self.run.client.log

    @property
    def events(self):
        return [json.loads(line) for line in self.trace.splitlines()]

    def wait_until_gone(self):
        """Wait until no process of the run is alive.

        A killed process must be scheduled once more before it disappears.
        """
        wait_for(lambda: not any(map(alive, self.processes)), "none of its processes is left")


def alive(group):
    """Whether a process of the group still runs; a zombie does not."""
    states = subprocess.run(
        ["ps", "-A", "-o", "pgid=,stat="], capture_output=True, text=True, check=True
    ).stdout
    return any(
        state.split()[0] == str(group) and not state.split()[1].startswith("Z")
        for state in states.splitlines()
    )


class Stage:
    """Programs to run in one world."""

    def __init__(self):
        self.world = TinyWorld()
        self.workers, self.parts = [], []

    def add(
        self,
        source,
        *,
        header=HEADER,
        worker=ProcessWorker,
        limits=None,
        real=False,
        broken=(),
        answers=(),
        watcher=None,
        debugger=None,
        label=None,
        make_robot=None,
        folder="",
        robots=(),
        network=False,
        log=None,
    ):
        text = header + source
        file = io.BytesIO()
        listener = watcher or Listener(answers)

        def make_worker():
            self.workers.append(worker())
            return self.workers[-1]

        def make(_module, arguments):
            return TinyRobot(None if real else self.world, broken, **arguments)

        run = Run(
            Program("tiny.py", text, text, folder=folder),
            make_robot or make,
            lambda client: record(client, "tiny", Trace(file), label),
            watcher=listener,
            debugger=debugger,
            limits=limits,
            worker=make_worker,
            robots=robots,
            network=network,
            log=log,
        )
        self.parts.append((run, listener, file))
        return run

    def host(self, seconds=None):
        return Host(*(run for run, _, _ in self.parts), seconds=seconds)

    def results(self):
        groups = tuple(
            worker.process for worker in self.workers if isinstance(worker, ProcessWorker)
        )
        return [
            Result(run, "".join(listener.text), file.getvalue(), listener.numbers, groups)
            for run, listener, file in self.parts
        ]


@pytest.fixture(autouse=True)
def ended_threads():
    """Fail if a program goes on in a thread: it would compute beside all later tests."""
    yield
    for thread in threading.enumerate():
        if thread.name == "program":
            thread.join(SECONDS)
            assert not thread.is_alive()


@pytest.fixture
def stage(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    return Stage()


@pytest.fixture
def run(stage):
    """Run a program on the tiny robot, and return the `Result`."""

    def run(source, *, seconds=None, **options):
        stage.add(source, **options)
        stage.host(seconds).run()
        (result,) = stage.results()
        return result

    return run


@pytest.fixture
def impatient():
    """Limits for programs that do not end.

    They count what a program itself does, so that a busy machine does not matter.
    """
    return Limits(silence=0.3, blocked=0.5)
