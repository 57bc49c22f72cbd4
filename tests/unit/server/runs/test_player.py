"""Programs run from the page: the same as on the command line, controlled by the page."""

import json

import pytest
from click.testing import CliRunner

from cheats import FORGED
from learnblock.cli import main
from learnblock.server import catalog
from learnblock.server.runs.console import MOST_AT_ONCE
from pages import english, phrase
from places import ROOT

pytestmark = [pytest.mark.slow, pytest.mark.realtime]

EXAMPLES = ROOT / "examples"
SQUARE = (EXAMPLES / "square.bt").read_text("utf-8")
DRIVING = "main:\n    while True:\n        function.move_straight(50)\n    end\nend\n"
COUNTING = """\
count = 0

main:
    count = 1
    function.sleep(0.1)
    count = 2
    function.sleep(0.1)
    count = 3
end
"""


def run_on_the_command_line(text, tmp_path, *options, suffix=".bt"):
    """Return the hash of the trace."""
    file = tmp_path / f"program{suffix}"
    file.write_text(text, "utf-8")
    ran = CliRunner().invoke(main, ["run", str(file), "--json", *options])
    return json.loads(ran.stdout)["trace_sha256"]


def place(document, statement):
    """Return the block of a line of Block-Text."""
    return next(block for block, line, *_ in document["places"] if line == statement)


@pytest.mark.certain
@pytest.mark.sample(1)
@pytest.mark.parametrize("name", ["square", "dance", "polygons"])
def test_a_run_leaves_the_trace_of_the_command_line(page, tmp_path, name):
    example = catalog.example(name)
    page.say("New", name=name, example=name)
    text = page.hear("Document")["blocktext"]
    page.say("SetSpeed", factor=None)
    options = ["--robot", example.robot, "--world", example.world]
    assert page.run()["trace_sha256"] == run_on_the_command_line(text, tmp_path, *options)


def test_watching_the_camera_does_not_affect_the_run(page, tmp_path):
    text = "main:\n    repeat 5:\n        x = function.is_tag(1)\n        print(x)\n    end\nend\n"
    page.say("New", name="tags", example="tags")
    page.hear("Scene")
    page.type(text)
    page.say("WatchCamera", on=True)
    watched = page.run()["trace_sha256"]
    assert watched == run_on_the_command_line(text, tmp_path, "--world", "tags")


@pytest.mark.certain
def test_all_three_views_leave_the_same_trace(page, tmp_path):
    page.open()
    page.say("SetSpeed", factor=None)
    document = page.type(SQUARE)
    from_text = page.run()["trace_sha256"]
    page.type("main:\n    pass\nend\n")
    page.say("EditBlocks", edit=3, workspace=document["workspace"])
    page.hear("Document", edit=3)
    from_blocks = page.run()["trace_sha256"]
    python = document["python"]
    page.say("EditText", edit=4, notation="python", text="# by hand\n" + python)
    page.hear("Document", edit=4)
    from_python = page.run()["trace_sha256"]
    expected = run_on_the_command_line(python, tmp_path, "--world", "empty", suffix=".py")
    by_hand = run_on_the_command_line(
        "# by hand\n" + python, tmp_path, "--world", "empty", suffix=".py"
    )
    assert (from_text, from_blocks, from_python) == (expected, expected, by_hand)


@pytest.fixture(scope="module")
def counted(tmp_path_factory):
    """The hash of the trace that the program leaves on the command line."""
    return run_on_the_command_line(COUNTING, tmp_path_factory.mktemp("counting"))


@pytest.mark.parametrize("speed", [None, 100, 3])
def test_the_speed_does_not_affect_the_run(page, counted, speed):
    page.open(text=COUNTING)
    page.say("SetSpeed", factor=speed)
    assert page.run()["trace_sha256"] == counted


def test_stepping_does_not_affect_the_run(page, counted):
    page.open(text=COUNTING)
    page.say("Run", paused=True)
    while page.hear("RunState")["state"] != "ended":
        page.say("Step")
    page.run()
    page.say("ListHistory")
    hashes = {run["trace_sha256"] for run in page.hear("History")["runs"]}
    assert hashes == {counted}


