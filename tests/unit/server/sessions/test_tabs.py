"""Several robots in a project: each with its program, in one world, with one start."""

import json

import pytest

from learnblock.running import MOST_ROBOTS
from pages import WATCHING, english, serving

pytestmark = pytest.mark.realtime

DRIVING = "main:\n    function.move_straight(50)\n    function.sleep(1)\nend\n"
CALLING = 'main:\n    function.sleep(0.1)\n    function.send("go", 7)\nend\n'
WAITING = """\
main:
    while not function.received("go"):
        function.sleep(0.05)
    end
    print("got", function.message_value("go"))
end
"""
FAILING = "main:\n    print(1 / 0)\nend\n"
ASKING = 'main:\n    print("name", input("who?"))\nend\n'


def add(page, text, robot="sim-thymio"):
    """Add a robot with a program; return the name of its tab."""
    page.say("AddTab", robot=robot)
    tab = page.hear("TabOpened")["tab"]
    page.hear("Document")
    page._edits = 0
    page.type(text)
    return tab


def show(page, name):
    page.say("OpenTab", name=name)
    page.hear("TabOpened", tab=name)
    page._edits = 0
    return page.hear("Document")


def duo(page, first, second):
    """Open a project with two robots; return the name of the second, which is shown."""
    page.open(text=first)
    page.say("SetSpeed", factor=None)
    return add(page, second)


def run_all(page):
    """Run all programs; return how the run ended."""
    page.say("Run")
    page.hear("RunState", state="starting")
    end_all(page)
    return page.last["Ended"]


def end_all(page):
    """Wait until all programs have ended."""
    while any(tab["state"] != "ended" for tab in page.hear("Tabs")["tabs"]):
        pass


def history(page):
    page.say("ListHistory")
    return page.hear("History")


def saved(projects, name="program"):
    return json.loads((projects / f"{name}.learnblock").read_text("utf-8"))


def test_a_project_with_one_robot_has_no_tabs(page):
    assert "tab" not in page.open()
    assert page.last["Tabs"] == {"kind": "Tabs"}


def test_an_added_robot_has_an_empty_program_in_the_same_world(page):
    page.open(text=DRIVING)
    page.say("AddTab", robot="sim-thymio")
    opened = page.hear("TabOpened")
    assert (opened["tab"], opened["robot"]) == ("sim-thymio", "sim-thymio")
    assert page.hear("Document")["blocktext"] == "main:\n    pass\nend\n"
    assert [name for name, _ in page.hear("Scene")["robots"]] == ["sim-thymio", "program"]


def test_each_robot_keeps_its_program_and_its_undo(page):
    duo(page, DRIVING, WAITING)
    assert show(page, "program")["blocktext"] == DRIVING
    page.say("Undo")
    assert page.hear("Document")["blocktext"] != DRIVING
    assert show(page, "sim-thymio")["blocktext"] == WAITING


def test_a_choice_of_robot_holds_for_one_tab(page):
    duo(page, DRIVING, WAITING)
    page.say("ChooseRobot", name="sim-ev3")
    page.hear("Settings", robot="sim-ev3")
    show(page, "program")
    assert page.last["TabOpened"]["robot"] == "sim-ebo"


def test_one_start_runs_all_programs_in_one_world(page):
    duo(page, DRIVING, DRIVING)
    assert run_all(page)["ended"] == "finished"
    robots = {one["name"]: one["x"] for one in page.last["Telemetry"]["robots"]}
    assert robots.keys() == {"program", "sim-thymio"}


@pytest.mark.certain
def test_the_same_programs_leave_the_same_trace(page):
    duo(page, DRIVING, WAITING.replace("not function", "False and function"))
    first = run_all(page)["trace_sha256"]
    assert len(first) == 64
    assert run_all(page)["trace_sha256"] == first


