"""The robots of a kernel, with IPython's own shell."""

import builtins
import re
import sys
import time

import pytest
from IPython.core.displaypub import CapturingDisplayPublisher
from IPython.core.interactiveshell import InteractiveShell
from traitlets.config import Config

from learnblock.devices import Base
from learnblock.errors import LearnBlockError
from learnblock.notebook.cell_pages import LONGEST
from learnblock.notebook.session import session_of
from learnblock.robots.sim_ebo import Robot
from learnblock.runtime.log.instrumenting import NOTING
from page_files import content_in_frame
from places import ROOT

MADE = "from learnblock.robots.sim_ebo import Robot\nrobot = Robot(world='empty')"


@pytest.fixture
def shell(monkeypatch):
    """A shell of IPython, which takes the place of the program."""
    monkeypatch.setitem(sys.modules, "__main__", sys.modules["__main__"])
    config = Config()
    config.HistoryManager.enabled = False
    shell = InteractiveShell.instance(config=config)
    shell.display_pub = CapturingDisplayPublisher(parent=shell)
    yield shell
    for robot in session_of(shell).robots():
        robot.stop()
    for name in NOTING:
        delattr(builtins, name)
    session_of.cache_clear()
    InteractiveShell.clear_instance()


@pytest.fixture
def run(shell):
    """A function that runs a cell and returns what it shows."""

    def run(cell):
        shell.display_pub.outputs.clear()
        shell.run_cell(cell, store_history=True)
        return [output["data"] for output in shell.display_pub.outputs if not output["update"]]

    return run


def test_a_second_robot_is_in_a_new_world_and_says_so(run, shell, capsys):
    run(MADE)
    assert capsys.readouterr().out == ""
    run("first = robot\nfirst.drive_distance(100)\nrobot = Robot(world='line')")
    said = "This robot is in a new world ('line'). Earlier robots stay in theirs.\n"
    assert capsys.readouterr().out == said
    run("first.drive_distance(100)")
    first, second = shell.user_ns["first"], shell.user_ns["robot"]
    assert first.get_pose()[0] == pytest.approx(200, abs=10)
    assert second.time() == 0


def test_a_robot_that_no_name_refers_to_goes_with_its_world(run, shell):
    for _ in range(4):
        run(f"{MADE}\nrobot.drive_distance(50)")
    # In a cell, in which the time is that of a robot.
    run("import gc\ngc.collect()")
    assert len(session_of(shell).robots()) == 1


