"""Libraries on the command line, from one user's program to another's."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from learnblock.cli import main

DANCE = """steps = 0

# Dance a waltz.
def waltz(times):
    repeat times:
        step(10)
    end
end

def step(distance):
    steps += 1
    function.move_straight(distance)
    function.sleep(0.5)
    function.stop_bot()
    print("step", steps)
end

main:
    waltz(2)
end
"""
OTHER = "def waltz():\n    print('another')\nend\n"
USE = 'import "dance"\nimport "songs"\n\nmain:\n    function.waltz(2)\n    function.{0}()\nend\n'

NONE_INSTALLED = "No libraries are installed. Install one with: learnblock library import FILE\n"


@pytest.fixture
def run(tmp_path, monkeypatch):
    """Run a command in the folder `tmp_path`, with an empty home."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    Path("dance.bt").write_text(DANCE)
    Path("songs.bt").write_text(OTHER)

    def of(*args):
        result = CliRunner().invoke(main, args)
        return result.exit_code, result.output

    return of


def exported(run):
    run("library", "export", "dance.bt", "--functions", "waltz", "--name", "dance")
    run("library", "export", "songs.bt", "--functions", "waltz", "--name", "songs")


def test_functions_are_exported_with_the_functions_that_they_call(run):
    args = ("library", "export", "dance.bt", "--functions", "waltz", "--name", "dance")
    assert run(*args) == (0, "dance.lblib: waltz, step\n")
    assert run(*args) == (
        2,
        "learnblock: dance.lblib already exists. Add --replace, or choose another --name.\n",
    )
    assert run(*args, "--replace", "--as", "folder") == (0, "dance: waltz, step\n")
    assert Path("dance", "functions.bt").is_file()


def test_a_refused_export_names_the_line(run):
    Path("dance.bt").write_text(DANCE + "# end\n" + "")
    Path("late.bt").write_text("def f():\n    return speed\nend\nmain:\n    speed = 1\nend\n")
    code, said = run("library", "export", "late.bt", "--functions", "f", "--name", "late")
    assert (1, "late.bt:2:12: shared-variable") == (code, said[:29])


def test_a_folder_that_is_not_a_library_is_never_replaced(run):
    Path("dance").mkdir()
    Path("dance", "precious.txt").write_text("")
    args = ("library", "export", "dance.bt", "--functions", "waltz", "--name", "dance")
    assert run(*args, "--as", "folder", "--replace")[0] == 2
    assert Path("dance", "precious.txt").exists()


def test_several_are_imported_at_once_and_a_clash_is_resolved_by_a_new_name(run):
    exported(run)
    code, said = run("library", "import", "dance.lblib", "songs")
    assert code == 1
    assert "The skill 'waltz' of the library songs already exists in the library dance." in said
    assert run("library", "list")[1] == NONE_INSTALLED
    code, said = run("library", "import", "songs", "--rename", "waltz=ball_waltz")
    assert (code, said) == (0, "Imported songs 1.0.0: ball_waltz\n")
    assert run("library", "import", "dance.lblib")[0] == 0
    assert run("library", "list")[1].splitlines() == [
        "dance            1.0.0    waltz, step",
        "songs            1.0.0    ball_waltz",
    ]
    assert run("library", "import", "dance")[1].startswith("Already installed: dance 1.0.0")


def test_a_program_with_imported_functions_runs_like_the_one_they_came_from(run):
    exported(run)
    run("library", "import", "songs", "--rename", "waltz=ball_waltz")
    run("library", "import", "dance")
    Path("use.bt").write_text(USE.format("ball_waltz"))
    assert run("check", "use.bt") == (0, "use.bt: no problems\n")
    assert "step 1\nstep 2\nanother\n" in run("run", "use.bt", "--robot", "sim-ebo")[1]
    used, original = (
        json.loads(run("run", name, "--robot", "sim-ebo", "--json")[1])
        for name in ("use.bt", "dance.bt")
    )
    assert (used["distance"], used["time"]) == (original["distance"], original["time"])


def test_a_missing_import_is_named(run):
    exported(run)
    run("library", "import", "dance")
    Path("use.bt").write_text("main:\n    function.waltz(2)\nend\n")
    code, said = run("check", "use.bt")
    assert code == 1
    assert "belongs to the library 'dance'. Write 'import \"dance\"' at the top" in said


def test_an_older_version_is_refused(run):
    exported(run)
    run("library", "import", "dance")
    args = ("library", "export", "dance.bt", "--functions", "step", "--name", "dance")
    run(*args, "--version", "0.9", "--replace")
    code, said = run("library", "import", "dance")
    assert code == 1
    assert "Version 1.0.0 of the library dance is installed, and 0.9 is not newer" in said
    assert run("library", "import", "dance", "--replace")[0] == 0


def test_a_library_is_shown_and_removed(run):
    exported(run)
    assert run("library", "show", "dance.lblib") == (
        0,
        "dance 1.0.0\n  function.waltz(times)  Dance a waltz.\n  function.step(distance)  step\n",
    )
    run("library", "import", "dance")
    assert json.loads(run("library", "show", "dance", "--json")[1])["skills"] == ["waltz", "step"]
    assert run("library", "remove", "dance") == (0, "Removed dance\n")
    assert run("library", "remove", "dance")[0] == 2


@pytest.mark.parametrize("value", ["waltz", "=x", "waltz="])
def test_an_invalid_renaming_is_reported(run, value):
    exported(run)
    assert run("library", "import", "dance", "--rename", value)[0] == 2
