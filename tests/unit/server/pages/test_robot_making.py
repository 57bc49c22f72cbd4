"""Messages between page and server about robots created on the page."""

import pytest

from learnblock.new.template import read

DESCRIPTION = read("robot/description.toml")


@pytest.fixture(autouse=True)
def own_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    (tmp_path / "home").mkdir()
    return tmp_path / "home"


def test_every_page_is_notified_of_a_new_robot_whose_twin_can_be_chosen(server, page, own_home):
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


def test_a_page_receives_a_template_of_a_description(page):
    page.open()
    page.say("BeginRobot")
    assert page.hear("RobotBegun")["description"] == DESCRIPTION


def test_a_mistake_in_a_description_is_reported_with_its_line(page, own_home):
    page.open()
    wrong = DESCRIPTION.replace("radius = 33", "radius = -1")
    page.say("MakeRobot", name="rover", description=wrong)
    (problem,) = page.hear("RobotMade")["problems"]
    assert "radius = -1" in wrong.splitlines()[problem["line"] - 1]
    assert list(own_home.rglob("*.py")) == []


@pytest.mark.parametrize(
    ("name", "code"),
    [
        ("../away", "new-bad-robot-name"),
        ("", "new-bad-robot-name"),
        ("sim-ebo", "new-twin-name"),
        ("cozmo", "new-robot-exists"),
    ],
)
def test_an_invalid_name_is_refused(name, code, page, own_home):
    page.open()
    page.say("MakeRobot", name=name, description=DESCRIPTION)
    assert page.hear("Failed")["message"]["code"] == code
    assert list(own_home.rglob("*.py")) == []


def test_a_robot_of_the_user_is_not_overwritten(page, own_home):
    page.open()
    page.say("MakeRobot", name="rover", description=DESCRIPTION)
    page.hear("RobotMade")
    client = own_home / "robots" / "rover.py"
    client.write_text("mine = True\n")
    page.say("MakeRobot", name="rover", description=DESCRIPTION)
    assert page.hear("Failed")["message"]["code"] == "new-robot-exists"
    assert client.read_text() == "mine = True\n"
