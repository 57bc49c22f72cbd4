"""Programs that are driven with keys: they do the same whenever the same keys are pressed."""

import pytest

from learnblock.errors import ProgramError
from learnblock.running.recorded_keys import RecordedKeys, read_keys
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.process import ProcessWorker, ThreadWorker
from learnblock.runtime.program import Program
from runs import EXAMPLES, TWINS, Presser, run_example, run_file

REMOTE = EXAMPLES / "remote-control.bt"
KEYS = read_keys(REMOTE.with_suffix(".jsonl"))


def program(python):
    return Program("keys.py", python, python)


@pytest.mark.parametrize("robot", TWINS)
def test_a_robot_is_driven_to_its_goals_with_keys(robot):
    report = run_example("remote-control.bt", robot, world="square").report
    assert {goal.state for goal in report.goals} == {"reached"}


@pytest.mark.parametrize("worker", [ThreadWorker, ProcessWorker, InlineWorker])
def test_the_keys_in_a_trace_repeat_the_run(worker, tmp_path):
    options = {"world": "square", "seconds": 5, "worker": worker}
    first = run_file(REMOTE, "sim-ebo", watcher=Presser(KEYS), **options)
    kept = tmp_path / "trace.jsonl"
    kept.write_bytes(first.trace)
    again = run_file(REMOTE, "sim-ebo", watcher=Presser(read_keys(kept)), **options)
    assert [line["keys"] for line in first.entries("keys")] == [["up"], [], ["right"]]
    assert again.trace == first.trace


def test_without_a_keyboard_nothing_is_pressed():
    finished = run_file(REMOTE, "sim-ebo", world="square", seconds=2)
    assert finished.entries("keys") == []
    assert finished.report.distance == 0


def test_keys_are_held_until_the_next_change():
    keys = RecordedKeys(((1, ("up", "a")), (2, ())))
    assert [keys.held(time) for time in (0.99, 1, 1.99, 2)] == [(), ("up", "a"), ("up", "a"), ()]


@pytest.mark.parametrize(
    ("line", "problem"),
    [
        ('{"t": 1, "keys": ["upp"]}', "There is no key 'upp'. Did you mean 'up'?"),
        ('{"t": "soon", "keys": ["up"]}', 'Write a line such as {"t": 1.5, "keys": ["up"]}.'),
        ('{"t": 1, "keys": ["up"]', 'Write a line such as {"t": 1.5, "keys": ["up"]}.'),
    ],
)
def test_an_invalid_line_of_keys_is_reported_with_its_number(line, problem, tmp_path):
    file = tmp_path / "keys.jsonl"
    file.write_text(f'{{"t": 0, "line": 3}}\n{line}\n')
    with pytest.raises(ProgramError) as caught:
        read_keys(file)
    [diagnostic] = caught.value.diagnostics
    assert (diagnostic.line, str(diagnostic.message)) == (2, problem)


@pytest.mark.parametrize(
    ("calls", "keys"),
    [
        (['robot.is_key_pressed("w")', 'robot.is_key_pressed(key="up")'], ("up", "w")),
        (["robot.is_key_pressed()"], ("space",)),
    ],
)
def test_a_program_tells_which_keys_it_asks_for(calls, keys):
    assert program("\n".join(calls)).keys == keys


@pytest.mark.parametrize("python", ["robot.is_key_pressed(key)", "robot.waltz()", "if:"])
def test_a_program_whose_keys_are_unknown_may_ask_for_every_key(python):
    assert len(program(python).keys) == 42


def test_a_file_of_keys_that_is_not_utf_8_is_refused_with_its_line(tmp_path):
    path = tmp_path / "keys.jsonl"
    path.write_bytes(b'{"t": 0, "keys": []}\n{"t": 1, "keys": ["\xf1"]}\n')

    with pytest.raises(ProgramError) as refused:
        read_keys(path)
    assert [(one.line, one.message.code) for one in refused.value.diagnostics] == [
        (2, "run-not-utf-8")
    ]
