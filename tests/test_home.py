from pathlib import Path

from learnblock.home import home


def test_home_is_where_the_environment_says(monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", "/somewhere")
    assert home() == Path("/somewhere")


def test_home_is_a_folder_of_the_system_named_learnblock_otherwise(monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", "")
    assert home().name == "learnblock"
    assert home().is_absolute()