def test_a_program_with_errors_is_not_run(page):
    page.open(text="main:\n    function.move_straight(\nend\n")
    page.say("Run")
    assert "line 2" in english(page.hear("Failed")["message"])


def test_a_program_whose_robot_lacks_a_device_is_not_run(page):
    page.open(text="main:\n    if function.is_line_crossed():\n        pass\n    end\nend\n")
    page.say("Run")
    assert english(page.hear("Failed")["message"])


def test_output_arrives_before_the_end(page):
    page.open(text='main:\n    print("one")\n    print("two")\nend\n')
    page.say("Run")
    printed = [one["text"] for one in page.until("Ended") if one["kind"] == "Printed"]
    assert "".join(printed) == "one\ntwo\n"


def test_too_much_output_is_cut(page):
    page.open()
    page.type("print('x' * 2_000_000)\n", "python")
    page.say("Run")
    printed = [one["text"] for one in page.until("Ended") if one["kind"] == "Printed"]
    # It may arrive in several portions, since it is sent while it is still being read.
    assert all(len(text) < MOST_AT_ONCE + 50 for text in printed)
    assert "characters left out" in "".join(printed)


def test_an_error_of_the_program_names_its_block(page):
    page.open()
    document = page.type("main:\n    print(1)\n    print(1 / 0)\nend\n")
    ended = page.run()
    assert ended["ended"] == "error"
    assert "ZeroDivisionError" in ended["message"]["values"]["error"]
    assert ended["block"] == place(document, 3)


def test_the_running_block_is_reported(page):
    page.open()
    document = page.type("main:\n    function.move_straight(50)\n    function.sleep(1)\nend\n")
    page.say("Run")
    page.hear("RunningLine", block=place(document, 3))


def test_telemetry_shows_the_robot_moving(page):
    page.open(text="main:\n    function.move_straight(50)\n    function.sleep(1)\nend\n")
    page.say("Run")
    told = [one for one in page.until("Ended") if one["kind"] == "Telemetry"]
    places = [one["robots"][0]["x"] for one in told]
    assert places[-1] > 30
    assert len(places) >= 8


def test_a_program_is_stopped_with_its_robot(page):
    page.open(text=DRIVING.replace("end\nend", "    function.sleep(0.1)\n    end\nend"))
    page.say("Run")
    page.hear("RunState", state="running")
    page.say("Stop")
    assert page.hear("Ended")["ended"] == "stopped"


def test_a_program_that_never_waits_is_ended(page):
    page.open(text="main:\n    while True:\n        pass\n    end\nend\n")
    page.say("Run")
    page.hear("RunState", state="running")
    page.say("Stop")
    page.hear("Ended")


def test_running_again_restarts_the_program(page):
    page.open(text='main:\n    print("once")\n    function.sleep(20)\nend\n')
    for _ in range(3):
        page.say("Run")
        page.hear("RunState", state="starting")
        page.hear("Printed", text="once\n")
    page.say("Stop")
    page.hear("Ended")


def test_a_paused_world_does_not_move_until_it_is_resumed(page):
    page.open(text="main:\n    function.move_straight(50)\n    function.sleep(1)\nend\n")
    page.say("Run")
    page.hear("Telemetry")
    page.say("Pause")
    page.hear("RunState", state="paused")
    page.say("Resume")
    page.hear("RunState", state="running")
    assert page.hear("Ended")["ended"] == "finished"


def test_a_program_is_paused_at_a_breakpoint_with_its_variables(page):
    page.open()
    document = page.type(COUNTING)
    block = place(document, 6)
    page.say("SetBreakpoints", blocks=[block])
    page.say("Run")
    assert page.hear("RunState", state="held")["block"] == block
    page.pulse()
    assert page.last["Variables"]["shared"] == {"count": "1"}
    page.say("Step")
    page.hear("RunState", state="held")
    page.pulse()
    assert page.last["Variables"]["shared"] == {"count": "2"}
    page.say("SetBreakpoints", blocks=[])
    page.say("Resume")
    assert page.hear("Ended")["ended"] == "finished"


