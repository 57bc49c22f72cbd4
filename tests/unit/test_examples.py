"""Every example on every twin, in both notations, more than once."""

import hashlib
import itertools
import os
import re
import subprocess
import sys
import threading
from operator import itemgetter

import pytest

from learnblock import language, robots, running
from learnblock.runtime.process import ProcessWorker, ThreadWorker
from pythons import VERSIONS, with_learnblock
from runs import (
    EXAMPLES,
    FEW,
    TASKS,
    TWINS,
    WORLDS,
    able_twin,
    person,
    refusal,
    run_example,
    run_file,
)

NAMES = sorted(TASKS)
#: In the order in which a robot that turns to the right reaches them.
SEVEN = ("joy", "sadness", "anger", "surprise", "fear", "disgust", "neutral")
PAIRS = list(itertools.product(NAMES, TWINS))
#: On their page: each example with a robot and a world.
COMMANDS = re.findall(
    r"`learnblock run (\S+) --robot (\S+) --world (\S+)`",
    (EXAMPLES / "README.md").read_text(encoding="utf-8"),
)
ROBOTS = {name: robot for name, robot, _ in COMMANDS}

pytestmark = [pytest.mark.slow, pytest.mark.spread]


@pytest.mark.sample(24)
@pytest.mark.parametrize(("name", "robot"), PAIRS)
def test_an_example_runs_on_a_twin_or_is_refused_by_naming_the_missing_device(made, name, robot):
    errors = refusal(name, robot)
    if errors:
        assert {error.code for error in errors} == {"missing-device"}
        devices = robots.find(robot).load().device_names()
        needs = [need for error in errors for need in error.message.values["devices"]]
        lacking = {need.values["kind"] for need in needs}
        assert lacking
        assert not {device.partition(":")[0] for device in devices} & lacking
    else:
        report = made(name, robot, seconds=FEW).report
        assert report.error is None
        assert report.ended in {"finished", "time limit"}


@pytest.mark.parametrize("name", NAMES)
def test_an_example_keeps_its_form_and_comes_back_from_python_unchanged(name):
    source = running.read(EXAMPLES / name)
    again = language.from_python(language.to_python(source.tree, "learnblock.robots.ebo").text)
    assert again == source.tree
    assert language.format(again) == source.text


@pytest.mark.sample(6)
@pytest.mark.parametrize("name", NAMES)
def test_block_text_and_python_of_an_example_leave_the_same_trace(made, name, tmp_path):
    robot = able_twin(name)
    python = tmp_path / "program.py"
    tree = running.read(EXAMPLES / name).tree
    python.write_text(language.to_python(tree, robots.module_of("cozmo")).text)
    options = {"world": TASKS[name][0], "seconds": FEW}
    same = run_file(python, robot, watcher=person(name), **options)
    assert same.trace == made(name, robot, **options).trace


def test_a_generated_file_runs_by_itself_with_the_same_trace(made, tmp_path):
    module = robots.module_of("sim-cozmo")
    program = tmp_path / "square.py"
    program.write_text(language.to_python(running.read(EXAMPLES / "square.bt").tree, module).text)
    trace = tmp_path / "trace.jsonl"
    given = {"LEARNBLOCK_TRACE": str(trace), "LEARNBLOCK_WORLD": TASKS["square.bt"][0]}
    subprocess.run([sys.executable, program], env={**os.environ, **given}, check=True)
    assert trace.read_bytes() == made("square.bt", "sim-cozmo").trace


def busy(until):
    """Keep the machine busy until the end of the test."""
    while not until.is_set():
        hashlib.sha256(b"0" * 100_000).digest()


def test_runs_with_and_without_load_leave_one_trace(made):
    options = {"world": "obstacles", "seed": 7, "seconds": 5}
    quiet = made("avoid.bt", "sim-ebo", **options).trace
    options["worker"] = ProcessWorker
    until = threading.Event()
    load = [threading.Thread(target=busy, args=(until,)) for _ in range(3)]
    for thread in load:
        thread.start()
    try:
        loaded = [run_example("avoid.bt", "sim-ebo", **options).trace for _ in range(3)]
    finally:
        until.set()
        for thread in load:
            thread.join()
    assert loaded == [quiet] * 3


