"""What a page hears and does about robots that it has made."""

import pytest

from learnblock.new.template import read

DESCRIPTION = read("robot/description.toml")


@pytest.fixture(autouse=True)
def own_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    (tmp_path / "home").mkdir()
    return tmp_path / "home"


def test_every_page_hears_of_a_new_robot_whose_twin_can_be_chosen(server, page, own_home):
    page.open()
    with server.visit() as other:
        other.open("other")
        page.say("MakeRobot", name="pathfinder", description=DESCRIPTION)
        for one in (page, other):
            found = {each["name"]: each["simulated"] for each in one.hear("Robots")["robots"]}
            assert (found["pathfinder"], found["sim-pathfinder"]) == (False, True)
    assert len(page.hear("RobotMade")["files"]) == 4
    page.say("ChooseRobot", name="sim-pathfinder")
    assert page.run()["ended"] == "finished"
    assert (own_home / "robots" / "pathfinder.py").is_file()


def test_a_page_gets_a_description_to_begin_with(page):
    page.open()
    page.say("BeginRobot")
    assert page.hear("RobotBegun")["description"] == DESCRIPTION


def test_what_is_wrong_with_a_description_is_told_with_its_line(page, own_home):
    page.open()
    wrong = DESCRIPTION.replace("radius = 33", "radius = -1")
    page.say("MakeRobot", name="rover", description=wrong)
    (problem,) = page.hear("RobotMade")["problems"]
    assert "radius = -1" in wrong.splitlines()[problem["line"] - 1]
    assert list(own_home.rglob("*.py")) == []


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("../away", "cannot be called"),
        ("", "cannot be called"),
        ("sim-ebo", "is the name of a twin"),
        ("cozmo", "there is a robot `cozmo` already"),
    ],
)
def test_a_name_that_cannot_be_is_refused(name, told, page, own_home):
    page.open()
    page.say("MakeRobot", name=name, description=DESCRIPTION)
    assert told in page.hear("Failed")["message"]
    assert list(own_home.rglob("*.py")) == []


def test_a_robot_of_ones_own_is_not_written_over(page, own_home):
    page.open()
    page.say("MakeRobot", name="rover", description=DESCRIPTION)
    page.hear("RobotMade")
    client = own_home / "robots" / "rover.py"
    client.write_text("mine = True\n")
    page.say("MakeRobot", name="rover", description=DESCRIPTION)
    assert "there is a robot `rover` already" in page.hear("Failed")["message"]
    assert client.read_text() == "mine = True\n"
