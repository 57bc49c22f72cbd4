"""Python that was written elsewhere: the scores of the standard library's turtle programs.

The floors may only rise; `scripts/bench foreign_python` prints the scores.
"""

import re
import runpy

import pytest
from click.testing import CliRunner

from learnblock.blocks.schema.loading import builtin
from learnblock.cli import main
from learnblock.language import (
    check,
    from_python,
    from_workspace,
    parse,
    to_python,
    to_workspace,
)
from learnblock.language import format as format_program
from learnblock.language.tree.nodes import PythonLine, Raw, SkillCall
from learnblock.language.tree.traversal import all_expressions, statements, within
from places import ROOT
from python_scores import TURTLEDEMO, scores_of

STATEMENTS_IN_BLOCKS = 99.9
SOCKETS_IN_BLOCKS = 99.9
FILES_WITHOUT_GREY = 21


@pytest.fixture(scope="module")
def scores():
    return scores_of(sorted(TURTLEDEMO.glob("*.py")))


def test_unedited_files_come_back_byte_for_byte(scores):
    assert scores.kept == scores.files


def test_files_mean_the_same_by_way_of_block_text(scores):
    assert scores.same == scores.files


def test_most_of_their_statements_and_values_are_blocks(scores):
    assert scores.in_blocks >= STATEMENTS_IN_BLOCKS
    assert scores.sockets_in_blocks >= SOCKETS_IN_BLOCKS
    assert scores.ungrey >= FILES_WITHOUT_GREY


@pytest.mark.parametrize("path", sorted(TURTLEDEMO.glob("*.py")), ids=lambda path: path.stem)
def test_a_program_that_runs_is_not_refused(path):
    python = path.read_text("utf-8")
    program = from_python(python)
    assert check(program, builtin(), python=python) == []
    assert check(parse(format_program(program)), builtin()) == []


CAUGHT = """\
class Stack(list):
    def last(self):
        return self.pop()


try:
    print(Stack([1]).last(), NotImplemented)
except ValueError as error:
    print(error)
"""


def test_names_and_calls_of_plain_python_are_left_to_python():
    program = from_python(CAUGHT)
    assert check(program, builtin(), python=CAUGHT) == []
    assert check(parse(format_program(program)), builtin()) == []


def test_lines_that_are_no_python_are_reported_without_a_robot_too():
    program = parse("without robot\n`x = = 1`\n")
    assert [found.code for found in check(program, builtin())] == ["invalid-python"]


WITHOUT_ITS_ROBOT = """\
import time


def drive():
    robot.move_straight()
    time.sleep(1)


drive()
robot.stop_bot()
"""


def test_a_program_that_lacks_only_its_robot_is_blocks_and_the_check_says_how_to_add_it():
    program = from_python(WITHOUT_ITS_ROBOT)
    assert not any(isinstance(item, Raw) for item in statements(program.items))
    assert to_python(program, None).text == WITHOUT_ITS_ROBOT
    (found,) = check(program, builtin(), python=WITHOUT_ITS_ROBOT)
    assert found.message.code == "python-no-robot"
    (found,) = check(parse(format_program(program)), builtin())
    assert found.message.code == "check-without-robot"


OWN_ROBOT = """\
from toys import Car

robot = Car(4, 14)


def play(robot):
    robot.forward(0.5)
    robot.wait_until(lambda: robot.stopped)


play(robot)
print(f"{robot.distance():.1f} cm", robot.distance())
robot.activate()
robot.run()
"""


def test_a_robot_of_another_library_is_blocks_and_none_of_its_methods_a_skill():
    program = from_python(OWN_ROBOT)
    found = list(statements(program.items))
    assert not any(isinstance(item, Raw) for item in found)
    values = [part for item in found for value in all_expressions(item) for part in within(value)]
    assert not any(isinstance(value, SkillCall) for value in values)
    assert check(program, builtin(), python=OWN_ROBOT) == []
    assert check(parse(format_program(program)), builtin()) == []
    assert to_python(parse(format_program(program))).text == OWN_ROBOT
    read = from_workspace(to_workspace(program, builtin()).workspace, builtin())
    assert (read.program, read.problems) == (program, ())
    assert to_python(read.program).text == OWN_ROBOT


def test_activate_without_events_is_a_method_like_any_other():
    program = from_python("window.activate()\n")
    assert program.items[1:] == (PythonLine("window.activate()"),)


def test_adding_the_two_lines_of_the_robot_is_enough():
    blocktext = format_program(from_python(WITHOUT_ITS_ROBOT)).removeprefix("without robot\n\n")
    assert check(parse(blocktext), builtin()) == []


MATCH = """\
def sort(command):
    match (command,  # zero
           1):  # one
        # two

        # three
        case [
            # four
            str(first), *_
        ] if first:  # five
            print(first)
            # six
        # seven
        case [0 | 1]: print(1)  # eight
        case _:
            # nine
            pass
        # ten
    # eleven
    return command
"""


def test_comments_in_a_match_come_through_every_notation():
    program = from_python(MATCH)
    assert to_python(program).text == MATCH
    block_text = format_program(program)
    words = re.findall(r"# (\w+)", block_text)
    assert sorted(words) == sorted(re.findall(r"# (\w+)", MATCH))
    again = parse(block_text)
    assert again == program == from_python(to_python(again).text)
    read = from_workspace(to_workspace(program, builtin()).workspace, builtin())
    assert (read.program, read.problems) == (program, ())


def test_names_that_patterns_set_are_known_and_their_lines_have_a_place():
    python = MATCH.replace("return command", "return first").replace("command):", "command):\n")
    program = from_python(python)
    assert check(program, builtin(), python=python) == []
    assert check(parse(format_program(program)), builtin()) == []
    mapped = to_python(program).source_map
    lines = [number for number, line in enumerate(python.split("\n"), 1) if "case" in line]
    assert [mapped.source_line(number) for number in lines] == lines


EXAMPLES = sorted((ROOT / "examples" / "elsewhere").glob("*.py"))
each_example = pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)


@each_example
def test_an_example_from_elsewhere_is_blocks_as_a_whole(path):
    scores = scores_of([path])
    assert (scores.ungrey, scores.kept, scores.same, scores.in_blocks) == (1, 1, 1, 100)


@each_example
def test_an_example_from_elsewhere_does_what_it_does_in_python(path, tmp_path, capsys):
    runpy.run_path(str(path), run_name="__main__")
    output = capsys.readouterr().out
    as_block_text = tmp_path / f"{path.stem}.bt"
    as_block_text.write_text(format_program(from_python(path.read_text("utf-8"))), "utf-8")
    for file in (path, as_block_text):
        result = CliRunner().invoke(main, ["run", str(file)])
        assert result.exit_code == 0
        assert result.stdout.startswith(output)
