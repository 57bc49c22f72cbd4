"""Custom blocks in the user's folder: saved, copied, deleted and exported."""

import json
from pathlib import Path

import pytest

from learnblock.blocks.known import all_configurations
from learnblock.errors import (
    BlockConfigurationError,
    CustomBlockError,
    LearnBlockError,
    UnknownNameError,
)
from learnblock.extensions import custom_blocks
from learnblock.testing import FakeRobot

DANCE = """\
def waltz(robot, times: int = 3) -> int:
    "Dance."
    return times if times < 2 else waltz(robot, 1) + robot.tango()


def tango(robot) -> int:
    return 40
"""
WORDS = json.dumps(
    {
        "type": "motor",
        "category": "Ball",
        "name": "waltz",
        "shape": ["blockLeft"],
        "languages": {"ES": "vals"},
    }
)


@pytest.fixture
def dance():
    return custom_blocks.save("dance", DANCE, WORDS)


def names():
    return [one.name for one in custom_blocks.load_all()]


def test_a_saved_block_exists_and_runs(dance):
    (block,) = custom_blocks.load_all()

    assert ("dance", "Ball", ("waltz", "tango"), ()) == (
        block.name,
        block.category,
        block.functions,
        block.problems,
    )
    assert {"EN": "waltz", "ES": "vals"} == all_configurations()["waltz"].languages
    with FakeRobot() as robot:
        assert 41 == robot.waltz()


def test_an_invalid_block_is_not_saved():
    assert custom_blocks.save("dance", "def turn(robot): ...\n").errors
    assert [] == names()


def test_a_name_is_taken_in_any_spelling(dance):
    with pytest.raises(CustomBlockError, match="already have a block 'Dance'"):
        custom_blocks.save("Dance", "def hop(robot): ...\n")


def test_a_block_gets_another_name(dance, own_home):
    custom_blocks.save("ball", DANCE, WORDS, replaces="dance")

    assert ["ball"] == names()
    assert {"ball.py", "ball.json"} == {
        path.name for path in own_home.rglob("*.*") if path.is_file()
    }


def test_a_missing_block_cannot_be_replaced():
    with pytest.raises(UnknownNameError, match="There is no custom block 'gone'"):
        custom_blocks.save("dance", DANCE, replaces="gone")


def test_a_copy_uses_its_new_names_everywhere(dance):
    copy = custom_blocks.duplicate("dance", "dance again")

    assert ("waltz_2", "tango_2") == copy.functions
    assert "waltz_2(robot, 1) + robot.tango_2()" in copy.source
    assert {"ES": "vals", "EN": "waltz 2"} == all_configurations()["waltz_2"].languages
    with FakeRobot() as robot:
        assert 41 == robot.waltz_2()


def test_the_only_function_gets_the_name_of_the_copy():
    custom_blocks.save("hop", "def hop(robot): 'é'; hop(robot)\n")

    assert ("big_hop",) == custom_blocks.duplicate("hop", "big hop").functions
    assert "def big_hop(robot): 'é'; big_hop(robot)\n" == custom_blocks.find("big hop").source


def test_a_deleted_block_can_be_restored(dance):
    custom_blocks.delete("dance")

    assert [] == names()
    assert "waltz" not in all_configurations()
    assert "Ball" == custom_blocks.restore("dance").category
    assert ["dance"] == names()


def test_a_block_without_a_configuration_is_restored_without_one(dance, own_home):
    custom_blocks.delete("dance")
    custom_blocks.save("dance", DANCE)
    (own_home / "blocks" / "dance.json").unlink()
    custom_blocks.delete("dance")

    assert "Dance" == custom_blocks.restore("dance").category


def test_restoring_never_replaces_another_block(dance):
    custom_blocks.delete("dance")
    custom_blocks.save("dance", "def hop(robot): ...\n")

    with pytest.raises(CustomBlockError, match="already"):
        custom_blocks.restore("dance")


@pytest.mark.parametrize("name", ["../other", "/etc/passwd", "deleted/dance", ""])
@pytest.mark.parametrize(
    "change",
    [custom_blocks.find, custom_blocks.delete, custom_blocks.restore, custom_blocks.export],
)
def test_a_name_never_leads_outside_the_folder(change, name):
    with pytest.raises(LearnBlockError):
        change(name)


def test_a_block_is_moved_to_another_home_as_one_file(dance, tmp_path, monkeypatch):
    filename, text = custom_blocks.export("dance")
    before = custom_blocks.find("dance")
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "fresh"))

    assert "dance.block.json" == filename
    assert before == custom_blocks.import_file(text)


def test_a_configuration_without_outer_braces_is_exported(dance, own_home, monkeypatch):
    by_hand = """
      "type": "motor", "category": "By hand", "name": "waltz", "shape": ["blockLeft"]
    """
    (own_home / "blocks" / "dance.json").write_text(by_hand)
    _, text = custom_blocks.export("dance")
    monkeypatch.setenv("LEARNBLOCK_HOME", str(own_home / "fresh"))

    assert "By hand" == custom_blocks.import_file(text).category


def test_a_block_with_an_invalid_configuration_is_not_exported(dance, own_home):
    (own_home / "blocks" / "dance.json").write_text("{")

    with pytest.raises(BlockConfigurationError, match="not-json"):
        custom_blocks.export("dance")


def test_a_block_is_replaced_only_on_request(dance):
    _, text = custom_blocks.export("dance")

    with pytest.raises(CustomBlockError, match="already have a block 'dance'"):
        custom_blocks.import_file(text)
    assert "dance" == custom_blocks.import_file(text, replace=True).name


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"learnblock_block": 2}, "Update LearnBlock"),
        ({"name": "../evil"}, "A block cannot be named"),
        ({"source": "text"}, "This is not a block exported from LearnBlock"),
        ({"source": ["def turn(robot): ..."]}, "LearnBlock already has a skill 'turn'"),
        ({"more": 1}, "This is not a block"),
        ({"configuration": [{"type": "motors"}]}, "motor"),
    ],
)
def test_an_invalid_file_is_refused(dance, change, message):
    values = json.loads(custom_blocks.export("dance")[1])
    custom_blocks.delete("dance")

    with pytest.raises(CustomBlockError, match=message):
        custom_blocks.import_file(json.dumps({**values, **change}))
    assert [] == names()


@pytest.mark.parametrize("text", ["", "[]", "[" * 100_000, "x" * 2_000_001, '{"learnblock": 1}'])
def test_another_file_is_refused(text):
    with pytest.raises(CustomBlockError):
        custom_blocks.import_file(text)


def test_a_broken_file_is_listed_with_its_problems(own_home):
    (own_home / "skills").mkdir()
    (own_home / "skills" / "bad.py").write_text("def waltz(robot:\n")
    (own_home / "skills" / "odd name!.py").write_text("def hop(robot): ...\n")
    bad, odd = custom_blocks.load_all()

    assert ("waltz",) == bad.functions
    assert "syntax-error" == bad.problems[0].diagnostic.code
    assert () == odd.problems
    assert not custom_blocks.save(
        "odd name!", "def hop(robot): 'Hop.'\n", replaces="odd name!"
    ).errors


def test_a_link_to_a_folder_is_not_a_block(own_home):
    (own_home / "skills" / "folder.py").mkdir(parents=True)

    assert () == custom_blocks.load_all()
    assert Path(own_home / "skills" / "folder.py").is_dir()
