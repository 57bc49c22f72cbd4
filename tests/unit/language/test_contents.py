"""Each folder of a notation begins with a table of what is where."""

import re

import pytest

from learnblock.language import blocktext, python, workspace
from learnblock.language.tree import nodes
from places import ROOT

NOTATIONS = [blocktext, python, workspace]


@pytest.mark.parametrize("notation", NOTATIONS)
def test_the_table_of_a_notation_names_all_its_files(notation):
    folder = ROOT.joinpath("src", *notation.__name__.split("."))
    files = {path.name for path in folder.glob("*.py")} - {"__init__.py"}
    assert files == set(re.findall(r"\w+\.py\b", notation.__doc__))


@pytest.mark.parametrize("notation", NOTATIONS)
def test_the_nodes_in_the_table_of_a_notation_exist(notation):
    rows = [line for line in notation.__doc__.split("\n") if line.endswith(".py") and "  " in line]
    named = {name for line in rows for name in re.split(r"  +", line)[1].split(", ")}
    assert named
    assert {name for name in named if not hasattr(nodes, name)} == set()
