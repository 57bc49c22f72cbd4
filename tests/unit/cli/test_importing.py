"""`learnblock import` on the command line."""

import json

import pytest
from click.testing import CliRunner

from learnblock import language
from learnblock.blocks import builtin
from learnblock.cli import main
from learnblock.extensions.libraries import find
from learnblock.project.files.project_file import decode
from old_projects import LIBRARY, STYLES, Old, forever, project, skill
from old_projects import main as main_block

SQUARE = project(main_block(forever(skill("mover_recto"), skill("turn_90_right"))))


@pytest.fixture
def call(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    return lambda *arguments: CliRunner().invoke(main, ["import", *arguments])


def test_a_project_becomes_a_project_of_the_page(call, tmp_path):
    (tmp_path / "square.blockProject").write_bytes(SQUARE)
    result = call("square.blockProject")
    assert result.exit_code == 0, result.output
    made = decode((tmp_path / "square.learnblock").read_bytes(), "square")
    assert "function.move_straight()" in made.blocktext
    assert made.workspace.stacks[0][0].type == "lb_main"
    assert "'mover_recto' is now called 'move_straight'" in result.stdout


def test_a_project_becomes_block_text_that_checks_and_runs(call, tmp_path):
    (tmp_path / "square.blockProject").write_bytes(SQUARE)
    assert call("square.blockProject", "--to", "block-text").exit_code == 0
    check = CliRunner().invoke(main, ["check", "square.bt", "--robot", "sim-ebo"])
    assert (check.exit_code, check.stdout) == (0, "square.bt: no problems\n")
    run = CliRunner().invoke(main, ["run", "square.bt", "--for", "5"])
    assert run.exit_code == 0, run.output


def test_an_existing_file_is_only_replaced_when_asked(call, tmp_path):
    (tmp_path / "square.blockProject").write_bytes(SQUARE)
    (tmp_path / "square.learnblock").write_text("mine")
    refused = call("square.blockProject")
    assert refused.exit_code == 1
    assert "square.learnblock exists" in refused.stderr
    assert (tmp_path / "square.learnblock").read_text() == "mine"
    assert call("square.blockProject", "--replace").exit_code == 0


def test_a_folder_is_imported_with_its_folders_and_one_bad_file_does_not_stop_the_others(
    call, tmp_path
):
    (tmp_path / "old" / "deep").mkdir(parents=True)
    (tmp_path / "old" / "deep" / "square.blockProject").write_bytes(SQUARE)
    (tmp_path / "old" / "bad.blockProject").write_bytes(b"cos\nsystem\n.")
    result = call("old", "--output", "new", "--json")
    assert result.exit_code == 1
    bad, good = json.loads(result.stdout)
    assert "os.system" in bad["error"]
    assert good["error"] is None
    assert (tmp_path / "new" / "deep" / "square.learnblock").is_file()


def test_a_library_folder_becomes_a_library_and_part_of_the_programs_that_use_it(call, tmp_path):
    folder = tmp_path / "old" / "Paso"
    folder.mkdir(parents=True)
    (folder / "Paso.lb").write_text(
        "def Paso():\n\tif function.front_obstacle(60):\n\t\tfunction.parar()\n\tend\n"
        '\tprint "hecho"\nend\n\n'
    )
    (folder / "Paso.conf").write_text(
        json.dumps([{"name": "Paso", "type": "library", "languages": {"ES": "dar un paso"}}])
    )
    (folder / "Paso.py").write_text("def Paso():\n\tpass\n\ndef extra(lbot):\n\tlbot.x()\n")
    uses = project(main_block(Old("Paso", LIBRARY)), libraries=["/home/ana/Paso"])
    (tmp_path / "old" / "uses.blockProject").write_bytes(uses)
    result = call("old", "--output", "new")
    assert result.exit_code == 0, result.output
    assert "extra" in result.stdout
    library = find(str(tmp_path / "new" / "Paso" / "Paso.lblib"))
    assert library.skills["Paso"].languages["ES"] == "dar un paso"
    made = decode((tmp_path / "new" / "uses.learnblock").read_bytes(), "uses")
    assert "    if function.is_front_obstacle(60):" in made.blocktext
    assert language.check(language.parse(made.blocktext), builtin()) == []


@pytest.mark.parametrize("style", STYLES)
def test_the_file_of_every_version_is_imported(call, tmp_path, style):
    (tmp_path / "a.blockProject").write_bytes(project(main_block(skill("turn_back")), style=style))
    assert call("a.blockProject").exit_code == 0


def test_other_files_and_empty_folders_are_refused_with_what_to_choose(call, tmp_path):
    (tmp_path / "empty").mkdir()
    (tmp_path / "a.txt").write_text("a")
    for given in ("empty", "a.txt"):
        result = call(given)
        assert result.exit_code == 1
        assert ".blockProject" in result.stderr
