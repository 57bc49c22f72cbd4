"""The programs for several robots reach the goals of their worlds."""

import re
from collections.abc import Callable, Iterable
from pathlib import Path

import pytest

from learnblock import language, robots, running
from learnblock.blocks import builtin
from learnblock.running import Job, Options
from learnblock.running.recorded_keys import read_keys_of
from learnblock.running.team import TeamRun
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.process import ProcessWorker
from learnblock.runtime.watcher import Watcher
from places import ROOT
from runs import EXAMPLES, Presser

FOLDER = EXAMPLES / "several"
GAMES = (ROOT / "docs" / "games.md").read_text(encoding="utf-8")
PAGE = GAMES.partition("\n## Several robots\n")[2]
README = (EXAMPLES / "README.md").read_text(encoding="utf-8")
COMMAND = re.compile(r"`learnblock run (\S+@\S+(?: \S+@\S+)*) --world (\w+)(?: --for \d+)?`")
COMMANDS = COMMAND.findall(PAGE)
#: The goals of the players who have lost when the game is won.
LOST = {"football": {"ball in the west goal"}, "race": {"wasd at the finish"}}

pytestmark = [pytest.mark.slow, pytest.mark.spread]


def jobs(programs: str, options: Options) -> dict[str, Job]:
    """The runs of a command, by the names of the robots."""
    found = {}
    for assigned in programs.split():
        name, _, chosen = assigned.partition("@")
        robot, _, count = chosen.partition(":")
        entry, source = robots.find(robot), running.read(FOLDER / name)
        assert [one for one in running.check(source, entry) if one.severity == "error"] == []
        numbers = range(1, int(count) + 1) if count else [0]
        for number in numbers:
            robot_name = f"{Path(name).stem}-{number}" if number else Path(name).stem
            found[robot_name] = Job(running.program(source, entry), entry, options)
    return found


def players(world: str, names: Iterable[str]) -> Callable[[str], Watcher]:
    """Who presses the keys of a world's programs, if they are recorded."""
    keys = FOLDER / f"{world}.jsonl"
    if not keys.exists():
        return lambda _: Watcher()
    recorded = read_keys_of(keys, [*names])
    return lambda name: Presser(recorded[name])


@pytest.mark.parametrize(("programs", "world"), COMMANDS, ids=[world for _, world in COMMANDS])
def test_a_command_of_the_page_reaches_all_goals_of_its_world_or_wins(programs, world):
    team = jobs(programs, Options(world=world, seconds=40))
    report = TeamRun(team, watch=players(world, team), worker=InlineWorker).run()
    assert report.goals
    open_goals = {goal.name for goal in report.goals if goal.state != "reached"}
    assert open_goals == LOST.get(world, set())
    assert [own.error for own in report.robots.values()] == [None] * len(report.robots)


def test_nobody_wins_the_race_without_keys():
    [race] = [programs for programs, world in COMMANDS if world == "race"]
    team = jobs(race, Options(world="race", seconds=40))
    report = TeamRun(team, worker=InlineWorker).run()
    assert {goal.state for goal in report.goals} == {"open"}


@pytest.mark.sample(4)
@pytest.mark.parametrize(("programs", "world"), COMMANDS, ids=[world for _, world in COMMANDS])
def test_programs_in_one_thread_leave_the_trace_of_programs_in_processes(programs, world):
    here, there = (
        TeamRun(jobs(programs, Options(world=world, seconds=8)), worker=worker).run()
        for worker in (InlineWorker, ProcessWorker)
    )
    assert here.trace_sha256 == there.trace_sha256
    assert here == there


def test_page_and_readme_have_the_same_commands_and_use_every_program():
    assert COMMAND.findall(README) == COMMANDS
    used = {assigned.partition("@")[0] for programs, _ in COMMANDS for assigned in programs.split()}
    assert used == {path.name for path in FOLDER.glob("*.bt")}


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.bt")), ids=lambda path: path.name)
def test_a_program_keeps_its_form_and_comes_back_from_python_unchanged(path):
    source = running.read(path)
    again = language.from_python(language.to_python(source.tree, "learnblock.robots.ebo").text)
    assert again == source.tree
    assert language.format(again) == source.text


def test_the_event_of_the_page_is_a_program_in_all_notations():
    (text,) = re.findall(r"^```blocktext\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
    tree = language.parse(text)
    python = language.to_python(tree, "learnblock.robots.ebo").text
    assert '@robot.when(lambda: robot.received("go"))' in python
    assert language.from_python(python) == tree
    workspace = language.to_workspace(tree, builtin()).workspace
    assert language.from_workspace(workspace, builtin()).program == tree
