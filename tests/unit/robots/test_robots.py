import textwrap
from importlib.metadata import EntryPoint, EntryPoints

import pytest

from learnblock import robots
from learnblock.client import Client
from learnblock.errors import LearnBlockError, UnknownNameError


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    folder = tmp_path / "robots"
    folder.mkdir()
    return folder


ROBOT = """
from learnblock.client import Client

class Robot(Client):
    pass
"""


def test_the_built_in_robots_are_listed():
    assert {"sim-ebo", "sim-thymio", "sim-ev3", "sim-cozmo"} <= robots.entries().keys()


@pytest.mark.parametrize("name", ["sim-ebo", "learnblock.robots.sim_ebo"])
def test_a_robot_is_found_by_its_name_and_by_its_module(name):
    assert robots.find(name) == robots.RobotEntry(
        "sim-ebo", "learnblock.robots.sim_ebo", simulated=True
    )


def test_a_robot_loads_as_a_client():
    assert issubclass(robots.find("sim-ebo").load(), Client)


def test_a_misspelt_robot_gets_a_hint():
    with pytest.raises(UnknownNameError, match=r"There is no robot 'sim-ebbo'. Did you mean 'sim-"):
        robots.find("sim-ebbo")


@pytest.mark.parametrize("name", ["coppeliasim", "cozmo", "ebo", "ev3", "rcis", "thymio"])
def test_the_papers_robots_are_listed(name):
    assert robots.find(name).load().name() == name


def test_the_module_of_a_robot_is_known():
    assert robots.module_of("thymio") == "learnblock.robots.thymio"
    assert robots.module_of("sim-thymio") == "learnblock.robots.sim_thymio"
    with pytest.raises(UnknownNameError):
        robots.module_of("thymmio")


def test_a_users_robot_is_a_file_in_the_home_folder(home):
    (home / "my_rover.py").write_text(ROBOT)
    (home / "_parts.py").write_text("1 / 0")
    entry = robots.find("my-rover")
    assert entry.path == home / "my_rover.py"
    with entry.load()(skills=[]) as robot:
        assert not robot.stopped
    assert "_parts" not in robots.entries()


def test_a_changed_file_is_reloaded(home):
    (home / "rover.py").write_text(ROBOT)
    first = robots.find("rover").load()
    (home / "rover.py").write_text(ROBOT + "    wheels = 4\n")
    assert not hasattr(first, "wheels")
    assert robots.find("rover").load().wheels == 4


def test_our_robots_come_first_if_two_share_a_name(home):
    (home / "sim_ebo.py").write_text(ROBOT)
    assert robots.entries()["sim-ebo"].path is None
    assert robots.find("sim-ebo").path is None


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("1 / 0", "The robot 'rover' can't be loaded (ZeroDivisionError: division by zero)."),
        ("class Robot: pass", "needs a class 'Robot' that inherits from 'Client'"),
        ("Robot = 3", "needs a class 'Robot' that inherits from 'Client'"),
        ("", "needs a class 'Robot' that inherits from 'Client'"),
        ("def (", "The robot 'rover' can't be loaded (SyntaxError: invalid syntax"),
    ],
)
def test_an_invalid_file_of_a_user_is_reported_by_name(home, text, message):
    (home / "rover.py").write_text(textwrap.dedent(text))
    with pytest.raises(LearnBlockError) as caught:
        robots.find("rover").load()
    assert message in str(caught.value)


def test_a_robot_that_failed_to_load_leaves_nothing_behind(home):
    import sys

    (home / "rover.py").write_text("1 / 0")
    with pytest.raises(LearnBlockError):
        robots.find("rover").load()
    assert "learnblock_home.robots.rover" not in sys.modules


def test_third_party_robots_come_from_entry_points(monkeypatch):
    point = EntryPoint("acme-rover", "acme.rover", "learnblock.robots")
    monkeypatch.setattr("importlib.metadata.entry_points", lambda: EntryPoints([point]))
    assert robots.find("acme-rover") == robots.RobotEntry("acme-rover", "acme.rover")
    with pytest.raises(LearnBlockError, match="The robot 'acme-rover' can't be loaded"):
        robots.find("acme-rover").load()
