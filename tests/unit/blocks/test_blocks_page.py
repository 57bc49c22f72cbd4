"""The examples of docs/blocks.md, in the order of the page."""

import re

import pytest

from learnblock.blocks import load_configurations
from learnblock.blocks.known import all_configurations
from learnblock.errors import BlockConfigurationError
from learnblock.extensions import custom_blocks
from learnblock.fields import Range
from learnblock.perception.tag_names import tag_id
from learnblock.testing import FakeRobot
from places import ROOT

PAGE = (ROOT / "docs" / "blocks.md").read_text("utf-8")


def examples(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```$", PAGE, re.DOTALL | re.MULTILINE)


@pytest.fixture
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    for folder in ("skills", "blocks"):
        (tmp_path / folder).mkdir()
    (tmp_path / "skills" / "dance.py").write_text(examples("python")[0])
    return tmp_path


def test_the_skill_runs_on_a_robot(home):
    with FakeRobot() as robot:
        robot.move_straight(80)
        exec(examples("python")[1], {"robot": robot})  # noqa: S102 - the page's own program

        assert ("Base.move", 0, 45) in robot.commands
        assert 4 == robot.clock.time()


def test_the_skill_has_no_effect_on_a_robot_without_wheels(home):
    with FakeRobot(only=[]) as robot:
        robot.waltz()

        assert robot.is_fast() is False
        assert [] == robot.commands


def test_the_example_of_a_test_passes(home):
    exec(examples("python")[4], {})  # noqa: S102 - the page's own program


def test_the_skill_is_a_block_before_it_is_configured(home):
    blocks = all_configurations()

    assert "Dance a waltz: sway to the right and to the left." == blocks["waltz"].tooltip["EN"]
    assert blocks["is_fast"].returns_value


def test_each_hint_of_the_page_names_a_field(home):
    (home / "skills" / "paint.py").write_text(examples("python")[2])
    paint = all_configurations()["paint"]

    assert ["float", "choice", "colour", "angle"] == [one.type for one in paint.parameters]
    assert (Range(0, 100), ("thin", "thick")) == (
        paint.parameters[0].range,
        paint.parameters[1].choices,
    )
    with FakeRobot() as robot:
        robot.paint(direction=0)
        assert ("RGBLed:Up.set_color", 255, 136, 0) in robot.commands


def test_the_check_finds_no_problem_in_the_files_of_the_page():
    for source in (examples("python")[0], *examples("python")[2:4]):
        assert () == custom_blocks.check(source).problems
    assert () == custom_blocks.check(examples("python")[0], examples("json")[0]).problems


def test_the_configuration_gives_it_a_colour_a_tab_and_a_language(home):
    (home / "blocks" / "dance.json").write_text(examples("json")[0], "utf-8")
    waltz = all_configurations()["waltz"]

    assert ("motor", "Dance", ("Base",)) == (waltz.type, waltz.category, waltz.needs)
    assert {"EN": "waltz", "ES": "bailar un vals"} == waltz.languages
    assert {"EN", "ES"} == set(waltz.tooltip)
    assert {"EN": "speed", "ES": "velocidad"} == waltz.parameters[1].translations


def test_the_message_on_the_page_is_the_real_one():
    # On the page the file begins with the type, as it does here.
    source = (
        '{\n  "type": "motors",\n  "category": "Dance", "name": "waltz", "shape": ["blockLeft"]}'
    )

    with pytest.raises(BlockConfigurationError) as caught:
        load_configurations(source)
    message = caught.value.diagnostics[0].located("dance.json")
    assert f"{message}\n" == examples("text")[1]


def test_the_names_of_tags_are_known(home):
    (home / "tags.toml").write_text(examples("toml")[0])

    assert (3, 12) == (tag_id("ball"), tag_id("red door"))
