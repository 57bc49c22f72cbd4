"""Block-Text in a notebook."""

import nbclient
import nbformat
import pytest

from learnblock.notebook.program_cells import blocktext

SQUARE = """\
main:
    print("hello")
    repeat 4:
        function.drive_distance(200, 150)
        function.turn(90)
    end
end
"""
MISTAKE = "main:\n    functoin.turn(90)\nend\n"


@pytest.mark.slow
def test_a_cell_shows_what_the_program_prints_its_goals_and_its_way(capsys):
    picture = blocktext("--world square --seed 1", SQUARE)
    shown = capsys.readouterr()
    assert shown.out.startswith("hello\n")
    assert "goal       back at the start: reached" in shown.out
    assert shown.err == ""
    assert "<title>cell.bt on sim-ebo, world square, seed 1</title>" in picture._repr_svg_()


def test_a_mistake_is_shown_with_its_line_in_the_cell(capsys):
    assert blocktext("", MISTAKE) is None
    first, line, caret = capsys.readouterr().out.splitlines()
    assert first.startswith("cell.bt:2:5: not-block-text")
    assert ["functoin.turn(90)", "^" * 17] == [line.strip(), caret.strip()]


def test_a_wrong_option_is_reported(capsys):
    assert blocktext("--wrold square", SQUARE) is None
    assert "--world" in capsys.readouterr().out


def test_a_cell_leaves_nothing_in_the_folder_of_the_notebook(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    blocktext("", MISTAKE)
    assert [] == list(tmp_path.iterdir())


ROBOT = """\
from learnblock.robots.sim_ebo import Robot

robot = Robot(world="square")
robot.drive_distance(200)
robot
"""


@pytest.mark.exhaustive
@pytest.mark.timeout(180)  # A kernel takes its time to start beside other tests.
def test_it_works_in_a_real_kernel():
    python = [ROBOT, "%%time\nrobot.drive_distance(-50)", 'robot.why("why did it drive backwards")']
    cells = ["%load_ext learnblock.notebook", f"%%blocktext --world square\n{SQUARE}", *python]
    notebook = nbformat.v4.new_notebook(cells=list(map(nbformat.v4.new_code_cell, cells)))
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    _, blocktext_cell, python_cell, _, answer = (cell.outputs for cell in notebook.cells)
    assert "line 2 of [4] says drive_distance(-50)" in answer[-1].data["text/plain"]
    printed = [output for output in blocktext_cell if output.output_type == "stream"]
    assert {"stdout"} == {output.name for output in printed}
    assert "hello" in "".join(output.text for output in printed)
    for outputs in (blocktext_cell, python_cell):
        assert outputs[-1].data["image/svg+xml"].startswith("<svg")