def test_a_program_asks_and_is_answered(page):
    page.open(text='main:\n    name = input("Who? ")\n    print("Hello " + name)\nend\n')
    page.say("Run")
    assert page.hear("InputWanted")["prompt"] == "Who? "
    page.say("Answer", text="Ada")
    assert page.hear("Printed")["text"] == "Hello Ada\n"
    assert page.hear("Ended")["ended"] == "finished"


LISTENING = """main:
    while not function.is_key_pressed("space"):
        if function.is_key_pressed("up"):
            print("up")
        end
    end
end
"""


def test_a_program_finds_the_keys_that_its_users_hold_down(page):
    page.open(text=LISTENING)
    page.say("Run")
    assert page.hear("KeysWanted")["keys"] == ["up", "space"]
    page.say("HoldKeys", keys=["up"])
    page.hear("Printed")
    page.say("HoldKeys", keys=["space"])
    assert page.hear("KeysWanted")["keys"] == []
    assert page.hear("Ended")["ended"] == "finished"


def test_a_page_that_is_closed_releases_its_keys(server):
    with server.visit() as page:
        page.open(text=LISTENING.replace('"space"', '"enter"').replace('"up"', '"space"'))
        page.say("Run")
        page.hear("KeysWanted")
        with server.visit() as other:
            other.say("Open", name="program")
            assert other.hear("KeysWanted")["keys"] == ["space", "enter"]
            other.say("HoldKeys", keys=["space"])
            page.hear("Printed")
        page.say("HoldKeys", keys=["enter"])
        assert page.hear("Ended")["ended"] == "finished"


def test_a_robot_is_shaken_and_tilted_while_its_program_runs(page):
    text = """main:
    wait until function.is_tilted("left")
    print("tilted")
    wait until function.is_shaken()
end
"""
    page.open(text=text)
    page.say("ChooseRobot", name="sim-cozmo")
    page.hear("Scene")
    page.say("Run")
    # Only now is there a robot of the program in the world.
    page.hear("RunningLine", line=6)
    page.say("HandleRobot", how="left")
    page.hear("Printed")
    page.say("HandleRobot", how="shake")
    assert page.hear("Ended")["ended"] == "finished"


def test_an_unknown_key_is_refused(page):
    page.open(text=LISTENING)
    page.say("HoldKeys", keys=["escape"])
    assert page.hear("Failed")


def test_a_program_that_waits_for_an_answer_can_be_stopped(page):
    page.open(text='main:\n    name = input("Who? ")\nend\n')
    page.say("Run")
    page.hear("RunState", state="input")
    page.say("Stop")
    assert page.hear("Ended")["ended"] == "stopped"


def test_a_reloaded_page_finds_its_program_running(server):
    with server.visit() as page:
        page.open(text='main:\n    print("begun")\n    x = input("go on? ")\nend\n')
        page.say("Run")
        page.hear("RunState", state="input")
    with server.visit() as page:
        page.say("Open", name="program")
        assert page.hear("RunState")["state"] == "input"
        assert page.hear("Printed")["text"] == "begun\n"
        page.hear("InputWanted", prompt="go on? ")
        page.say("Answer", text="")
        assert page.hear("Ended")["ended"] == "finished"


def test_robot_and_world_cannot_be_changed_during_a_run(page):
    page.open(text='main:\n    x = input("")\nend\n')
    page.say("Run")
    page.hear("RunState", state="input")
    page.say("ChooseWorld", name="line")
    assert "Stop it first" in english(page.hear("Failed")["message"])
    page.say("Stop")
    page.hear("Ended")


