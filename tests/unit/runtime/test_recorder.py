import io
import json

import numpy as np
import pytest

from learnblock.devices import Base, Display, Speaker
from learnblock.runtime.recorder import PlacedEvent, Recorder, record
from learnblock.runtime.trace import Trace
from learnblock.testing import FakeRobot


@pytest.fixture
def file():
    return io.BytesIO()


@pytest.fixture
def recorder(file):
    return Recorder(Trace(file), lambda: 1.5, lambda: (1.0, 2.0, 3.0))


def written(file):
    return [json.loads(line) for line in file.getvalue().splitlines()]


def test_steps_of_one_time_are_written_as_if_one_by_one(file, recorder):
    recorder.steps((3, 'say "hé"', 10))
    together = file.getvalue()
    file.truncate(0)
    file.seek(0)
    recorder.line(3)
    recorder.called('say "hé"', (), {})
    recorder.line(10)
    assert together == file.getvalue()


def test_lines_carry_the_label_of_their_robot(file):
    Recorder(Trace(file), lambda: 0.25, lambda: None, {"robot": "a"}).steps((3, 4))
    assert written(file) == [
        {"t": 0.25, "line": 3, "robot": "a"},
        {"t": 0.25, "line": 4, "robot": "a"},
    ]


def test_a_stroke_of_a_pen_is_written_with_its_look(file, recorder):
    recorder.stroke(2.0, [(0.0, 0.5), (3.0, 0.5)], (200, 0, 0), 6.0)
    assert written(file) == [
        {"t": 2.0, "stroke": [[0.0, 0.5], [3.0, 0.5]], "color": [200, 0, 0], "width": 6.0}
    ]


def test_a_pen_that_can_draw_no_further_is_reported(file, recorder):
    recorder.drawing_full(3.0)
    assert written(file) == [{"t": 3.0, "drawing": "full"}]
    assert recorder.missed == {("pen_down", "Pen:full"): 1}


def test_calls_are_written_with_plain_arguments(file, recorder):
    recorder.called("turn", (90, np.float64(1.5), object()), {"to": (1, 2)})
    recorder.called("stop_bot", (), {})
    assert written(file) == [
        {
            "t": 1.5,
            "call": "turn",
            "args": [90, 1.5, "<object object>"],
            "kwargs": {"to": [1, 2]},
        },
        {"t": 1.5, "call": "stop_bot", "args": []},
    ]


def test_prints_poses_goals_and_the_end_are_written(file, recorder):
    recorder.printed("hello\n")
    recorder.pose(0.5, (1.23456, -0.0, 90.0))
    recorder.goal(0.75, "home", "reached")
    recorder.end("finished")
    assert written(file) == [
        {"t": 1.5, "print": "hello"},
        {"t": 0.5, "pose": [1.235, 0.0, 90.0]},
        {"t": 0.75, "goal": "home", "state": "reached"},
        {"t": 1.5, "end": "finished"},
    ]
    assert recorder.path == [(0.5, (1.23456, -0.0, 90.0))]
    assert recorder.marks[-1] == PlacedEvent(1.5, "end", "finished", (1.0, 2.0, 3.0))


@pytest.fixture
def robot():
    with FakeRobot() as robot:
        yield robot


def test_commands_to_devices_are_recorded_and_executed(file, robot):
    record(robot, "program", Trace(file))
    robot.device(Base).move(10, 0)
    robot.device(Speaker).say("hello")
    assert written(file)[1:] == [
        {"t": 0.0, "device": "Base", "key": "ROBOT", "do": "move", "args": [10.0, 0.0]},
        {"t": 0.0, "device": "Speaker", "key": "ROBOT", "do": "say", "args": ["hello"]},
    ]
    assert robot.commands == [("Base.move", 10.0, 0.0), ("Speaker.say", "hello")]


def test_a_lasting_command_is_recorded_only_when_it_changes(file, robot):
    record(robot, "program", Trace(file))
    for speed in (10, 10, 20, 10):
        robot.device(Base).move(speed, 0)
    for _ in range(2):
        robot.device(Speaker).say("hello")
    assert [event["args"] for event in written(file)[1:]] == [
        [10.0, 0.0], [20.0, 0.0], [10.0, 0.0], ["hello"], ["hello"],
    ]  # fmt: skip
    assert len(robot.commands) == 6


def test_the_same_picture_may_be_shown_twice(file, robot):
    record(robot, "program", Trace(file))
    for _ in range(2):
        robot.device(Display).show_image(np.zeros((2, 2, 3), np.uint8))
    assert [event["args"] for event in written(file)[1:]] == [["<array of shape (2, 2, 3)>"]] * 2


def test_emotions_are_kept_in_order(file, robot):
    recorder = record(robot, "program", Trace(file))
    for emotion in ("joy", "fear"):
        robot.device(Display).show_emotion(emotion)
    assert recorder.emotions == ["joy", "fear"]


def test_skills_without_effect_are_counted(recorder):
    for _ in range(3):
        recorder.missing("turn", "Base:ROBOT")
    assert recorder.missed == {("turn", "Base:ROBOT"): 3}


def test_a_trace_begins_with_everything_it_depends_on(file, robot):
    record(robot, "abc", Trace(file))
    run = written(file)[0]["run"]
    assert {"program": "abc", "robot": "robot"}.items() <= run.items()
    assert set(run["versions"]) == {"learnblock", "trace"}


def test_noted_steps_are_written_as_they_would_be_at_once(file, recorder):
    args = (90, 1.0, -0.0, True, None, 'say "hé"')
    recorder.note(3)
    recorder.note_call("turn", args)
    recorder.note("stop_bot")
    assert file.getvalue() == b""
    recorder.write_noted()
    noted = file.getvalue()
    file.truncate(0)
    file.seek(0)
    recorder.line(3)
    recorder.called("turn", args, {})
    recorder.called("stop_bot", (), {})
    assert noted == file.getvalue()


@pytest.mark.parametrize(
    "write",
    [
        lambda recorder: recorder.printed("hello"),
        lambda recorder: recorder.called("turn", (1,), {}),
        lambda recorder: recorder.steps((4,)),
        lambda recorder: recorder.pose(1.5, (0.0, 0.0, 0.0)),
        lambda recorder: recorder.end("finished"),
    ],
)
def test_noted_steps_come_before_whatever_is_written_next(file, recorder, write):
    recorder.note(3)
    write(recorder)
    assert written(file)[0] == {"t": 1.5, "line": 3}
    assert len(written(file)) == 2


def test_a_long_list_of_noted_steps_is_written_by_itself(file, recorder):
    for _ in range(1000):
        recorder.note(3)
    assert len(written(file)) == 1000
