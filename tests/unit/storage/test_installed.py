import sys
from importlib import metadata

import pytest

from learnblock.storage import installed


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "path", [*sys.path, str(tmp_path)])
    return tmp_path


def install(folder, name):
    about = folder / f"{name}-1.dist-info"
    about.mkdir()
    (about / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1\n")
    (about / "entry_points.txt").write_text(f"[learnblock.skills]\n{name} = {name}.skills\n")


def names():
    return {point.name for point in installed.entry_points("learnblock.skills")}


def test_a_package_that_is_installed_meanwhile_is_found(folder):
    assert "dancing" not in names()
    install(folder, "dancing")
    assert "dancing" in names()


def test_a_package_in_a_folder_that_is_added_meanwhile_is_found(tmp_path, monkeypatch):
    install(tmp_path, "singing")
    assert "singing" not in names()
    monkeypatch.setattr(sys, "path", [*sys.path, str(tmp_path)])
    assert "singing" in names()


def test_packages_are_not_searched_twice_while_none_changes(folder, monkeypatch):
    searches = []

    def search():
        searches.append(len(searches))
        return metadata.EntryPoints()

    monkeypatch.setattr(metadata, "entry_points", search)
    for group in ("learnblock.robots", "learnblock.worlds", "learnblock.robots"):
        installed.entry_points(group)
    assert searches == [0]


def test_a_folder_that_does_not_exist_is_no_error(monkeypatch):
    monkeypatch.setattr(sys, "path", [*sys.path, "/nowhere/at/all", ""])
    names()
