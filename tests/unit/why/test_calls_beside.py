"""The call graphs of two runs side by side: only the robot's own rows differ."""

import json
import re

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.why.calls import Layer, calls
from learnblock.why.calls_beside import beside
from learnblock.why.graph_picture import pictures_beside
from logged_runs import logged_example
from runs import EXAMPLES


@pytest.fixture(scope="module")
def both():
    graphs = [
        calls(logged_example("square.bt", robot, world="square", seconds=60).history)
        for robot in ("sim-ebo", "sim-ev3")
    ]
    return beside(*graphs)


def test_program_and_skills_are_the_same_on_two_robots(both):
    assert set(both.differing) <= {Layer.CLIENT, Layer.DEVICES, Layer.DRIVER}
    assert Layer.DRIVER in both.differing
    assert not any(pair.differs for pair in both.pairs if pair.called.layer <= Layer.SKILLS)


def test_rows_are_in_order_and_those_of_both_come_first(both):
    order = [(pair.called.layer, pair.differs) for pair in both.pairs]
    assert order == sorted(order)


def test_a_run_beside_itself_differs_nowhere(both):
    assert beside(both.first, both.first).differing == ()


def test_the_picture_has_every_function_at_one_place_in_both_graphs(both):
    titles = {layer: layer.name for layer in Layer}
    drawn = pictures_beside(both, titles, ("one", "<two>"))
    assert "&lt;two&gt;" in drawn
    places = re.findall(r'<title>([^<:]+):[^<]*</title><rect x="(-?\d+)" y="(\d+)"', drawn)
    assert len(places) == len(both.first.nodes) + len(both.second.nodes)
    assert len(set(places)) == len({name for name, _, _ in places})
    marked = len(re.findall('stroke-width="4"', drawn))
    assert marked == sum(pair.differs for pair in both.pairs)


@pytest.fixture(scope="module")
def logs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("logs")
    files = []
    for robot in ("sim-ebo", "sim-ev3"):
        file = folder / f"{robot}.why"
        given = [str(EXAMPLES / "square.bt"), "--robot", robot, "--world", "square"]
        CliRunner().invoke(main, ["run", *given, "--for", "60", "--why", str(file)])
        files.append(str(file))
    return files


def test_the_command_prints_both_columns_and_marks_what_one_lacks(logs):
    output = CliRunner().invoke(main, ["calls", *logs]).output
    assert "sim-ebo.why (sim-ebo)" in output
    [turn] = [line for line in output.splitlines() if line.startswith("  set_orientation ")]
    assert turn.count("4x ") == 2
    assert any(line.startswith("* ") and "–" in line for line in output.splitlines())
    assert output.splitlines()[-1].startswith("Only these rows differ: ")


def test_the_command_prints_pairs_for_tools_and_draws_a_picture(logs, tmp_path):
    picture = tmp_path / "both.svg"
    given = [*logs, "--json", "--svg", str(picture)]
    found = json.loads(CliRunner().invoke(main, ["calls", *given]).output)
    assert {"first", "second", "pairs"} == found.keys()
    assert any(pair["first"] is None for pair in found["pairs"])
    assert picture.read_text().startswith("<svg")


def test_more_than_two_logs_are_refused_in_words(logs):
    result = CliRunner().invoke(main, ["calls", *logs, logs[0]])
    assert result.exit_code == 2
    assert "Give one log, or 2" in result.output
