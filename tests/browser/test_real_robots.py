"""Real robots on the page, connected to their emulators, show as much as their twins."""

import json
import math
import re

import pytest
from playwright.sync_api import expect

from emulated import LONG, settle
from learnblock.emulators import emulate
from learnblock.emulators.vehicle import Vehicle
from learnblock.simulator import load_world
from waiting import wait_for

DRIVING = "main:\n    function.move_straight(30)\n    function.sleep({})\nend\n"
CURVES = """\
main:
    function.move_straight(120)
    function.sleep(2)
    function.set_move(80, 45)
    function.sleep(3)
    function.stop_bot()
end
"""
CALLING = """\
main:
    function.move_straight(50)
    while not function.received("here"):
        function.sleep(0.05)
    end
    function.send("go", 7)
end
"""
CALLED = """\
main:
    function.move_straight(50)
    while not function.received("go"):
        function.send("here")
        function.sleep(0.05)
    end
    function.stop_bot()
    print("got", function.message_value("go"))
end
"""
#: The text in the header of the world while a robot is connected.
CONNECTED = {"cozmo": "Connected, battery 4.0 V", "ev3": "Connected, battery 7.8 V"}
SENSORS = {
    "cozmo": ["Ground in the middle", "Gyroscope", "Accelerometer forward"],
    "ev3": ["Distance in front 1", "Ground in the middle", "Gyroscope", "Bumper"],
    "ebo": ["Distance in front 1", "Distance on the left 1", "Distance on the right 2"],
}
#: The names of robots and of their twins in the menu.
TITLES = {"cozmo": "Cozmo", "ev3": "LEGO EV3", "ebo": "EBO", "thymio": "Thymio II"}
#: The description of the world for screen readers.
IN_WORDS = {
    "cozmo": "Cozmo at .* east",
    "ev3": "EV3 at .* east",
    "ebo": "EBO at .* east",
    "thymio": "Thymio at .* east",
}


@pytest.fixture
def pupil(sit_down, own_server):
    pupil = sit_down(own_server, viewport={"width": 1600, "height": 900}, empty=True)
    pupil.heard = []

    def listen(socket):
        # Playwright sets an attribute on its listener, which a bound method of a list refuses.
        socket.on("framereceived", lambda frame: pupil.heard.append(frame))  # noqa: PLW0108

    pupil.page.on("websocket", listen)
    pupil.page.reload()
    # What is typed before the program comes is replaced by it.
    expect(pupil.blocks("lb_main")).to_be_visible()
    pupil.show("Blocks", "Block-Text")
    return pupil


@pytest.fixture
def reach(own_server, monkeypatch):
    """A function that emulates a robot and sets its address in the server's settings."""
    monkeypatch.setenv("LEARNBLOCK_HOME", str(own_server.home))
    emulations = []

    def reach(name, world="tags", patience=LONG):
        emulations.append(emulate(name, world))
        settle(name, {**emulations[-1].settings, "patience": patience})
        return emulations[-1]

    yield reach
    for emulation in emulations:
        emulation.close()


def messages(pupil, kind):
    """Return the messages of a kind that the page has received, in order."""
    texts = (frame for frame in pupil.heard if isinstance(frame, str))
    found = (json.loads(text) for text in texts)
    return [message for message in found if message["kind"] == kind]


def before_a_tag(distance):
    """Return the pose of a robot that faces the first tag of the world from a distance in mm."""
    tag = load_world("tags").tag[0]
    angle = math.radians(tag.heading)
    x, y = tag.x + distance * math.cos(angle), tag.y - distance * math.sin(angle)
    return x, y, (tag.heading + 360) % 360 - 180


def choose(pupil, robot):
    """Choose a robot by its name in the code."""
    pupil.menu("Robot").click()
    group = "Simulated" if robot.startswith("sim-") else "Real"
    robots = pupil.page.get_by_role("group", name=group)
    robots.get_by_role("menuitemradio", name=TITLES[robot.removeprefix("sim-")]).click()


def run(pupil, robot, seconds=2):
    """Choose a robot, and start a program that drives."""
    choose(pupil, robot)
    pupil.write("blocktext", DRIVING.format(seconds))
    pupil.sees("blocktext", f"sleep({seconds})")
    pupil.heard.clear()
    pupil.press("Run")
    pupil.state("Running")


def readings(pupil):
    return [message["sensors"] for message in messages(pupil, "Telemetry") if "sensors" in message]


@pytest.mark.parametrize("name", ["cozmo", "ev3", "ebo"])
def test_new_readings_keep_arriving_as_from_the_twin(pupil, reach, name):
    reach(name)
    for robot in (f"sim-{name}", name):
        run(pupil, robot, seconds=60)
        wait_for_readings(pupil)
        pupil.press("Stop")
        pupil.state("Ended")
        assert messages(pupil, "Ended")[0]["ended"] == "stopped"
    expect(pupil.page.locator(".world-pane .link")).to_have_text("Not connected")


def wait_for_readings(pupil):
    """Wait for fifteen readings, of which ten differ: not the same one repeatedly."""

    def have_come():
        # Playwright hands over messages only during its own calls.
        pupil.page.wait_for_timeout(20)
        found = readings(pupil)
        return len(found) >= 15 and len({json.dumps(one) for one in found}) >= 10

    wait_for(have_come, "readings")


