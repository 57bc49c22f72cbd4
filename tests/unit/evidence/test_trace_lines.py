"""The lines of a trace are kept small, and read back as they were written."""

import io

import msgspec
import pytest

from learnblock import robots, running
from learnblock.evidence.trace_lines import TraceLines, kind_of
from learnblock.running import Job, Options
from learnblock.running.team import TeamRun
from learnblock.runtime.inline import InlineWorker
from runs import EXAMPLES

LINES = [
    {"run": {"world": "square"}},
    {"t": 0.0, "pose": [0.0, 0.0, 0.0]},
    {"t": 0.0, "line": 3},
    {"t": 0.0, "call": "is_line", "args": []},
    {"t": 0.01, "line": 3},
    {"t": 0.01, "print": "a, b"},
    {"t": 0.02, "line": 3, "robot": "friend"},
    {"t": 0.02, "line": 3},
]


def written(*texts):
    lines = TraceLines()
    for text in texts:
        lines.write(text)
    return lines


def encoded(lines):
    return b"".join(msgspec.json.encode(one) + b"\n" for one in lines)


def test_lines_are_read_back_as_they_were_written_whether_together_or_one_by_one():
    assert [*written(encoded(LINES))] == LINES
    assert [*written(*(encoded([one]) for one in LINES))] == LINES
    assert [*TraceLines(LINES)] == LINES
    assert written(encoded(LINES))[-1] == LINES[-1]


@pytest.mark.parametrize("lines", [written(encoded(LINES)), TraceLines(LINES)])
def test_the_lines_of_a_kind_have_their_numbers_and_times(lines):
    found = [(number, time) for number, time, _ in lines.of_kind("line")]
    assert found == [(2, 0.0), (4, 0.01), (6, 0.02), (7, 0.02)]
    assert [about["pose"] for _, _, about in lines.of_kind("pose")] == [[0.0, 0.0, 0.0]]


def test_steps_that_are_alike_are_kept_once():
    lines = written(encoded(LINES))
    about = [one for _, one in lines.timed() if one == {"line": 3}]
    assert len(about) == 3
    assert len(set(map(id, about))) == 1
    assert sum(kind_of(one) == "line" for one in lines.steps()) == 2


def test_a_copy_has_more_lines_and_not_those_that_follow():
    lines = written(encoded(LINES[:4]))
    copy = lines.with_more([{"t": 0.5, "collision": "box"}])
    lines.write(encoded(LINES[4:]))
    assert [*copy] == [*LINES[:4], {"t": 0.5, "collision": "box"}]
    assert [*lines] == LINES


@pytest.mark.parametrize(
    "text",
    [
        b'{"t":1_0,"line":3}',
        b'{"t":nan,"line":3}',
        b'{"t":1e99,"line":3}',
        b'{"t":true,"line":',
        b'{"t":"1","line":3}',
        b'["t",1]',
        b'{"line":3}',
        b'{"t":1,"line":3',
        b"\xff",
        b"",
    ],
)
def test_what_no_recorder_wrote_is_left_out(text):
    good = b'{"t":1.0,"line":3}\n'
    assert [*written(good + text + b"\n" + good)] == [{"t": 1.0, "line": 3}] * 2


def test_the_last_of_two_times_counts_as_in_any_json():
    assert [*written(b'{"t":1.0,"line":3,"t":2.0}\n')] == [{"line": 3, "t": 2.0}]


@pytest.mark.parametrize("names", [("tags.bt",), ("flower.bt", "several/keeper.bt")])
def test_who_looks_at_a_run_in_its_process_gets_the_lines_of_its_file(names):
    robot, options = robots.find("sim-ebo"), Options(world="empty", seconds=3)
    jobs = {
        name: Job(running.program(running.read(EXAMPLES / name), robot), robot, options)
        for name in names
    }
    file, lines = io.BytesIO(), TraceLines()
    TeamRun(jobs, trace=file, lines=lines, worker=InlineWorker).run()
    assert encoded(lines) == file.getvalue()
    read = written(file.getvalue())
    assert len(read.steps()) == len(lines.steps())
    assert [*read.of_kind("line")] == [*lines.of_kind("line")]