def test_each_tab_looks_back_at_its_own_program_in_the_world_of_all(page):
    second = duo(page, DRIVING, CALLING)
    run_all(page)
    page.say("LookBack", time=0.5)
    past = page.hear("Past")
    assert {robot["name"] for robot in past["telemetry"]["robots"]} == {"program", second}
    show(page, "program")
    page.say("ReadTimeline")
    timeline = page.hear("Timeline")
    assert (timeline.get("exact", True), timeline["end"]) == (True, 1.0)
    page.say("LookBack", time=0.5)
    other = page.hear("Past")
    robots = {robot["name"]: robot for robot in other["telemetry"]["robots"]}
    assert robots == {robot["name"]: robot for robot in past["telemetry"]["robots"]}
    assert other["telemetry"]["robots"][0]["name"] == "program"
    assert robots["program"]["x"] != 0
    page.say("ReadCalls")
    assert "move_straight" in {one["name"] for one in page.hear("CallGraph")["functions"]}


def test_the_robots_send_messages_to_each_other(page):
    duo(page, CALLING, WAITING)
    page.say("Run")
    told = page.until("Ended")
    assert "".join(one["text"] for one in told if one["kind"] == "Printed") == "got 7\n"


LISTENING = """\
main:
    wait until function.is_key_pressed("{key}")
    print("{key} pressed")
    wait until function.is_key_pressed("space")
end
"""


def test_the_programs_of_all_tabs_find_the_keys_that_a_page_holds_down(page):
    page.open(text=LISTENING.format(key="up"))
    add(page, LISTENING.format(key="w"))
    page.say("Run")
    page.hear("KeysWanted", keys=["up", "space", "w"], programs=2)
    page.say("HoldKeys", keys=["w"])
    assert page.hear("Printed")["text"] == "w pressed\n"
    show(page, "program")
    assert page.hear("KeysWanted")["keys"] == ["up", "space", "w"]
    page.say("HoldKeys", keys=["up"])
    assert page.hear("Printed")["text"] == "up pressed\n"
    page.say("HoldKeys", keys=["space"])
    assert page.hear("KeysWanted", keys=[])["programs"] == 0
    end_all(page)


def test_a_page_that_shows_another_tab_releases_its_keys(page):
    released = LISTENING.format(key="w").replace(
        'until function.is_key_pressed("space")', 'until not function.is_key_pressed("w")'
    )
    page.open(text=released)
    add(page, CALLING)
    page.say("Run")
    page.hear("KeysWanted", keys=["w"])
    show(page, "program")
    page.say("HoldKeys", keys=["w"])
    page.hear("Printed")
    show(page, "sim-thymio")
    end_all(page)
    show(page, "program")
    assert page.last["Ended"]["ended"] == "finished"


def test_a_program_that_fails_leaves_the_others_running(page):
    page.open(text=FAILING)
    page.say("SetSpeed", factor=1)
    add(page, DRIVING)
    page.say("Run")
    heard = page.until("RunState", state="ended")
    tabs = [one["tabs"] for one in heard if one["kind"] == "Tabs"]
    states = [(one["state"], one.get("failed", False), two["state"]) for one, two in tabs]
    assert ("done", True, "running") in states
    assert "failed" not in tabs[-1][1]


def test_a_program_that_is_done_reports_its_end_before_that_of_the_run(page):
    page.open(text=DRIVING)
    page.say("SetSpeed", factor=1)
    add(page, "main:\n    pass\nend\n")
    page.say("Run")
    assert page.hear("Ended")["others"]
    assert page.hear("RunState")["state"] == "done"
    final = page.hear("Ended")
    assert "others" not in final
    assert len(final["trace_sha256"]) == 64


def test_stop_stops_all_programs(page):
    forever = "main:\n    while True:\n        function.sleep(0.1)\n    end\nend\n"
    page.open(text=forever)
    add(page, forever)
    page.say("Run")
    page.hear("RunState", state="running")
    page.say("Stop")
    end_all(page)


def test_pause_pauses_all_programs_and_resume_ends_it(page):
    forever = "main:\n    while True:\n        function.sleep(0.1)\n    end\nend\n"
    page.open(text=forever)
    add(page, forever)
    page.say("Run")
    page.hear("RunState", state="running")
    page.say("Pause")
    page.hear("RunState", state="paused")
    page.say("Resume")
    page.hear("RunState", state="running")
    page.say("Stop")
    page.hear("RunState", state="ended")


