import os
from pathlib import Path

from learnblock.storage.home import home, import_file


def test_home_is_set_by_the_environment(monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", "/somewhere")
    assert home() == Path("/somewhere")


def test_home_is_otherwise_a_folder_named_learnblock_for_the_systems_configuration(monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", "")
    assert home().name == "learnblock"
    assert home().is_absolute()


def test_a_file_in_the_users_folder_is_run_once_and_again_only_after_a_change(own_home):
    path = own_home / "robots" / "mine.py"
    path.parent.mkdir()
    path.write_text("speed = 1\n")
    first = import_file(path)
    assert import_file(path) is first
    path.write_text("speed = 20\n")
    os.utime(path, ns=(0, 0))
    assert import_file(path).speed == 20