def test_it_says_so_in_the_readers_language(run, capsys, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_LANGUAGE", "es")
    run(MADE)
    run(MADE)
    assert "Este robot está en un mundo nuevo ('empty')." in capsys.readouterr().out


def test_a_robot_that_is_asked_to_is_shown_after_each_cell_that_moves_it(run):
    run(MADE)
    [at_once] = run("robot.show()")
    [driven] = run("robot.drive_distance(200)")
    [turned] = run("robot.turn(90)")
    assert run("x = 1") == run("robot.sleep(1)") == []
    assert "0.00 m in 0.0 s" in at_once["image/svg+xml"]
    assert "0.20 m in" in driven["image/svg+xml"]
    # The way of that cell alone.
    assert "0.00 m in" in turned["image/svg+xml"]
    run("robot.show(after_each_cell=False)")
    assert run("robot.drive_distance(200)") == []


@pytest.mark.slow
def test_the_last_cell_has_its_run_as_a_page_and_the_ones_before_it_their_picture(run, shell):
    run(MADE)
    run("def drive():\n    robot.drive_distance(100)\nrobot.show()\ndrive()")
    [first] = run("drive()\nbegan = robot.time()")
    [second] = run("robot.turn(90)")
    [update, _] = shell.display_pub.outputs
    assert update["update"]
    assert update["data"] == {kind: first[kind] for kind in ("text/plain", "image/svg+xml")}
    content = content_in_frame(second["text/html"])
    assert content["title"] == "Cell [4]"
    [robot] = content["robots"]
    begin = robot["timeline"]["begin"]
    assert begin == pytest.approx(shell.user_ns["began"], abs=0.01)
    assert sum(moment["past"]["time"] >= begin for moment in robot["moments"]) > 20
    asked = [asked["question"].get("time") for asked in robot["questions"]["questions"]]
    assert asked
    assert all(time is None or time >= begin for time in asked)


def test_a_page_has_the_blocks_of_a_robot_that_an_earlier_cell_imported(run):
    run("%load_ext learnblock.notebook\nfrom learnblock.robots.sim_ebo import Robot")
    run("robot = Robot(world='empty')\nrobot.show()")
    [shown] = run("robot.drive_distance(100)")
    [robot] = content_in_frame(shown["text/html"])["robots"]
    lines = robot["blocktext"].splitlines()
    assert lines == ['robot(world="empty")', "", "function.show()", "function.drive_distance(100)"]


def test_a_robot_that_has_run_for_long_is_shown_by_its_picture(run):
    run(f"{MADE}\nrobot.show()")
    [early] = run("robot.turn(90)")
    assert "text/html" in early
    [late] = run(f"robot.sleep({LONGEST})\nrobot.turn(90)")
    assert set(late) == {"text/plain", "image/svg+xml"}


def test_the_time_is_that_of_the_world_only_in_cells(run, shell):
    run(MADE)
    run("import time\nrobot.sleep(5)\nin_a_cell = time.time()")
    began = shell.user_ns["robot"].clock.time()
    assert shell.user_ns["in_a_cell"] == pytest.approx(5, abs=0.1)
    assert [time.time() > 1e9 for _ in range(20)] == [True] * 20
    assert shell.user_ns["robot"].clock.time() == began


@pytest.mark.parametrize("magic", ["", "%%capture\n", "%%time\n"])
def test_a_stopped_or_failed_cell_stops_the_wheels(run, shell, magic):
    run(MADE)
    run(f"{magic}robot.move_straight(50)\nraise KeyboardInterrupt")
    robot = shell.user_ns["robot"]
    before = robot.get_pose()
    run("robot.sleep(1)")
    assert robot.get_pose() == pytest.approx(before, abs=2)
    run("robot.move_straight(50)")
    run("robot.sleep(1)")
    assert robot.get_pose()[0] > before[0] + 30
    assert robot.has(Base)


AWAY = """\
limit = 20

def away():
    if robot.is_front_obstacle(limit):
        robot.turn(-90)
        robot.move_straight(60)
"""
DRIVE = """\
robot.move_straight(60)
for _ in range(200):
    away()
    robot.sleep(0.1)
"""


@pytest.fixture
def bumped(run):
    """A robot that drives into something, by a function of another cell."""
    run(MADE.replace("empty", "arena"))
    run(AWAY)
    run(DRIVE)


def test_it_says_why_in_the_lines_of_its_cells_as_the_docs_show_it(run, shell):
    page = (ROOT / "docs" / "editors.md").read_text("utf-8")
    section = page.partition("### Ask the robot")[2].partition("\n###")[0]
    *cells, answer = re.findall(r"^```\w*\n(.*?)^```$", section, re.MULTILINE | re.DOTALL)
    for cell in cells:
        run(cell)
    assert f"{shell.user_ns['_oh'][len(cells)]}\n" == answer


def test_it_lists_what_can_be_asked_and_answers_in_spanish(bumped, run, shell, monkeypatch):
    run("asked = robot.why()")
    assert "Why did the robot bump into a block" in shell.user_ns["asked"]
    monkeypatch.setenv("LEARNBLOCK_LANGUAGE", "es")
    run("answer = robot.why('¿por qué chocó?')")
    assert "línea 4 de [2]" in shell.user_ns["answer"]


def test_a_question_that_it_does_not_understand_is_no_error(bumped, run, shell):
    run("answer = robot.why('why banana')")
    assert shell.user_ns["answer"]


def test_the_cell_that_makes_the_first_robot_is_noted_once_the_extension_is_loaded(run, shell):
    drives = "\nrobot.drive_distance(-50)\nanswer = robot.why('why did it drive backwards')"
    run(MADE + drives)
    assert "%load_ext learnblock.notebook" in shell.user_ns["answer"]
    run(MADE + drives)
    assert "line 3 of [2] says drive_distance(-50)" in shell.user_ns["answer"]


@pytest.mark.parametrize(
    ("cell", "line"),
    [
        ("%%time\nx = 1\nrobot.drive_distance(-50)", 3),
        ("%%time\n\nrobot.drive_distance(-50)", 3),
        ("%%capture\nrobot.drive_distance(-50)", 2),
        ("%%time\n%%capture printed\nx = 1\nrobot.drive_distance(-50)\n", 4),
        ("\n\nx = 1\nrobot.drive_distance(-50)", 4),
        ("x = 1\n%time robot.drive_distance(-50)", 2),
    ],
)
def test_what_runs_of_a_cell_is_noted_at_its_line(run, shell, cell, line):
    run(MADE)
    run(cell)
    run("robot.drive_distance(30)\nanswer = robot.why('why did it drive backwards')")
    assert f"line {line} of [2] says drive_distance(-50)" in shell.user_ns["answer"]


def test_a_cell_that_a_magic_runs_shows_the_robot_once(run):
    run(MADE)
    run("robot.show()")
    for cell in ("%%capture\nrobot.drive_distance(50)", "%%time\nrobot.drive_distance(50)"):
        (shown,) = run(cell)
        assert "0.05 m in" in shown["image/svg+xml"]


def test_a_magic_that_measures_is_not_disturbed(run, shell):
    run(MADE)
    run("%%timeit -n 1 -r 1\nrobot.drive_distance(-50)")
    run("answer = robot.why('why did it drive backwards')")
    assert "of [2]" not in shell.user_ns["answer"]


def test_cells_give_what_they_gave_without_being_noted(run, shell):
    run(MADE)
    run("squares = [n * n for n in range(4)]\nif squares[2] == 4:\n    is_four = True")
    assert shell.user_ns["squares"] == [0, 1, 4, 9]
    assert shell.user_ns["is_four"]
    # A magic runs a part of a cell, and an await has no tree outside a function.
    run("%time twice = 2 * 21")
    run("%%time\nthrice = 3 * 21\nthrice")
    assert shell.user_ns["_"] == 63
    run("import asyncio\nawait asyncio.sleep(0)\nawaited = 1")
    assert [shell.user_ns["twice"], shell.user_ns["awaited"]] == [42, 1]


def test_a_program_without_a_notebook_cannot_show_its_robot():
    with Robot(world="empty") as robot:
        for call in (robot.show, robot.why):
            with pytest.raises(LearnBlockError) as refusal:
                call()
            assert refusal.value.phrase.code == "notebook-none"
