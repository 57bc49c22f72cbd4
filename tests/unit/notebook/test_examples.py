"""The example notebooks, each in a real kernel."""

import re

import nbclient
import nbformat
import pytest

from page_files import content_in_frame
from places import ROOT

NOTEBOOKS = ROOT / "examples" / "notebooks"
NAMES = sorted(path.name for path in NOTEBOOKS.glob("*.ipynb"))

pytestmark = [
    pytest.mark.slow,
    pytest.mark.timeout(180),  # A kernel takes its time to start beside other tests.
]


@pytest.fixture(scope="module")
def executed(tmp_path_factory):
    """A function that executes a notebook once, and returns the outputs of its code cells."""
    made = {}

    def execute(name):
        if name not in made:
            notebook = nbformat.read(NOTEBOOKS / name, as_version=4)
            place = {"metadata": {"path": str(tmp_path_factory.mktemp("notebook"))}}
            client = nbclient.NotebookClient(
                notebook, timeout=150, kernel_name="python3", resources=place
            )
            client.execute()
            made[name] = [cell.outputs for cell in notebook.cells if cell.cell_type == "code"]
        return made[name]

    return execute


def texts(outputs):
    return "".join(output.get("text", "") for output in outputs)


def shown(outputs, kind="image/svg+xml"):
    return [output.data[kind] for output in outputs if kind in output.get("data", {})]


@pytest.mark.parametrize("name", NAMES)
def test_it_is_stored_without_its_outputs(name):
    notebook = nbformat.read(NOTEBOOKS / name, as_version=4)
    nbformat.validate(notebook)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert [(cell.outputs, cell.execution_count) for cell in cells] == [([], None)] * len(cells)


def test_the_square_is_shown_side_by_side_and_explained(executed):
    _, made, side, sides, pose, why = executed("square.ipynb")
    assert all(len(shown(outputs)) == 1 for outputs in (made, side, sides))
    # The run of the last cell that moved it, which tells the cells before it from that one.
    [page] = shown(sides, "text/html")
    assert content_in_frame(page)["robots"][0]["timeline"]["begin"] > 2
    assert shown(side, "text/html") == []
    driven = re.search(r"([\d.]+) m in", shown(sides)[0])
    assert float(driven[1]) == pytest.approx(0.6, abs=0.03)
    [ended] = shown(pose, "text/plain")
    assert all(abs(float(number)) < 20 for number in re.findall(r"-?[\d.]+", ended))
    assert "line 4 of [4] says turn(90)" in shown(why, "text/plain")[0]


@pytest.mark.exhaustive
def test_the_plots_of_the_line_show_what_a_gain_does(executed):
    outputs = executed("line-follower.ipynb")
    assert [len(shown(cell)) for cell in outputs] == [0, 0, 0, 1, 1, 1, 1, 0, 0]
    rows = re.findall(r"gain +(\S+), damping (\d): +(\S+)", texts(outputs[7]))
    error = {(gain, damping): float(distance) for gain, damping, distance in rows}
    assert error["1", "2"] < error["1", "0"] < error["0.2", "0"]
    assert error["4", "0"] < error["8", "0"]
    assert "set_move(speed, gain * position" in shown(outputs[8], "text/plain")[0]


@pytest.mark.exhaustive
def test_the_files_of_five_groups_become_the_data_of_a_class(executed):
    *_, number, distances, groups = executed("class-data.ipynb")
    assert shown(number, "text/plain") == ["250"]
    means = [float(mean) for mean in re.findall(r"mm: +(\S+) mm on average", texts(distances))]
    assert means == pytest.approx([100, 150, 200, 250, 300], abs=15)
    assert texts(groups).count("group-") == 5
