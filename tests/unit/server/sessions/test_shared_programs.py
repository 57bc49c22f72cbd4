"""One program in several robots: one tab, one text, one undo, and a robot to look at."""

import json

import pytest

from learnblock.running import MOST_ROBOTS
from pages import WATCHING, english, serving

pytestmark = pytest.mark.realtime

DRIVING = "main:\n    function.move_straight(50)\n    function.sleep(1)\nend\n"
PRINTING = 'main:\n    print("hello")\nend\n'
ASKING = 'main:\n    print("name", input("who?"))\nend\n'
STOPPING = "main:\n    print(1)\n    print(2)\nend\n"


def swarm(page, text=DRIVING, count=3):
    """Open a project whose only program runs in several robots."""
    page.open(text=text)
    page.say("SetSpeed", factor=None)
    page.say("SetRobotCount", name="", count=count)
    page.hear("Tabs", open="program")


def names(tab):
    return [robot["name"] for robot in tab["robots"]]


def run(page):
    """Run all programs to their end; return all messages until then."""
    page.say("Run")
    return [*page.until("RunState", state="starting"), *end_all(page)]


def end_all(page):
    """Return all messages until the programs have ended."""
    found = page.until("Tabs")
    while page.last["Tabs"]["tabs"][0]["state"] != "ended":
        found += page.until("Tabs")
    return found


def saved(projects, name="program"):
    return json.loads((projects / f"{name}.learnblock").read_text("utf-8"))


def test_robots_that_share_a_program_are_one_tab_with_their_names(page):
    swarm(page)
    (tab,) = page.last["Tabs"]["tabs"]
    assert (tab["name"], names(tab)) == ("program", ["program-1", "program-2", "program-3"])
    assert page.last["Tabs"]["shows"] == "program-1"
    assert {name for name, _ in page.last["Scene"]["robots"]} == {*names(tab)}


def test_all_of_them_run_the_one_program(page):
    swarm(page)
    run(page)
    for name in ("program-1", "program-2", "program-3"):
        page.say("OpenTab", name="program", robot=name)
        ended = page.hear("Ended")
        assert (ended["ended"], round(ended["distance"], -1)) == ("finished", 50)


def test_the_program_is_edited_and_undone_once_for_all(page):
    swarm(page)
    page.type(PRINTING)
    page.say("Undo")
    assert page.hear("Document", blocktext=DRIVING)
    page.say("OpenTab", name="program", robot="program-3")
    assert page.hear("TabOpened")["shows"] == "program-3"
    assert page.hear("Document")["blocktext"] == DRIVING


def test_each_line_of_output_names_the_robot_that_printed_it(page):
    swarm(page, PRINTING)
    parts = [part for one in run(page) if one["kind"] == "PrintedByRobots" for part in one["parts"]]
    page.say("OpenTab", name="program", robot="program-2")
    assert page.hear("PrintedByRobots")["parts"]
    assert [part["robot"] for part in parts] == ["program-1", "program-2", "program-3"]
    assert {part["text"] for part in parts} == {"hello\n"}


def test_a_page_sees_the_run_of_the_robot_that_it_shows(page):
    swarm(page)
    page.say("OpenTab", name="program", robot="program-2")
    page.hear("Telemetry")
    assert page.last["Telemetry"]["robots"][0]["name"] == "program-2"
    assert page.last["Scene"]["robots"][0][0] == "program-2"


def test_a_question_goes_to_the_robot_that_is_shown(page):
    swarm(page, ASKING, count=2)
    page.say("Run")
    page.hear("InputWanted")
    page.say("Answer", text="Ada")
    assert page.hear("PrintedByRobots")["parts"][0] == {
        "robot": "program-1",
        "text": "name Ada\n",
        "until": 9,
    }
    page.say("OpenTab", name="program", robot="program-2")
    page.hear("InputWanted")
    page.say("Answer", text="Bob")
    page.hear("Ended", ended="finished")


def test_a_breakpoint_stops_one_robot_of_the_program_after_the_other(page):
    swarm(page, STOPPING, count=2)
    block = next(block for block, line, *_ in page.last["Document"]["places"] if line == 2)
    page.say("SetBreakpoints", blocks=[block])
    page.say("Run")
    for index in range(2):
        while page.hear("Tabs")["tabs"][0]["robots"][index]["state"] != "held":
            pass
        assert page.last["Tabs"]["tabs"][0]["state"] == "held"
        page.say("Resume")
    end_all(page)


def test_a_failure_of_one_robot_marks_the_tab(page):
    swarm(page, "main:\n    print(1 / 0)\nend\n", count=2)
    run(page)
    assert page.last["Tabs"]["tabs"][0]["failed"]


