"""Blocks of one's own where they are kept: saved, copied, deleted, given away."""

import json
from pathlib import Path

import pytest

from learnblock import own_blocks
from learnblock.blocks import all_configurations
from learnblock.errors import (
    BlockConfigurationError,
    LearnBlockError,
    OwnBlockError,
    UnknownNameError,
)
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
    return own_blocks.save("dance", DANCE, WORDS)


def names():
    return [one.name for one in own_blocks.own_blocks()]


def test_a_saved_block_is_there_and_runs(dance):
    (block,) = own_blocks.own_blocks()

    assert ("dance", "Ball", ("waltz", "tango"), ()) == (
        block.name,
        block.category,
        block.functions,
        block.problems,
    )
    assert {"EN": "waltz", "ES": "vals"} == all_configurations()["waltz"].languages
    with FakeRobot() as robot:
        assert 41 == robot.waltz()


def test_a_wrong_one_is_not_saved():
    assert own_blocks.save("dance", "def turn(robot): ...\n").errors
    assert [] == names()


def test_a_name_is_taken_once_however_it_is_written(dance):
    with pytest.raises(OwnBlockError, match="you have a block `Dance` already"):
        own_blocks.save("Dance", "def hop(robot): ...\n")


def test_a_block_gets_another_name(dance, own_home):
    own_blocks.save("ball", DANCE, WORDS, replaces="dance")

    assert ["ball"] == names()
    assert {"ball.py", "ball.json"} == {
        path.name for path in own_home.rglob("*.*") if path.is_file()
    }


def test_a_block_that_is_not_there_cannot_be_replaced():
    with pytest.raises(UnknownNameError, match="no block of your own `gone`"):
        own_blocks.save("dance", DANCE, replaces="gone")


def test_a_copy_has_names_that_are_free_wherever_it_speaks_of_them(dance):
    copy = own_blocks.duplicate("dance", "dance again")

    assert ("waltz_2", "tango_2") == copy.functions
    assert "waltz_2(robot, 1) + robot.tango_2()" in copy.source
    assert {"ES": "vals", "EN": "waltz 2"} == all_configurations()["waltz_2"].languages
    with FakeRobot() as robot:
        assert 41 == robot.waltz_2()


def test_the_only_function_is_called_as_the_copy():
    own_blocks.save("hop", "def hop(robot): 'é'; hop(robot)\n")

    assert ("big_hop",) == own_blocks.duplicate("hop", "big hop").functions
    assert "def big_hop(robot): 'é'; big_hop(robot)\n" == own_blocks.find("big hop").source


def test_what_is_deleted_is_kept_and_can_be_brought_back(dance):
    own_blocks.delete("dance")

    assert [] == names()
    assert "waltz" not in all_configurations()
    assert "Ball" == own_blocks.restore("dance").category
    assert ["dance"] == names()


def test_a_block_without_a_configuration_comes_back_without_one(dance, own_home):
    own_blocks.delete("dance")
    own_blocks.save("dance", DANCE)
    (own_home / "blocks" / "dance.json").unlink()
    own_blocks.delete("dance")

    assert "Dance" == own_blocks.restore("dance").category


def test_nothing_is_brought_back_over_another_one(dance):
    own_blocks.delete("dance")
    own_blocks.save("dance", "def hop(robot): ...\n")

    with pytest.raises(OwnBlockError, match="already"):
        own_blocks.restore("dance")


@pytest.mark.parametrize("name", ["../other", "/etc/passwd", "deleted/dance", ""])
@pytest.mark.parametrize(
    "change", [own_blocks.find, own_blocks.delete, own_blocks.restore, own_blocks.export]
)
def test_a_name_never_leads_out_of_the_folder(change, name):
    with pytest.raises(LearnBlockError):
        change(name)


def test_a_block_goes_to_another_home_as_one_file(dance, tmp_path, monkeypatch):
    filename, text = own_blocks.export("dance")
    before = own_blocks.find("dance")
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "fresh"))

    assert "dance.block.json" == filename
    assert before == own_blocks.import_file(text)


def test_a_configuration_by_hand_without_outer_braces_goes_along(dance, own_home, monkeypatch):
    by_hand = """
      "type": "motor", "category": "By hand", "name": "waltz", "shape": ["blockLeft"]
    """
    (own_home / "blocks" / "dance.json").write_text(by_hand)
    _, text = own_blocks.export("dance")
    monkeypatch.setenv("LEARNBLOCK_HOME", str(own_home / "fresh"))

    assert "By hand" == own_blocks.import_file(text).category


def test_a_block_with_a_wrong_configuration_is_not_given_away(dance, own_home):
    (own_home / "blocks" / "dance.json").write_text("{")

    with pytest.raises(BlockConfigurationError, match="not-json"):
        own_blocks.export("dance")


def test_a_block_is_replaced_only_if_that_is_meant(dance):
    _, text = own_blocks.export("dance")

    with pytest.raises(OwnBlockError, match="you have a block `dance` already"):
        own_blocks.import_file(text)
    assert "dance" == own_blocks.import_file(text, replace=True).name


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"learnblock_block": 2}, "a newer one may read it"),
        ({"name": "../evil"}, "a block cannot be called"),
        ({"source": "text"}, "this is no block that LearnBlock has exported"),
        ({"source": ["def turn(robot): ..."]}, "LearnBlock has a skill of this name"),
        ({"more": 1}, "this is no block"),
        ({"configuration": [{"type": "motors"}]}, "motor"),
    ],
)
def test_a_wrong_file_is_refused(dance, change, message):
    values = json.loads(own_blocks.export("dance")[1])
    own_blocks.delete("dance")

    with pytest.raises(OwnBlockError, match=message):
        own_blocks.import_file(json.dumps({**values, **change}))
    assert [] == names()


@pytest.mark.parametrize("text", ["", "[]", "[" * 100_000, "x" * 2_000_001, '{"learnblock": 1}'])
def test_what_is_no_such_file_is_refused(text):
    with pytest.raises(OwnBlockError):
        own_blocks.import_file(text)


def test_a_broken_file_is_listed_with_what_is_wrong(own_home):
    (own_home / "skills").mkdir()
    (own_home / "skills" / "bad.py").write_text("def waltz(robot:\n")
    (own_home / "skills" / "odd name!.py").write_text("def hop(robot): ...\n")
    bad, odd = own_blocks.own_blocks()

    assert ("waltz",) == bad.functions
    assert "syntax-error" == bad.problems[0].diagnostic.code
    assert () == odd.problems
    assert not own_blocks.save("odd name!", "def hop(robot): 'Hop.'\n", replaces="odd name!").errors


def test_a_link_to_a_folder_is_no_block(own_home):
    (own_home / "skills" / "folder.py").mkdir(parents=True)

    assert () == own_blocks.own_blocks()
    assert Path(own_home / "skills" / "folder.py").is_dir()
