"""The description of a new robot: mistakes are reported with their line."""

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


def test_the_description_in_the_guide_is_valid(read):
    plan = read(guide())
    assert plan.network.port == 4000
    assert plan.devices() == ("Base:ROBOT", "DistanceSensors:ROBOT")
    assert type(plan.twin) is RobotFile


def test_a_description_may_name_every_device(read):
    assert len(read(EVERYTHING).devices()) == 20


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("port = 1\n", "port = 0\n", r"rover.toml:7:1: .*'network.port' is 0, but must be a whole"),
        ("port = 1\n", "", "The key 'port' is missing from 'network'"),
        ("robot.local", "a b", r"'network.address' is \"a b\", .* letters, digits, \."),
        ("robot.local", "x; rm", r"'network.address' is"),
        ("robot.local", "x\\n", r"'network.address' is"),
        ("& Co.", "\\n", r"'title' is"),
        ("[serial]", '[serial]\ndevice = "\\"; x"', "'serial.device' is"),
        ("[serial]", "[serial]\nbuad = 1", "Did you mean 'baud'?"),
        (
            'title = "',
            'title = "\\"\\"\\"',
            r"rover.toml:2:1: .*'title' is .*letters, digits, spaces",
        ),
        ('title = "', f'title = "{"x" * 80}', "text of 0 to 60 characters"),
        ('world = "tags"', 'world = "tagz"', r"rover.toml:3:1: .* no world 'tagz'. Did you mean"),
        ("[gyroscope]", '[gyroscope]\nkey = "X"', "must be Z_AXIS, not X"),
        ('slot = "Rear"', 'slot = "a\\"b"', r"wrong-key The slot 'a\"b' is not a word"),
        ('slot = "Rear"', 'slot = "$name"', r"wrong-key The slot '\$name' is not a word"),
        ('key = "second"', 'key = "a\\nb"', "wrong-key The key"),
        ('key = "second"', "", r"Two cameras have the key 'ROBOT'"),
        ("radius = 70", "radius = 500", "too-wide The body reaches 500 mm .* room for 400 mm"),
        ("shape = ", "form = ", "The key 'form' is unknown in 'body'"),
    ],
)
def test_a_mistake_is_reported_with_its_line(read, old, new, message):
    assert old in EVERYTHING
    with pytest.raises(RobotDescriptionError, match=message):
        read(EVERYTHING.replace(old, new, 1))


def test_values_from_other_sources_are_checked_too():
    with pytest.raises(RobotDescriptionError, match="The key 'body' is missing from the file"):
        plan_of({})


def test_a_description_gets_another_name(read):
    assert named(read(guide()), "rover").name == "rover"


def test_the_template_on_the_page_is_the_description_in_the_guide():
    description = template.read("robot/description.toml")
    assert guide().strip() == description.strip()
    assert parse_plan(description).title == "Pathfinder"
