"""Run programs in tests: from a file, a robot and a world to a report and a recorder."""

import io
import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import msgspec

from learnblock import robots, running
from learnblock.errors import Diagnostic
from learnblock.running import Job, Options, ProgramRun, Report
from learnblock.running.recorded_keys import RecordedKeys, read_keys
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.process import ThreadWorker
from learnblock.runtime.recorder import Recorder
from learnblock.runtime.watcher import Watcher
from learnblock.simulator.geometry import wrapped
from places import ROOT

EXAMPLES = ROOT / "examples"
TWINS = (
    "sim-ebo",
    "sim-thymio",
    "sim-ev3",
    "sim-cozmo",
    "sim-spike",
    "sim-legoed",
    "sim-root",
    "sim-create3",
)
#: The world for which an example is meant; by default the robot's own.
WORLDS = {
    "avoid.bt": "obstacles",
    "imitate.bt": "faces",
    "labyrinth.bt": "labyrinth",
    "line-ebo.bt": "line",
    "line-states.bt": "line",
    "line-thymio.bt": "line",
    "tag-tour.bt": "tags",
    "tags.bt": "tags",
    "wall.bt": "walls",
}

#: The world in which the purpose of an example is a goal, and the seconds it may take.
TASKS = {
    "avoid.bt": ("arena", 40),
    "dance.bt": ("stage", 10),
    "first/bump.bt": ("bumper", 30),
    "first/caught.bt": ("run-away", 20),
    "first/circle.bt": ("patrol", 60),
    "first/corner.bt": ("heading", 12),
    "first/distance.bt": ("distance", 12),
    "first/edge.bt": ("edge", 30),
    "first/face.bt": ("face-ahead", 30),
    "first/feelings.bt": ("stage", 10),
    "first/guess.bt": ("applause", 60),
    "first/line.bt": ("line", 145),
    "first/park.bt": ("parking", 30),
    "first/pid.bt": ("line", 145),
    "first/quiz.bt": ("applause", 10),
    "first/reaction.bt": ("applause", 10),
    "first/red-line.bt": ("red-line", 140),
    "first/square.bt": ("square", 60),
    "first/tag.bt": ("tag-ahead", 30),
    "first/there-and-back.bt": ("patrol", 60),
    "first/timer.bt": ("distance", 12),
    "first/traffic-light.bt": ("patrol", 60),
    "first/turn-away.bt": ("arena", 40),
    "flower.bt": ("flower", 200),
    "games/collector.bt": ("stars", 40),
    "games/delivery.bt": ("delivery", 175),
    "games/drawing.bt": ("drawing", 100),
    "games/football.bt": ("penalty", 115),
    "games/landing.bt": ("landing", 30),
    "games/maze.bt": ("maze-clock", 115),
    "games/race.bt": ("race-track", 95),
    "games/simon.bt": ("simon", 40),
    "games/stars.bt": ("stars", 85),
    "games/sumo.bt": ("sumo-barrels", 115),
    "games/tag.bt": ("tag", 85),
    "imitate.bt": ("faces", 50),
    "labyrinth.bt": ("labyrinth", 150),
    "line-ebo.bt": ("line", 145),
    "line-states.bt": ("line", 145),
    "line-thymio.bt": ("line", 145),
    "melody.bt": ("stage", 20),
    "patrol.bt": ("patrol", 65),
    "polygons.bt": ("polygons", 100),
    "remote-control.bt": ("square", 30),
    "square.bt": ("square", 60),
    "tag-tour.bt": ("tags", 100),
    "tags.bt": ("tags", 62),
    "wall.bt": ("walls", 50),
    "watch-out.bt": ("table", 50),
}

#: Seconds of an example that are enough to tell two runs apart.
FEW = 8


@dataclass(frozen=True)
class Finished:
    """A finished run."""

    report: Report
    recorder: Recorder
    trace: bytes

    def entries(self, kind: str) -> list[dict[str, object]]:
        """Return the lines of the trace of one kind."""
        lines = (msgspec.json.decode(line) for line in self.trace.splitlines())
        return [line for line in lines if kind in line]


#: What a person answers to the questions of an example.
ANSWERS = {
    "first/guess.bt": [str(number) for number in range(1, 21)],
    "first/quiz.bt": ["Madrid", "Paris", "Rome"],
    "first/reaction.bt": [""],
}


#: What a person does with the robot of an example, each at a time in seconds.
HANDS = {"first/caught.bt": [(1.0, "shake"), (10.0, "left"), (12.0, "level")]}