#: A user's real robot; it writes its speeds to a file.
MINE = """
from pathlib import Path
from learnblock.client import Client, Rights
from learnblock.devices import Base, DistanceSensors

class Robot(Client):
    rights = Rights(folders=(str(Path(__file__).parent),))

    def connect(self):
        log = Path(__file__).with_suffix(".log").open("a")
        self.add(Base(lambda adv, rot: print(adv, rot, file=log, flush=True)))
        self.add(DistanceSensors(lambda: {"front": [100.0, 200.0]}))
        self.disconnect = log.close
"""
SECOND = {"device": "DistanceSensors", "key": "ROBOT", "place": "front", "number": 2}


def test_a_program_runs_on_a_real_robot(own_home, page):
    folder = own_home / "robots"
    folder.mkdir()
    (folder / "mine.py").write_text(MINE)
    page.open(text="main:\n    function.move_straight(50)\n    function.sleep(0.1)\nend\n")
    page.say("ChooseRobot", name="mine")
    assert page.run()["ended"] == "finished"
    assert (folder / "mine.log").read_text() == "50.0 0.0\n0.0 0.0\n"
    page.say("Drive", advance=1, rotation=0)
    assert "Only a simulated robot" in english(page.hear("Failed")["message"])
    page.say("ChooseRobot", name="sim-ebo")
    assert page.hear("Scene")["robots"]


def test_the_sensors_of_a_real_robot_are_reported_even_if_the_program_reads_none(own_home, page):
    (own_home / "robots").mkdir()
    (own_home / "robots" / "mine.py").write_text(MINE)
    page.open(text="main:\n    function.move_straight(50)\n    function.sleep(1)\nend\n")
    page.say("ChooseRobot", name="mine")
    scene = page.hear("Scene")
    assert (scene["real"], scene["name"], scene["robots"][0][1]["name"]) == (True, "", "robot")
    page.say("Run")
    heard = page.until("Ended")
    seen = [one for one in heard if one["kind"] == "Telemetry" and one.get("sensors")]
    (second,) = (one for one in seen[-1]["sensors"] if SECOND.items() <= one.items())
    assert second["value"] == 200
    assert seen[-1]["robots"][0]["speed"] == [50.0, 0.0]
    robot = seen[-1]["robots"][0]
    assert robot.get("located", True)
    assert 0 < robot["x"] <= 60
    links = [one["state"] for one in heard if one["kind"] == "RobotLink"]
    assert "connected" in links


# Moving the robot by hand.


def test_a_run_starts_where_the_robot_was_placed(page):
    page.open(text="main:\n    function.sleep(0.2)\nend\n")
    page.say("PlaceRobot", x=200, y=-100, heading=90)
    robot = page.hear("Telemetry", time=0.0)["robots"][0]
    page.run()
    while (robot["x"], robot["y"], robot["heading"]) != (200, -100, 90):
        robot = page.hear("Telemetry")["robots"][0]
    page.say("Run")
    told = [one["robots"][0] for one in page.until("Ended") if one["kind"] == "Telemetry"]
    assert {(one["x"], one["y"], one["heading"]) for one in told} == {(200, -100, 90)}


def test_a_moving_robot_cannot_be_placed(page):
    page.open(text=DRIVING.replace("end\nend", "    function.sleep(0.1)\n    end\nend"))
    page.say("Run")
    page.hear("RunState", state="running")
    page.say("PlaceRobot", x=0, y=0, heading=0)
    assert "Pause or stop" in english(page.hear("Failed")["message"])
    page.say("Stop")
    page.hear("Ended")


def test_the_robot_is_driven_by_hand_and_the_world_reset(page):
    page.open()
    page.say("Drive", advance=1, rotation=0)
    while page.hear("Telemetry")["robots"][0]["x"] < 5:
        # As long as the key is held: the robot stops by itself half a second later.
        page.say("Drive", advance=1, rotation=0)
    page.say("ResetWorld")
    while page.hear("Telemetry")["robots"][0]["x"] != 0:
        pass


def test_driving_by_hand_is_refused_while_a_program_runs(page):
    page.open(text='main:\n    x = input("")\nend\n')
    page.say("Run")
    page.hear("RunState", state="input")
    page.say("Drive", advance=1, rotation=0)
    assert "Stop it first" in english(page.hear("Failed")["message"])
    page.say("Stop")
    page.hear("Ended")


