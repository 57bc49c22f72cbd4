"""The description of a new robot: what is wrong in it is told by line and name."""

import pytest

from learnblock.errors import RobotDescriptionError
from learnblock.new import template
from learnblock.new.robot_plan import named, parse_plan, plan_of, read_plan
from learnblock.simulator.robot_description import RobotFile
from new_robots import EVERYTHING, guide


@pytest.fixture
def read(tmp_path):
    def read(text):
        (tmp_path / "rover.toml").write_text(text, encoding="utf-8")
        return read_plan(tmp_path / "rover.toml")

    return read


def test_the_guides_description_is_one(read):
    plan = read(guide())
    assert plan.network.port == 4000
    assert plan.devices() == {"Base:ROBOT", "DistanceSensors:ROBOT"}
    assert type(plan.twin) is RobotFile


def test_a_description_may_name_every_device(read):
    assert len(read(EVERYTHING).devices()) == 20


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("port = 1\n", "port = 0\n", r"rover.toml:7:1: .*`network.port` is 0: expected a whole"),
        ("port = 1\n", "", "`network` lacks the key `port`"),
        ("robot.local", "a b", r'`network.address` is "a b": .* letters, digits, `.`'),
        ("robot.local", "x; rm", r"`network.address` is"),
        ("robot.local", "x\\n", r"`network.address` is"),
        ("& Co.", "\\n", r"`title` is"),
        ("[serial]", '[serial]\ndevice = "\\"; x"', "`serial.device` is"),
        ("[serial]", "[serial]\nbuad = 1", "did you mean `baud`?"),
        (
            'title = "',
            'title = "\\"\\"\\"',
            r"rover.toml:2:1: .*`title` is .*letters, digits, blanks",
        ),
        ('title = "', f'title = "{"x" * 80}', "a text of 0 to 60 characters"),
        ('world = "tags"', 'world = "tag"', r"rover.toml:3:1: .* no world `tag`; did you mean"),
        ("[gyroscope]", '[gyroscope]\nkey = "X"', "a robot's own gyroscope is Z_AXIS"),
        ('slot = "Rear"', 'slot = "a\\"b"', r"wrong-key the slot 'a\"b' is no word"),
        ('slot = "Rear"', 'slot = "$name"', r"wrong-key the slot '\$name' is no word"),
        ('key = "second"', 'key = "a\\nb"', "wrong-key the key"),
        ('key = "second"', "", r"of `camera`, two have the key `ROBOT`"),
        ("radius = 70", "radius = 500", "too-wide the body reaches 500 mm .* more than 400 has no"),
        ("shape = ", "form = ", "`body` has a key `form`, which is not known"),
    ],
)
def test_a_mistake_is_told_by_line_and_name(read, old, new, told):
    assert old in EVERYTHING
    with pytest.raises(RobotDescriptionError, match=told):
        read(EVERYTHING.replace(old, new, 1))


def test_values_from_elsewhere_are_checked_alike():
    with pytest.raises(RobotDescriptionError, match="lacks the key `body`"):
        plan_of({})


def test_a_description_gets_another_name(read):
    assert named(read(guide()), "rover").name == "rover"


def test_the_description_that_a_page_begins_with_is_that_of_the_guide():
    description = template.read("robot/description.toml")
    assert guide().strip() == description.strip()
    assert parse_plan(description).title == "Pathfinder"
