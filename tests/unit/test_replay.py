"""A trace's poses and goals are those of a run repeated from its commands, unless it is forged."""

import io

import pytest
from click.testing import CliRunner

from learnblock import robots, running
from learnblock.cli import main
from learnblock.errors import LearnBlockError
from learnblock.running import Job, Options
from learnblock.running.recorded_keys import read_keys_of
from learnblock.running.replay import replay
from learnblock.running.team import TeamRun
from learnblock.runtime.inline import InlineWorker
from runs import EXAMPLES, FEW, Presser, able_twin

NAMES = sorted(path.name for path in EXAMPLES.glob("*.bt"))


@pytest.fixture
def square(made):
    return made("square.bt", "sim-ebo").trace


@pytest.mark.slow
@pytest.mark.sample(6)
@pytest.mark.parametrize("name", NAMES)
def test_every_example_is_repeated_exactly(made, name):
    repeated = replay(made(name, able_twin(name), seconds=FEW).trace)

    assert repeated.recorded == repeated.repeated
    assert len(repeated.recorded) > 10


def test_a_goal_is_among_what_is_repeated(square):
    assert any(kind == "goal" for _, kind, *_ in replay(square).repeated)


@pytest.mark.parametrize(
    ("mark", "forge"),
    [
        (b'"pose"', lambda line: line.replace(b'"pose":[', b'"pose":[7,')),
        (b'"goal"', lambda _: b""),
        (b'"goal"', lambda line: line.replace(b'"reached"', b'"failed"')),
        (b'"do":"move"', lambda _: b""),
        (b'"do":"move"', lambda line: line.replace(b'"args":[', b'"args":[9')),
    ],
    ids=["a pose", "a goal is left out", "a goal", "a command is left out", "a command"],
)
def test_a_forged_line_is_noticed(square, mark, forge):
    lines = square.splitlines(keepends=True)
    # The last one of a kind, or for commands the first one.
    places = [number for number, line in enumerate(lines) if mark in line]
    place = places[0] if b"do" in mark else places[-1]
    lines[place] = forge(lines[place])

    assert replay(square).is_true
    assert not replay(b"".join(lines)).is_true


@pytest.fixture(scope="module")
def race():
    """A trace of two robots, driven by two players."""
    several, names = EXAMPLES / "several", ("arrows", "wasd")
    keys = read_keys_of(several / "race.jsonl", names)
    jobs = {}
    for name, robot in zip(names, ("sim-thymio", "sim-cozmo"), strict=True):
        entry = robots.find(robot)
        program = running.program(running.read(several / f"{name}.bt"), entry)
        jobs[name] = Job(program, entry, Options(world="race", seed=3, seconds=20))
    trace = io.BytesIO()
    TeamRun(
        jobs,
        trace=trace,
        watch=lambda name: Presser(keys[name]),
        worker=InlineWorker,
    ).run()
    return trace.getvalue()


def test_a_run_of_several_robots_is_repeated_exactly(race):
    repeated = replay(race)
    assert repeated.recorded == repeated.repeated
    assert {seen[0] for seen in repeated.recorded} == {"arrows", "wasd"}
    goals = [name for _, kind, _, name, *_ in repeated.recorded if kind == "goal"]
    assert goals == ["arrows at the finish"]


def test_a_command_that_is_ascribed_to_another_robot_is_noticed(race):
    lines = race.splitlines(keepends=True)
    # Before it, both robots stand.
    starts = [number for number, line in enumerate(lines) if b'"do":"move","args":[120' in line]
    own = next(number for number in starts if b'"robot":"wasd"' in lines[number])
    lines[own] = lines[own].replace(b'"robot":"wasd"', b'"robot":"arrows"')
    assert not replay(b"".join(lines)).is_true


def test_another_file_is_not_a_trace():
    with pytest.raises(LearnBlockError, match="not the trace"):
        replay(b"hello\n")


@pytest.mark.parametrize("name", ["square", "race"])
def test_the_command_says_whether_a_trace_is_true(name, request, tmp_path):
    path, trace = tmp_path / "trace.jsonl", request.getfixturevalue(name)
    path.write_bytes(trace)
    well = CliRunner().invoke(main, ["replay", str(path)])
    path.write_bytes(trace.replace(b'"do":"move"', b'"do":"stay"', 3))
    forged = CliRunner().invoke(main, ["replay", str(path)])

    assert (well.exit_code, "are true" in well.output) == (0, True)
    assert forged.exit_code != 0
    assert "not true" in forged.output