def test_camera_frames_go_to_pages_that_watch(page):
    page.say("New", name="tags", example="tags")
    page.hear("Scene")
    page.say("WatchCamera", on=True)
    frame = page.hear("CameraFrame")
    assert (frame["width"], frame["height"]) == (320, 240)
    assert page.hear("bytes")["data"].startswith(b"\xff\xd8")


def test_a_robot_without_a_camera_sends_no_frames(page):
    page.open()
    page.say("ChooseRobot", name="sim-thymio")
    page.hear("Settings")
    page.say("WatchCamera", on=True)
    page.run()
    assert page.heard["CameraFrame"] == 0


def test_sounds_are_sent_to_the_page(page):
    page.open(text='main:\n    function.say_Text("hello")\nend\n')
    page.say("ChooseRobot", name="sim-cozmo")
    page.hear("Settings")
    page.say("Run")
    assert page.hear("Sound")["device"] == "Speaker"


# Worlds.


def world(page, name="obstacles"):
    page.say("ReadWorld", name=name)
    return page.hear("WorldToEdit")["world"]


def test_a_world_is_edited_and_saved_under_a_new_name(page):
    page.open()
    edited = {**world(page), "title": "My world"}
    page.say("CheckWorld", world=edited)
    assert page.hear("WorldChecked")["problems"] == []
    page.say("SaveWorld", name="mine", world=edited)
    choices = page.hear("Worlds")["worlds"]
    [mine] = [each for each in choices if each["name"] == "mine"]
    assert (mine["title"], mine["own"]) == ("My world", True)
    assert page.hear("Scene")["name"] == "mine"
    assert page.hear("Settings")["world"] == "mine"


@pytest.mark.certain
def test_a_saved_world_is_not_replaced_by_accident(page):
    page.open()
    edited = world(page)
    page.say("SaveWorld", name="mine", world={**edited, "title": "The first"})
    page.hear("Worlds")
    page.say("SaveWorld", name="mine", world={**edited, "title": "The second"})
    assert "You already have a world 'mine'" in english(page.hear("Failed")["message"])
    page.say("SaveWorld", name="mine", world={**edited, "title": "The third"}, replace=True)
    choices = page.hear("Worlds")["worlds"]
    assert [one["title"] for one in choices if one["name"] == "mine"] == ["The third"]


@pytest.mark.parametrize("kind", ["CheckWorld", "SaveWorld"])
def test_the_mistakes_of_an_invalid_world_are_reported(page, kind):
    page.open()
    wrong = {**world(page), "title": 3}
    page.say(kind, world=wrong, **({"name": "mine"} if kind == "SaveWorld" else {}))
    assert "title" in english(page.hear("WorldChecked")["problems"][0])


def test_a_bump_is_reported_while_the_program_goes_on(page):
    # At its fastest a short program may be over before anything is reported.
    page.open(text="main:\n    function.move_straight(400)\n    function.sleep(3600)\nend\n")
    page.say("ChooseWorld", name="walls")
    page.say("SetSpeed", factor=None)
    page.say("Run")
    bump = page.hear("Bumped")
    assert phrase(bump["thing"]).code == "why-name"
    page.say("Stop")
    assert bump["time"] < page.hear("Ended")["time"]
    page.say("Run")
    assert page.hear("Bumped") == bump


@pytest.mark.parametrize(
    "fault",
    ["m.Phrase('x'), (1,), '/dev/ptmx', 2", "m.Phrase('run-too-much-output'), (1,), '', 0"],
)
def test_a_forged_message_is_an_error_of_the_program_and_it_can_be_run_again(page, fault):
    page.open()
    head = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n"
    python = f"{head}{FORGED.format(fault)}\n"
    page.say("EditText", edit=1, notation="python", text=python)
    page.hear("Document", edit=1)
    for _ in range(2):
        ended = page.run()
        assert "makes no sense" in english(ended["message"])
