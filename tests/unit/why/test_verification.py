"""A log from elsewhere is checked before anything shows it."""

import itertools
import json

import msgspec
import pytest

from learnblock.errors import LearnBlockError
from learnblock.runtime.log.blocks import MAGIC, EventBlock, EventStream
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.program import Program
from learnblock.why import verification
from learnblock.why.verification import verified
from logged_runs import logged_blocks

ROBOT = {"drivers": {}, "world": {"name": "empty", "floor": {"size": [1000, 1000]}}}
RUN = {"robot": "sim-ebo", "world": "empty", "seed": 0}


def file(*blocks):
    return MAGIC + b"".join(map(bytes, blocks))


def made(*lines, events=b"", text="x = 1\n"):
    """A log with these lines of its world and these events."""
    log = RunLog(Program("x", text, text))
    for line in lines:
        log.happened(0.0, json.dumps(line).encode() + b"\n")
    if events:
        log.noted(0, 0, events)
    return log.blocks


def test_a_run_of_ours_is_sound_and_has_a_world():
    found = verified(file(*logged_blocks("avoid.bt", "sim-ebo", seconds=3)))
    assert found.has_world
    assert found.complete_since == 0
    assert found.recorded.ending["time"] == 3


def test_a_file_that_was_cut_off_is_read_up_to_there():
    data = file(*logged_blocks("avoid.bt", "sim-ebo", seconds=3))
    assert verified(data[:-200]).recorded.ending == {}


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"PK\x03\x04",
        MAGIC,
        MAGIC + b"\0" * 100,
        file(EventBlock(EventStream.HEADER, 0, 0, b"not compressed")),
        file(EventBlock.of(EventStream.HEADER, 0, 0, b"\x91" * 100_000)),
        file(*made({"run": RUN}, {"t": "soon", "print": "x"})),
        file(*made({"run": RUN}, {"t": -5, "print": 1}, {"t": 1e300, "print": "x"})),
        file(*made({"run": RUN}, {"pose": [1, 2, 3]})),
        file(*made({"run": RUN}, {"t": 0.0, "pose": [1, 2]})),
        file(*made({"run": RUN}, {"t": 0.0, "odometry": ["a", 2, 3]})),
        file(*made(events=msgspec.msgpack.encode([[2, 7, True]]))),
        file(*made(events=msgspec.msgpack.encode([[2, -1, True]]))),
        file(*made(events=msgspec.msgpack.encode([[2]]))),
        file(*made(events=b"\x91" * 50_000)),
        file(*made(events=msgspec.msgpack.encode(7))),
        file(*made({"robot": {**ROBOT, "world": {**ROBOT["world"], "name": "/etc/x"}}})),
        file(
            *made(
                {"robot": ROBOT},
                {"run": RUN},
                {"t": 0.0, "device": "Base", "key": "x", "do": "move", "args": []},
                {"t": 1.0, "print": "x"},
            )
        ),
    ],
)
def test_what_is_no_sound_log_is_refused(data):
    with pytest.raises(LearnBlockError, match="not the log of a run"):
        verified(data)


def test_a_file_that_unpacks_to_too_much_is_refused(monkeypatch):
    monkeypatch.setattr(verification, "MOST_DATA", 1_000_000)
    bomb = [EventBlock.of(EventStream.WORLD, 0, 0, b" " * 400_000)] * 3
    assert len(file(*bomb)) < 10_000
    with pytest.raises(LearnBlockError, match="too large"):
        verified(file(*made(), *bomb))


def test_a_file_that_is_too_large_is_refused(monkeypatch):
    monkeypatch.setattr(verification, "LARGEST", 100)
    with pytest.raises(LearnBlockError, match="too large"):
        verified(MAGIC + b"\0" * 100)


def test_a_world_that_takes_too_long_is_refused():
    data = file(*logged_blocks("avoid.bt", "sim-ebo", seconds=3))
    clock = itertools.count(step=2 * verification.PATIENCE)
    with pytest.raises(LearnBlockError, match="longer than 20 s"):
        verified(data, now=lambda: next(clock))


def test_a_world_that_is_not_here_is_not_shown():
    floor = {"size": [1000, 1000], "picture": "floor.png"}
    world = {"name": "far away", "floor": floor}
    found = verified(file(*made({"robot": {**ROBOT, "world": world}}, {"run": RUN})))
    assert not found.has_world
