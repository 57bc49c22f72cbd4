"""The blocks of libraries, installed or next to a program."""

import json

import pytest

from learnblock.blocks.importable import Importable
from learnblock.blocks.installed_libraries import blocks, blocks_beside, importable, installed
from learnblock.blocks.known import all_configurations
from learnblock.blocks.palette import palette

MANIFEST = (
    'learnblock = 1\nname = "dance"\nversion = "1.0"\n[title]\nen = "Ball room"\nes = "Baile"\n'
)
SKILLS = 'def waltz(robot, times: int = 3) -> None:\n    "Dance."\n\ndef helper(name):\n    pass\n'


@pytest.fixture
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    return tmp_path / "home"


def library(folder, manifest=MANIFEST, skills=SKILLS, name="dance"):
    (folder / name).mkdir(parents=True)
    (folder / name / "library.toml").write_text(manifest)
    (folder / name / "__init__.py").write_text(skills)
    return folder / name


def test_the_blocks_of_a_library_have_its_name(home):
    library(home / "libraries")
    waltz = all_configurations()["waltz"]
    assert ("dance", "Ball room", "Dance.") == (waltz.library, waltz.category, waltz.tooltip["EN"])
    assert "helper" not in all_configurations()


def test_its_tab_has_its_title_in_the_language_of_the_page(home):
    library(home / "libraries")
    for language, title in (("en", "Ball room"), ("es", "Baile"), ("fr", "Ball room")):
        tabs = palette(all_configurations(), language)["toolbox"]["contents"]
        assert title in [tab["name"] for tab in tabs]


def test_a_configuration_adds_details_to_a_block():
    said = [{"type": "motor", "category": "Fast", "name": "waltz", "shape": ["blockVertical"],
             "languages": {"ES": "vals"}}]  # fmt: skip
    [waltz] = blocks("dance", {"__init__.py": SKILLS, "blocks.json": json.dumps(said)})
    assert ("motor", "Fast", {"EN": "waltz", "ES": "vals"}) == (
        waltz.type, waltz.category, dict(waltz.languages))  # fmt: skip


def test_a_broken_library_does_not_affect_other_blocks(home):
    library(home / "libraries", skills="def waltz(robot:\n")
    library(home / "libraries", name="songs")
    assert "songs" == all_configurations()["waltz"].library
    assert {"dance", "songs"} == set(installed())


def test_modules_are_imported_from_home_or_next_to_the_program(home, tmp_path):
    library(home / "libraries")
    library(tmp_path, name="songs")
    (tmp_path / "helper.py").write_text(SKILLS)
    (tmp_path / "more").mkdir()
    (tmp_path / "more" / "names.py").write_text("")
    assert importable() == Importable(frozenset({"dance"}))
    assert importable(tmp_path, frozenset({"more.names", "more.none"})) == Importable(
        frozenset({"dance", "songs"}), frozenset({"helper", "more.names"})
    )


def test_skills_next_to_a_program_are_blocks(home, tmp_path):
    library(tmp_path, name="songs", skills="def sing(robot): pass\n")
    (tmp_path / "helper.py").write_text(SKILLS)
    found = blocks_beside(tmp_path, frozenset({"songs", "helper", "none"}))
    assert {("waltz", "helper"), ("sing", "songs")} == {(one.name, one.library) for one in found}