@pytest.mark.parametrize("worker", [ProcessWorker, ThreadWorker])
@pytest.mark.parametrize("pace", ["free", "5"])
def test_neither_pace_nor_the_kind_of_worker_changes_the_trace(made, worker, pace):
    options = {"world": "tags", "seed": 3, "seconds": 5}
    actual = run_example("tags.bt", "sim-cozmo", worker=worker, pace=pace, **options).trace
    assert actual == made("tags.bt", "sim-cozmo", **options).trace


@pytest.mark.parametrize("robot", ["sim-ebo", "sim-cozmo"])
def test_all_seven_faces_are_found_and_imitated(made, robot):
    report = made("imitate.bt", robot).report
    met = [(goal.name, goal.state) for goal in report.goals]
    assert met == [(emotion, "reached") for emotion in SEVEN]
    # Before it sees a face, it is calm.
    assert ["neutral", *SEVEN] == list(report.emotions)


@pytest.mark.sample(6)
@pytest.mark.parametrize("name", NAMES)
def test_an_example_reaches_all_goals_of_its_world(made, name):
    assert {goal.state for goal in made(name, ROBOTS[name]).report.goals} == {"reached"}


@pytest.mark.sample(6)
@pytest.mark.parametrize("world", sorted({world for world, _ in TASKS.values()}))
def test_an_idle_program_reaches_no_goal_of_a_world(world, tmp_path):
    name, seconds = max(
        ((name, seconds) for name, (own, seconds) in TASKS.items() if own == world),
        key=itemgetter(1),
    )
    idle = tmp_path / "idle.bt"
    idle.write_text(f"main:\n    function.sleep({seconds})\nend\n")
    goals = run_file(idle, ROBOTS[name], world=world).report.goals
    assert {goal.state for goal in goals} <= {"open", "failed"}


def test_another_seed_gives_another_path():
    paths = [
        run_example("square.bt", "sim-ev3", seed=seed, seconds=12).recorder.path for seed in (1, 2)
    ]
    assert paths[0] != paths[1]


def test_every_example_has_a_task():
    files = [*EXAMPLES.glob("*.bt"), *EXAMPLES.glob("first/*.bt"), *EXAMPLES.glob("games/*.bt")]
    assert sorted(path.relative_to(EXAMPLES).as_posix() for path in files) == NAMES


def test_the_page_of_examples_names_each_with_a_robot_that_can_run_it():
    assert sorted(name for name, _, _ in COMMANDS) == NAMES
    for name, robot, world in COMMANDS:
        assert refusal(name, robot) == []
        assert world == TASKS[name][0]


def elsewhere(name, robot):
    """A program whose trace only a run of everything compares between versions of Python."""
    return pytest.param(name, robot, marks=pytest.mark.exhaustive)


@pytest.mark.slow
@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize(
    ("name", "robot"),
    [
        ("line-states.bt", "sim-ebo"),
        ("tags.bt", "sim-ebo"),
        ("watch-out.bt", "sim-thymio"),
        elsewhere("line-thymio.bt", "sim-legoed"),
        elsewhere("flower.bt", "sim-root"),
        elsewhere("labyrinth.bt", "sim-create3"),
        elsewhere("games/collector.bt", "sim-spike"),
    ],
)
def test_another_version_of_python_leaves_the_same_trace(made, name, robot, version, tmp_path):
    python = with_learnblock(version)
    if python is None:
        pytest.skip(f"`scripts/bench hashes` has not installed LearnBlock for Python {version}")
    world = TASKS[name][0] if name.startswith("games/") else WORLDS.get(name, "empty")
    options = {"world": world, "seconds": 4}
    trace = tmp_path / "trace.jsonl"
    command = [python, "-m", "learnblock", "run", EXAMPLES / name, "--robot", robot]
    given = ["--for", "4", "--world", options["world"], "--trace", trace]
    subprocess.run([*command, *given], stdout=subprocess.DEVNULL, check=True)
    assert trace.read_bytes() == made(name, robot, **options).trace
