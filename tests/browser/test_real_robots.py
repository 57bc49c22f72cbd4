"""Real robots on the page, connected to their emulators, show as much as their twins."""

import json
import math
import re

import pytest
from playwright.sync_api import expect

from emulated import settle
from learnblock.emulators import emulate
from learnblock.simulator import load_world

DRIVING = "main:\n    function.move_straight(30)\n    function.sleep({})\nend\n"
#: The text in the header of the world while a robot is connected.
CONNECTED = {"cozmo": "Connected, battery 4.0 V", "ev3": "Connected, battery 7.8 V"}
SENSORS = {
    "cozmo": ["Ground central", "Gyroscope", "Accelerometer forward"],
    "ev3": ["Distance front 1", "Ground central", "Gyroscope", "Bumper"],
    "ebo": ["Distance front 1", "Distance left 1", "Distance right 2"],
}

#: The description of the world for screen readers.
IN_WORDS = {
    "cozmo": "Cozmo at .* east",
    "ev3": "EV3 at .* east",
    "ebo": "EBO on a plain floor. Its position is unknown",
    "thymio": "Thymio on a plain floor. Its position is unknown",
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

    def reach(name, world="tags"):
        emulations.append(emulate(name, world))
        # A busy machine may keep an emulator waiting for seconds.
        settle(name, {**emulations[-1].settings, "patience": 8.0})
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


def run(pupil, robot, seconds=2):
    """Choose a robot, and start a program that drives."""
    pupil.page.get_by_role("combobox", name="Robot").select_option(robot)
    pupil.write("blocktext", DRIVING.format(seconds))
    pupil.sees("blocktext", f"sleep({seconds})")
    pupil.heard.clear()
    pupil.press("Run")
    pupil.state("Running")


def readings(pupil):
    return [message["sensors"] for message in messages(pupil, "Telemetry") if "sensors" in message]


@pytest.mark.parametrize("name", ["cozmo", "ev3", "ebo"])
def test_as_many_readings_arrive_as_from_the_twin(pupil, reach, name):
    reach(name)
    run(pupil, f"sim-{name}")
    pupil.state("Ended")
    twins = len(readings(pupil))
    run(pupil, name)
    pupil.state("Ended")
    # Twenty per second for two seconds on an idle machine, as from the twin; on a busy one both get
    # fewer, but not in step.
    assert min(len(readings(pupil)), twins) >= 15
    # The robot's own readings, and not the same one repeatedly.
    assert len({json.dumps(one) for one in readings(pupil)}) >= 10
    assert messages(pupil, "Ended")[0]["ended"] == "finished"
    expect(pupil.page.locator(".world-pane .link")).to_have_text("Not connected")


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
    pupil.page.get_by_role("combobox", name="Robot").select_option(name)
    pupil.expect_robot("A plain floor with the robot")
    pupil.picture("chosen")
    scene = messages(pupil, "Scene")[-1]
    assert (scene["real"], scene["world"]["box"], scene["world"]["tag"]) == (True, [], [])
    assert scene["robots"][0][1]["name"] == name


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
    emulation = reach(name)
    run(pupil, name, seconds=60)
    head = pupil.page.locator(".world-pane .link")
    expect(head).to_contain_text("Connected")
    emulation.close()
    expect(head).to_have_text("Connection lost")
    pupil.state("Ended")
    expect(head).to_have_text("Connection lost")
    pupil.picture("lost")