@pytest.mark.parametrize("name", ["cozmo", "ev3", "ebo"])
def test_a_running_real_robot_is_shown_like_its_twin(pupil, reach, name):
    reach(name)
    run(pupil, name, seconds=60)
    head = pupil.page.locator(".world-pane .link")
    expect(head).to_have_text(CONNECTED.get(name, "Connected"))
    sensors = pupil.tab("Sensors")
    for sensor in SENSORS[name]:
        expect(sensors.get_by_role("checkbox", name=sensor)).to_be_visible()
    expect(sensors.locator(".plot canvas")).to_be_visible()
    expect(pupil.blocks("lb_skill_sleep")).to_have_class(re.compile("lbRunning"))
    pupil.expect_robot(IN_WORDS[name])
    pupil.picture("running")
    pupil.press("Stop")
    pupil.state("Ended")


@pytest.mark.parametrize("name", IN_WORDS)
def test_a_real_robot_takes_the_place_of_the_previous_twin(pupil, name):
    pupil.expect_robot("at 0 mm east")
    choose(pupil, name)
    pupil.expect_robot("A plain floor with the robot")
    pupil.picture("chosen")
    scene = messages(pupil, "Scene")[-1]
    assert (scene["real"], scene["world"]["box"], scene["world"]["tag"]) == (True, [], [])
    assert scene["robots"][0][1]["name"] == name


def test_a_run_of_a_real_and_a_simulated_robot_says_that_it_cannot_be_repeated(pupil, reach):
    reach("ev3", "empty")
    pupil.write("blocktext", CALLING)
    pupil.add_robot("Thymio II")
    choose(pupil, "ev3")
    pupil.write("blocktext", CALLED)
    pupil.page.get_by_role("tab", name="Console").click()
    pupil.press("Run")
    expect(pupil.page.locator(".console-lines")).to_contain_text("got 7")
    for tab in ("sim-thymio", "program"):
        tabs = pupil.page.get_by_role("tablist", name="Robots")
        tabs.get_by_role("tab", name=re.compile(f"^{tab}")).click()
        pupil.state("Ended")
        result = pupil.tab("Result")
        expect(result).to_contain_text("this run can't be repeated exactly")
        expect(result.locator(".hash")).to_have_count(0)
        expect(result).not_to_contain_text("did exactly the same")
    pupil.picture("result")
    pupil.project("History…")
    newest = pupil.dialog().locator("li", has_text="LEGO EV3").first
    expect(newest).to_contain_text("EBO")
    expect(newest).not_to_contain_text("Trace")
    pupil.picture("history")
    assert pupil.errors == []


def test_the_camera_of_a_real_robot_is_shown_with_the_tags_in_it(pupil, reach):
    with reach("cozmo").twin.body() as body:
        body.place(*before_a_tag(400))
    pupil.press("Robot camera")
    run(pupil, "cozmo", seconds=30)
    expect(pupil.page.locator(".found")).to_contain_text("Tag")
    pupil.picture("camera")
    pupil.press("Stop")
    pupil.state("Ended")


@pytest.mark.parametrize("name", ["cozmo", "ev3", "ebo"])
def test_the_page_reports_a_lost_connection(pupil, reach, name):
    emulation = reach(name, patience=8.0)
    run(pupil, name, seconds=60)
    head = pupil.page.locator(".world-pane .link")
    expect(head).to_contain_text("Connected")
    emulation.close()
    expect(head).to_have_text("Connection lost")
    pupil.state("Ended")
    expect(head).to_have_text("Connection lost")
    pupil.picture("lost")


def test_looking_back_shows_a_real_robot_and_where_its_twin_would_have_been(
    pupil, reach, monkeypatch
):
    turn = Vehicle.turn

    def slowly(vehicle, speeds):
        turn(vehicle, {port: 0.6 * speed for port, speed in speeds.items()})

    monkeypatch.setattr(Vehicle, "turn", slowly)
    reach("ev3", "empty")
    choose(pupil, "ev3")
    pupil.write("blocktext", CURVES)
    pupil.press("Run")
    pupil.state("Ended")
    moment = pupil.page.get_by_role("slider", name="Moment of the run")
    expect(moment).to_be_visible()
    findings = pupil.page.locator(".ghost-findings")
    # Only the past has a prediction.
    expect(findings).not_to_be_visible()
    moment.focus()
    moment.press("ArrowLeft")
    expect(findings).to_contain_text("Its wheels turned")
    expect(findings).to_contain_text("what was not recorded")
    expect(pupil.page.get_by_role("list", name="Ways of the robot and its twin")).to_be_visible()
    pupil.picture("ghost")
    findings.get_by_text("What it means").click()
    expect(findings.get_by_text("Its wheels turned")).to_be_visible()
    pupil.picture("meaning")
    findings.get_by_role("button", name="At ").click()
    expect(pupil.page.locator(".ghost-findings")).to_be_visible()
    pupil.picture("parted")
    pupil.page.get_by_role("button", name="Back to now").click()
    expect(findings).not_to_be_visible()