#: Where a person steers the robot of an example with the arrow keys, mm.
WAYS = {
    "games/delivery.bt": [
        *((500, 0), (-700, 0), (-700, 400), (500, 400), (0, 0), (-700, 0), (-700, -400)),
        (500, -400),
    ],
    "games/drawing.bt": [
        *((-250, -250), (250, -250), (250, 150), (0, 400), (-250, 150), (-250, -250)),
    ],
    "games/football.bt": [
        *((800, 0), (400, -400), (-400, -400), (-500, 0), (800, 0)),
    ],
    "games/race.bt": [(600, -300), (600, 300), (-600, 300), (-600, -300)] * 2 + [(0, -300)],
    "games/maze.bt": [
        (-700, -300),
        (-700, 350),
        (-100, 350),
        (100, 300),
        (100, -400),
        (700, -400),
        (1000, -400),
    ],
    "games/stars.bt": [(-350, 0), (50, 0), (450, 0), (450, 400), (50, 400), (-350, 400)],
    "games/sumo.bt": [(470, 0), (0, 0), (-235, 407), (0, 0), (-235, -407)],
    "games/tag.bt": [(300, 0)],
}
#: The keys with which a person answers in an example, each after one more point.
TUNE = ("left", "right", "up", "left")
REPLIES = {"games/simon.bt": [key for end in range(1, 5) for key in TUNE[:end]]}
#: mm and degrees within which a person takes a place as reached, and a direction as right.
NEAR, STRAIGHT = 45, 8


class Presser(Watcher):
    """Holds down recorded keys."""

    def __init__(self, keys: RecordedKeys) -> None:
        self._keys = keys

    def held_keys(self, time):
        return self._keys.held(time)


class Answerer(Watcher):
    """Answers one question after another."""

    def __init__(self, answers: Iterable[str]) -> None:
        self._answers = iter(answers)
        self.output = ""

    def printed(self, text):
        self.output += text

    def input(self, prompt):
        del prompt
        return next(self._answers, None)


class Holder(Watcher):
    """Shakes and tilts the twin of a run.

    Args:
        moves: what to do, each at a time in seconds.
    """

    #: The run; the person waits until there is one.
    session: ProgramRun | None = None

    def __init__(self, moves: Iterable[tuple[float, str]]) -> None:
        self._moves = list(moves)

    def tick(self):
        twin = self.session.client if self.session else None
        while twin and self._moves and twin.clock.time() >= self._moves[0][0]:
            twin.simulation.handle(twin.name, self._moves.pop(0)[1])


class Pilot(Holder):
    """Steers the twin of a run with the arrow keys.

    Args:
        places: where to drive, in order, mm.
    """

    def __init__(self, places: Iterable[tuple[float, float]]) -> None:
        super().__init__(())
        self._places = list(places)

    def held_keys(self, time):
        del time
        twin = self.session.client if self.session else None
        return [key] if twin and (key := self._key(*twin.where())) else []

    def _key(self, x, y, heading):
        while self._places and math.dist((x, y), self._places[0]) < NEAR:
            self._places.pop(0)
        if not self._places:
            return None
        east, north = self._places[0][0] - x, self._places[0][1] - y
        off = wrapped(-math.degrees(math.atan2(north, east)) - heading)
        return "up" if abs(off) < STRAIGHT else "right" if off > 0 else "left"


class Replier(Holder):
    """Presses one key again and again, and the next one when the twin of a run has one more point.

    Args:
        keys: the keys, in order.
    """

    def __init__(self, keys: Iterable[str]) -> None:
        super().__init__(())
        self._keys = list(keys)

    def held_keys(self, time):
        twin = self.session.client if self.session else None
        points = twin.simulation.world.game.scores.standing(twin.name, time).score if twin else 0
        # Each answer is a press, not a key that stays down.
        return self._keys[int(points) :][:1] if int(time * 2) % 2 else []


def person(name: str) -> Watcher:
    """Return who steers or handles the robot of an example, presses keys or answers, if needed."""
    if name in HANDS:
        return Holder(HANDS[name])
    if name in WAYS:
        return Pilot(WAYS[name])
    if name in REPLIES:
        return Replier(REPLIES[name])
    keys = (EXAMPLES / name).with_suffix(".jsonl")
    return Presser(read_keys(keys)) if keys.exists() else Answerer(ANSWERS.get(name, ()))


def refusal(name: str, robot: str) -> list[Diagnostic]:
    """Return the errors of the check, which prevent an example from running on a robot."""
    diagnostics = running.check(running.read(EXAMPLES / name), robots.find(robot))
    return [diagnostic for diagnostic in diagnostics if diagnostic.severity == "error"]


def able_twin(name: str) -> str:
    """Return the first twin that can run an example."""
    return next(robot for robot in TWINS if not refusal(name, robot))


def run_file(path: Path, robot: str, *, worker=None, watcher=None, **options) -> Finished:
    """Run a program's file to its end; the kind of worker does not change its trace."""
    source = running.read(path)
    entry = robots.find(robot)
    # A real robot goes on while its program computes.
    worker = worker or (InlineWorker if entry.load().lockstep else ThreadWorker)
    trace = io.BytesIO()
    session = ProgramRun(
        Job(running.program(source, entry), entry, Options(**options)),
        trace=trace,
        worker=worker,
        watcher=watcher,
        lacking=partial(running.lacking, source),
    )
    if isinstance(watcher, Holder):
        watcher.session = session
    report = session.run()
    assert session.recorder or report.error
    return Finished(report, session.recorder, trace.getvalue())


def run_example(name: str, robot: str, *, watcher=None, **options) -> Finished:
    """Run one of the examples, with its `person`."""
    return run_file(EXAMPLES / name, robot, watcher=watcher or person(name), **options)
