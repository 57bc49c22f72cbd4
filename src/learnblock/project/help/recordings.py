"""What happens in the example of each block, for the moving picture in its help.

``python -m learnblock.project.help.recordings`` runs the examples on simulated robots and writes
``recorded/recordings.json``. The same program always does the same there, so a test can compare.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple

import msgspec

from learnblock import robots, running
from learnblock.i18n import Phrase
from learnblock.project.help.examples import HelpExample, examples
from learnblock.running.batch import Batch
from learnblock.running.job import Job, Options
from learnblock.running.recorded_keys import RecordedKeys
from learnblock.runtime.program import Program
from learnblock.storage.learned_types import learned

_FILE = Path(__file__).parent / "recorded" / "recordings.json"
#: The most events that are kept: a loop has been understood by then.
_MOST_EVENTS = 40
#: mm and degrees that nobody sees in a small picture.
_NEAR = 2.5
#: The device whose commands are seen in the way.
_WHEELS = "Base"


class Waypoint(NamedTuple):
    """Where a robot was: seconds, mm, and degrees, as in a trace."""

    time: float
    x: float
    y: float
    heading: float


class Noticed(NamedTuple):
    """Something that happens in a recording.

    Args:
        time: seconds from the start.
        kind: ``line`` if a line of the program ran, ``print`` if it printed; else what a device was
            told, such as ``Display.show_emotion``.
        text: the number of the line in the Block-Text, from 1; what was printed; or the arguments.
    """

    time: float
    kind: str
    text: str


class HelpRecording(msgspec.Struct, frozen=True, kw_only=True):
    """A run of an example.

    Args:
        robot: the simulated robot.
        world: the name of the example's world.
        program: the Block-Text that ran.
        way: where the robot was; between two places it went evenly.
        events: what happened, in order.
    """

    robot: str
    world: str
    program: str
    way: tuple[Waypoint, ...]
    events: tuple[Noticed, ...]


@cache
def recordings() -> Mapping[str, HelpRecording]:
    """The recordings of all built-in blocks, by the blocks' names in block sets."""
    return msgspec.json.decode(_FILE.read_bytes(), type=learned(dict[str, HelpRecording]))


def record(by_name: Mapping[str, HelpExample]) -> Iterator[tuple[str, HelpRecording]]:
    """Run examples; yield the recording of each by its name, as the runs end."""
    jobs = [_job(example) for example in by_name.values()]
    names = list(by_name)
    for number, result in Batch(jobs).results():
        name, job = names[number], jobs[number]
        lines = list(map(msgspec.json.decode, result.trace.splitlines()))
        yield name, _recording(by_name[name], job, lines)


def _job(example: HelpExample) -> Job:
    source = running.source_of(Path("example.bt"), example.program, is_python=False)
    robot = _robot(source)
    options = Options(
        world=str(example.world_file),
        seed=0,
        pace="free",
        seconds=example.seconds,
        anyway=True,
    )
    key_states = tuple((time, (key,) if key else ()) for time, key in example.keys)
    keys = RecordedKeys(key_states) if key_states else None
    return Job(running.program(source, robot), robot, options, keys, with_trace=True)


def _robot(source: running.Source) -> robots.RobotEntry:
    """The first simulated robot that lacks the least of what a program needs."""
    lacks = {
        name: len(verdict.missed + verdict.refused)
        for name, verdict in running.runs_on(source).items()
        if name.startswith("sim-") and not isinstance(verdict, Phrase)
    }
    return robots.find(min(lacks, key=lambda name: lacks[name]))


def _recording(example: HelpExample, job: Job, lines: Sequence[Mapping[str, Any]]) -> HelpRecording:
    return HelpRecording(
        robot=job.robot.name,
        world=example.world,
        program=example.program,
        way=tuple(_way(lines)),
        events=tuple(islice(_events(lines, job.program), _MOST_EVENTS)),
    )


def _way(lines: Iterable[Mapping[str, Any]]) -> list[Waypoint]:
    """Where the robot was, without the places between that follow from those before and after."""
    places = [Waypoint(line["t"], *map(round, line["pose"])) for line in lines if "pose" in line]
    waypoints = places[:1]
    start = 0
    for end in range(2, len(places)):
        if not all(
            _is_between(waypoints[-1], place, places[end]) for place in places[start + 1 : end]
        ):
            start = end - 1
            waypoints.append(places[start])
    return [*waypoints, *places[-1:]]


def _is_between(before: Waypoint, place: Waypoint, after: Waypoint) -> bool:
    """Whether a robot that goes evenly from one place to another is there on its way."""
    part = (place.time - before.time) / (after.time - before.time)
    expected = (start + part * (end - start) for start, end in zip(before, after, strict=True))
    return all(abs(a - b) <= _NEAR for a, b in zip(place, expected, strict=True))


def _events(lines: Iterable[Mapping[str, Any]], program: Program) -> Iterator[Noticed]:
    """What the picture shows; a line that goes on, such as a wait, begins once."""
    last = 0
    for line in lines:
        if "line" in line:
            number = program.written_line(line["line"])
            if number != last:
                yield Noticed(line["t"], "line", str(number))
            last = number
        elif "print" in line:
            yield Noticed(line["t"], "print", line["print"].rstrip("\n"))
        elif line.get("device", _WHEELS) != _WHEELS:
            arguments = " ".join(map(str, line["args"]))
            yield Noticed(line["t"], f"{line['device']}.{line['do']}", arguments)


def _write() -> None:
    by_name = dict(sorted(record(examples())))
    _FILE.write_bytes(msgspec.json.encode(by_name))


if __name__ == "__main__":
    _write()
