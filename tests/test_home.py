import os
from pathlib import Path

from learnblock.home import home, import_file


def test_home_is_where_the_environment_says(monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", "/somewhere")
    assert home() == Path("/somewhere")


def test_home_is_a_folder_of_the_system_named_learnblock_otherwise(monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", "")
    assert home().name == "learnblock"
    assert home().is_absolute()


def test_a_file_of_the_users_is_run_once_and_anew_when_it_has_changed(own_home):
    path = own_home / "robots" / "mine.py"
    path.parent.mkdir()
    path.write_text("speed = 1\n")
    first = import_file(path)
    assert import_file(path) is first
    path.write_text("speed = 20\n")
    os.utime(path, ns=(0, 0))
    assert import_file(path).speed == 20