def test_a_step_goes_to_the_next_line_of_the_robot_that_is_shown(page):
    page.open(text=DRIVING)
    add(page, "main:\n    while True:\n        function.sleep(0.1)\n    end\nend\n")
    move, sleep = (place[0] for place in show(page, "program")["places"][-2:])
    page.say("Run", paused=True)
    held = []
    while sleep not in held:
        held.append(page.hear("RunState", state="held").get("block"))
        page.say("Step")
    assert held[held.index(move) :] == [move, sleep]
    page.say("Stop")
    end_all(page)


def test_a_question_is_asked_and_answered_on_its_own_tab(page):
    name = duo(page, DRIVING, ASKING)
    page.say("Run")
    page.hear("InputWanted", prompt="who?")
    page.say("Answer", text="Ada")
    assert page.hear("Printed")["text"] == "name Ada\n"
    assert name == page.last["Tabs"]["open"]
    page.hear("RunState", state="ended")


def test_an_error_in_any_program_keeps_all_from_running(page):
    duo(page, "main:\n    function.move_straight(\nend\n", DRIVING)
    page.say("Run")
    assert "'program'" in english(page.hear("Failed")["message"])


@pytest.mark.certain
def test_all_robots_are_saved_and_opened_again(projects, page):
    duo(page, DRIVING, WAITING)
    page.hear("Saved", edit=1)
    file = saved(projects)
    assert (file["learnblock"], file["first"]) == (3, "program")
    assert [one["name"] for one in file["others"]] == ["sim-thymio"]
    page.say("Open", name="program", tab="sim-thymio")
    assert page.hear("Opened")["tab"] == "sim-thymio"
    assert page.hear("Document")["blocktext"] == WAITING


@pytest.mark.certain
def test_a_project_survives_the_server_with_all_robots(projects, tmp_path):
    with serving(projects, static=tmp_path / "static") as server, server.visit() as page:
        duo(page, DRIVING, WAITING)
        page.hear("Saved", edit=1)
    with serving(projects, static=tmp_path / "static") as server, server.visit() as page:
        page.say("Open", name="program")
        assert page.hear("Document")["blocktext"] == DRIVING
        assert show(page, "sim-thymio")["blocktext"] == WAITING


@pytest.mark.certain
def test_a_closed_robot_can_be_reopened_with_its_program(page):
    name = duo(page, DRIVING, WAITING)
    page.say("CloseTab", name=name)
    assert page.hear("TabOpened")["tab"] == ""
    assert page.hear("Document")["blocktext"] == DRIVING
    page.say("ReopenTab")
    assert page.hear("TabOpened")["tab"] == name
    assert page.hear("Document")["blocktext"] == WAITING


def test_a_robot_that_another_page_shows_can_be_closed(server, page):
    name = duo(page, DRIVING, WAITING)
    with server.visit() as other:
        other.say("Open", name="program", tab=name)
        other.hear("Document", blocktext=WAITING)
        page.say("CloseTab", name=name)
        other.hear("TabOpened", tab="")
        assert other.hear("Document")["blocktext"] == DRIVING


@pytest.mark.certain
def test_an_edit_of_a_robot_that_another_page_has_just_closed_changes_no_other(server, page):
    name = duo(page, DRIVING, WAITING)
    with server.visit() as other:
        other.say("Open", name="program", tab=name)
        shown = other.hear("Document", blocktext=WAITING)
        page.say("CloseTab", name=name)
        page.hear("TabOpened")
        other.say("EditText", edit=1, notation="blocktext", text=ASKING, revision=shown["revision"])
        other.hear("TabOpened", tab="")
        other.pulse()
        assert other.last["Document"]["blocktext"] == DRIVING
        assert other.type(FAILING)["revision"] > 0


def test_a_robot_is_renamed_in_the_world_too(page):
    name = duo(page, DRIVING, WAITING)
    page.say("RenameTab", name=name, new="keeper")
    page.hear("Scene")
    assert page.hear("Tabs")["open"] == "keeper"
    assert [one for one, _ in page.last["Scene"]["robots"]] == ["keeper", "program"]