def test_the_file_has_the_program_once_with_the_number_of_its_robots(projects, page):
    swarm(page, count=10)
    page.type(PRINTING)
    page.hear("Saved", edit=2)
    file = saved(projects)
    assert (file["learnblock"], file["first"], file["count"]) == (4, "program", 10)
    assert "others" not in file


def test_the_robots_are_there_again_after_a_restart_of_the_server(projects, tmp_path):
    with serving(projects, static=tmp_path / "static") as server, server.visit() as page:
        swarm(page, count=4)
        page.type(PRINTING)
        page.hear("Saved", edit=2)
    with serving(projects, static=tmp_path / "static") as server, server.visit() as page:
        page.say("Open", name="program")
        assert len(page.hear("Tabs")["tabs"][0]["robots"]) == 4


def test_one_robot_that_is_left_has_no_tabs_again(page):
    swarm(page)
    page.say("OpenTab", name="program", robot="program-3")
    page.hear("TabOpened", shows="program-3")
    page.say("SetRobotCount", name="program", count=1)
    assert page.hear("TabOpened")["tab"] == ""
    assert "tabs" not in page.hear("Tabs")
    assert [name for name, _ in page.last["Scene"]["robots"]] == ["robot"]


def test_a_new_program_may_have_several_robots_from_the_start(page):
    page.open(text=DRIVING)
    page.say("AddTab", robot="sim-thymio", count=5)
    opened = page.hear("TabOpened")
    assert (opened["tab"], opened["shows"]) == ("sim-thymio", "sim-thymio-1")
    assert [len(tab.get("robots", "1")) for tab in page.last["Tabs"]["tabs"]] == [1, 5]


def test_robots_that_are_added_have_the_speed_of_the_others(page):
    swarm(page, count=2)
    page.say("OpenTab", name="program", robot="program-2")
    assert page.hear("RunState")["speed"] is None
    page.say("AddTab", robot="sim-thymio")
    page.hear("TabOpened")
    assert page.hear("RunState")["speed"] is None


def test_the_number_of_all_robots_together_is_limited(page):
    swarm(page, count=MOST_ROBOTS - 1)
    page.say("AddTab", robot="sim-thymio", count=2)
    assert str(MOST_ROBOTS) in english(page.hear("Failed")["message"])
    page.say("SetRobotCount", name="program", count=MOST_ROBOTS)
    assert len(page.hear("Tabs")["tabs"][0]["robots"]) == MOST_ROBOTS


def test_several_real_robots_of_a_kind_are_refused(page):
    swarm(page)
    page.say("ChooseRobot", name="cozmo")
    assert "real robot" in english(page.hear("Failed")["message"])
    page.say("AddTab", robot="ev3", count=2)
    assert "real robot" in english(page.hear("Failed")["message"])


def test_robots_are_renamed_together(page):
    swarm(page, count=2)
    page.say("RenameTab", name="program", new="ant")
    page.hear("Scene")
    assert names(page.hear("Tabs", open="ant")["tabs"][0]) == ["ant-1", "ant-2"]


@pytest.mark.certain
def test_a_closed_tab_comes_back_with_all_its_robots(page):
    swarm(page, count=2)
    page.say("AddTab", robot="sim-thymio", count=3)
    page.hear("TabOpened", tab="sim-thymio")
    page.say("CloseTab", name="sim-thymio")
    assert page.hear("TabOpened")["tab"] == "program"
    page.say("ReopenTab")
    page.hear("TabOpened", tab="sim-thymio")
    assert [len(names(tab)) for tab in page.last["Tabs"]["tabs"]] == [2, 3]


def test_an_earlier_version_brings_the_number_of_robots_back(page):
    swarm(page, PRINTING, count=3)
    run(page)
    page.say("SetRobotCount", name="program", count=2)
    page.hear("Tabs", open="program")
    page.say("ListHistory")
    version = page.hear("History")["versions"][0]["id"]
    page.say("Restore", version=version)
    while len(page.hear("Tabs")["tabs"][0]["robots"]) != 3:
        pass


@pytest.mark.parametrize("periods", [WATCHING])
def test_what_another_program_changes_of_the_number_is_taken_in(projects, page):
    swarm(page, count=2)
    page.type(PRINTING)
    page.hear("Saved", edit=2)
    file = saved(projects) | {"count": 5}
    (projects / "program.learnblock").write_text(json.dumps(file), "utf-8")
    while len(page.hear("Tabs")["tabs"][0]["robots"]) != 5:
        pass


def test_the_swarm_example_is_one_program_in_ten_robots(page):
    page.say("OpenExample", name="swarm", example="swarm")
    (tab,) = page.hear("Tabs")["tabs"]
    assert (tab["name"], len(tab["robots"])) == ("swarm", 10)
