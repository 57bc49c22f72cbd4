"""docs/grading.md: its commands run, and its options and columns are those of the code."""

import csv
import re
import shlex

import pytest
from click.testing import CliRunner

from cheats import CHEATS
from learnblock.cli import main
from learnblock.cli.grade import grade_command
from places import ROOT

PAGE = (ROOT / "docs" / "grading.md").read_text("utf-8")
#: So that the examples take seconds.
TINY = ("--variants", "0", "--jobs", "1")


def rows(head):
    """The first cells of the table with this head."""
    table = PAGE.partition(f"| {head} |")[2].partition("\n\n")[0]
    return re.findall(r"^\| ([^|]+) \|", table, re.MULTILINE)


@pytest.mark.slow
def test_the_example_grades_two_programs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    [command] = re.findall(r"^```sh\nlearnblock (.*)\n```", PAGE, re.MULTILINE)
    made = CliRunner().invoke(main, [*shlex.split(command), *TINY])
    assert made.exit_code == 0, made.output
    assert (tmp_path / "results" / "results.html").exists()
    with (tmp_path / "results" / "results.csv").open(encoding="utf-8-sig") as file:
        found = [*csv.DictReader(file)]
    assert [row["pupil"] for row in found] == ["square", "polygons"]
    named = re.findall(r"`(\w+)`", " ".join(rows("column")))
    assert [name for name in named if name not in found[0] and name != "goals"] == []
    assert [name for name in found[0] if name not in named and " " not in name] == []


#: Tried by tests of their own, or answered by the comparison with isolated runs.
OTHERS = [
    "detects grading by environment, arguments, files or threads",
    "breaks out of the shared process",
]


def test_the_table_of_cheats_has_exactly_those_that_are_tried():
    described = [one.strip() for row in rows("cheat") for one in row.split(";")]
    assert sorted(described) == sorted([*CHEATS, *OTHERS])


def test_the_options_are_those_of_the_command():
    described = re.findall(r"`(--[\w-]+)`", " ".join(rows("option")))
    options = [one for parameter in grade_command.params for one in parameter.opts]
    assert sorted(described) == sorted(one for one in options if one.startswith("--"))