@pytest.mark.parametrize("new", ["program", "a/b", " ", "x" * 41, "\n"])
def test_a_name_that_no_robot_can_have_is_refused(page, new):
    name = duo(page, DRIVING, WAITING)
    page.say("RenameTab", name=name, new=new)
    assert english(page.hear("Failed")["message"])


def test_the_last_robot_cannot_be_closed(page):
    page.open()
    page.say("CloseTab", name="program")
    assert "at least one robot" in english(page.hear("Failed")["message"])


def test_no_robot_is_added_while_programs_run(page):
    page.open(text=DRIVING)
    page.say("Run")
    page.hear("RunState", state="running")
    page.say("AddTab", robot="sim-ebo")
    assert "running" in english(page.hear("Failed")["message"])


def test_the_number_of_robots_is_limited(page):
    page.open(world="empty")
    for _ in range(MOST_ROBOTS - 1):
        page.say("AddTab", robot="sim-thymio")
        page.hear("TabOpened")
    page.say("AddTab", robot="sim-thymio")
    assert str(MOST_ROBOTS) in english(page.hear("Failed")["message"])


def test_a_robot_that_finds_no_room_is_not_added(page):
    page.open()
    page.say("ChooseWorld", name="tags")
    page.hear("Settings", world="tags")
    page.say("AddTab", robot="nothing")
    assert english(page.hear("Failed")["message"])
    assert page.pulse()
    assert "tabs" not in page.last["Tabs"]


def test_two_pages_edit_different_robots_of_a_project(server, page):
    name = duo(page, DRIVING, WAITING)
    with server.visit() as other:
        other.say("Open", name="program")
        other.hear("Document", blocktext=DRIVING)
        other.type(CALLING)
        page.type(FAILING)
        assert show(page, "program")["blocktext"] == CALLING
        assert show(other, name)["blocktext"] == FAILING


def replace_whole(file, text):
    """Change a file as another program, so that no half of it is ever read."""
    part = file.parent.parent / "part"
    part.write_text(text, "utf-8")
    part.replace(file)


@pytest.mark.parametrize("periods", [WATCHING])
def test_what_another_program_changes_is_taken_in_for_each_robot(projects, page):
    name = duo(page, DRIVING, WAITING)
    page.hear("Saved", edit=1)
    file = saved(projects)
    changed = WAITING.replace("got", "taken")
    file["others"][0]["blocktext"] = changed.split("\n")
    file["others"].append({"name": "third", "robot": "sim-ebo", "blocktext": DRIVING.split("\n")})
    replace_whole(projects / "program.learnblock", json.dumps(file))
    page.hear("Document", blocktext=changed)
    page.hear("TakenIn")
    page.hear("Saved")
    assert [tab["name"] for tab in page.last["Tabs"]["tabs"]] == ["program", name, "third"]
    file["others"] = []
    replace_whole(projects / "program.learnblock", json.dumps(file))
    assert page.hear("TabOpened")["tab"] in ("", "program")
    page.hear("TakenIn")
    assert "tabs" not in page.last["Tabs"]


@pytest.mark.certain
def test_an_earlier_version_brings_a_closed_robot_back(page):
    name = duo(page, CALLING, WAITING)
    run_all(page)
    page.say("CloseTab", name=name)
    page.hear("TabOpened")
    version = history(page)["versions"][0]
    page.say("Restore", version=version["id"])
    page.until("Tabs")
    assert show(page, name)["blocktext"] == WAITING


def test_a_run_of_several_robots_is_one_entry_of_the_history(page):
    duo(page, DRIVING, DRIVING)
    ended = run_all(page)
    while not (runs := history(page)["runs"]):
        pass
    (run,) = runs
    assert run["robot"] == "sim-ebo, sim-thymio"
    assert run["trace_sha256"] == ended["trace_sha256"]


def test_the_program_that_is_shown_is_downloaded(page):
    duo(page, DRIVING, WAITING)
    page.say("Export", format="bt")
    file = page.hear("File")
    assert (file["filename"], file["text"]) == ("sim-thymio.bt", WAITING)
