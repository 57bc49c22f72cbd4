"""Real robots are found, connected, tried and measured on the page, through their emulators."""

import math
import re
import shutil
import tomllib

import pytest
from playwright.sync_api import expect

from browser.test_accessibility import THEMES, choose_theme, faults
from emulated import settle
from learnblock.emulators import emulate
from learnblock.robots import find
from waiting import wait_for

#: The robots, what the page calls them, and what they can be tried with.
ROBOTS = {
    "cozmo": ("Cozmo", ["Test wheels", "Test face", "Beep"], "Ground in the middle"),
    "ev3": ("LEGO EV3", ["Test wheels", "Beep"], "Distance in front"),
    "ebo": ("EBO", ["Test wheels", "Test face"], "Distance in front"),
    "create3": ("iRobot Create 3", ["Test wheels", "Test lamps", "Beep"], "Distance in front"),
    "legoed": ("LEGO Education", ["Test wheels", "Test lamps", "Beep"], "Ground in the middle"),
    "root": ("iRobot Root", ["Test wheels", "Test lamps", "Beep"], "Ground in the middle"),
    "spike": ("LEGO SPIKE Prime", ["Test wheels", "Test lamps", "Beep"], "Distance in front"),
    "thymio": ("Thymio II", ["Test wheels", "Test face", "Beep"], "Distance in front"),
}
NEEDS = {
    "cozmo": "pycozmo",
    "ev3": None,
    "ebo": None,
    "create3": "bleak",
    "legoed": "bleak",
    "root": "bleak",
    "spike": "bleak",
    "thymio": "thymiodirect",
}


@pytest.fixture
def pupil(sit_down, own_server):
    return sit_down(own_server, empty=True, flat=True)


@pytest.fixture
def reach(own_server, monkeypatch):
    """A function that emulates a robot and sets its address in the server's settings."""
    monkeypatch.setenv("LEARNBLOCK_HOME", str(own_server.home))
    emulations = []

    def reach(name, world="empty", **chosen):
        if NEEDS[name]:
            pytest.importorskip(NEEDS[name])
        if name == "thymio" and shutil.which("asebaplayground") is None:
            pytest.skip("needs Aseba's playground: apt-get install aseba")
        emulations.append(emulate(name, world))
        # A busy machine may keep an emulator waiting for seconds.
        settle(name, {**emulations[-1].settings, "patience": 15.0, **chosen})
        return emulations[-1]

    yield reach
    for emulation in emulations:
        emulation.close()


def open_dialog(pupil):
    pupil.command("Robot", "Connect a robot…")
    expect(pupil.dialog()).to_contain_text("Connect a robot")


def button(pupil, name):
    return pupil.dialog().get_by_role("button", name=name, exact=True)


def connect(pupil, title):
    button(pupil, f"Connect {title}").click()
    expect(button(pupil, "Disconnect")).to_be_visible()
    expect(button(pupil, "Test wheels")).to_be_visible()


def tab_to(pupil, name):
    """Press Tab until a button has the focus."""
    wanted = button(pupil, name)
    expect(wanted).to_be_visible()
    for _ in range(40):
        if wanted.evaluate("button => button === document.activeElement"):
            return
        pupil.page.keyboard.press("Tab")
    raise AssertionError(f"{name} is not reached")


def pose(emulation):
    with emulation.twin.body() as body:
        return body.pose


def way(emulation):
    """Return how far from its start it has been every tenth of a second, in mm."""
    path = [pose[:2] for _, pose in emulation.twin.path]
    return [math.dist(path[0], place) for place in path] or [0.0]


def wheels(emulation):
    """Return how fast the twin drives and turns, in mm/s and degrees/s together."""
    began, before = emulation.twin.time, pose(emulation)
    wait_for(lambda: emulation.twin.time >= began + 0.1, "time passes")
    x, y, heading = pose(emulation)
    gone = math.hypot(x - before[0], y - before[1]) + abs(heading - before[2])
    return gone / (emulation.twin.time - began)


def commanded(emulation):
    """Return the devices that have been given a command over the wire."""
    with emulation.twin.body() as body:
        return {entry.device for entry in body.log}


def emotion(emulation):
    with emulation.twin.body() as body:
        return body.emotion


def stands(emulation):
    wait_for(lambda: wheels(emulation) < 1, "it stands")


@pytest.mark.parametrize("name", ROBOTS)
def test_a_robot_is_found_connected_and_used_with_a_click_each(pupil, reach, own_server, name):
    reach(name)
    title, tests, sensor = ROBOTS[name]
    open_dialog(pupil)
    # Another program on this computer may emulate a robot as well.
    expect(pupil.dialog()).to_contain_text(re.compile(r"Found near you: [1-9]"))
    connect(pupil, title)
    for test in tests:
        expect(button(pupil, test)).to_be_visible()
    expect(pupil.dialog().get_by_label("Live values")).to_contain_text(sensor)
    pupil.picture("connected")
    button(pupil, "Use this robot").click()
    expect(pupil.dialog()).to_have_count(0)
    expect(pupil.menu("Robot")).to_contain_text(title)
    settings = tomllib.loads((own_server.home / "settings.toml").read_text())
    assert settings["robots_used"] == {"names": [name]}


@pytest.mark.parametrize("name", ["cozmo", "ev3"])
def test_the_test_of_the_wheels_drives_50_mm_forward_and_back(pupil, reach, name):
    emulation = reach(name)
    open_dialog(pupil)
    connect(pupil, ROBOTS[name][0])
    button(pupil, "Test wheels").click()
    # By the twin's own record: a busy machine may look too seldom to see it on its way.
    wait_for(lambda: max(way(emulation)) > 35, "it drives forward")
    expect(button(pupil, "Test wheels")).to_be_visible()
    stands(emulation)
    assert way(emulation)[-1] < 25


def test_a_connected_robot_has_no_violation_of_accessibility_in_any_theme(pupil, reach, axe):
    reach("ev3")
    found = []
    for theme in THEMES:
        choose_theme(pupil, theme)
        open_dialog(pupil)
        connect(pupil, "LEGO EV3")
        found += faults(pupil, axe, "dialog")
        button(pupil, "Calibrate").click()
        found += faults(pupil, axe, "dialog")
        button(pupil, "Close").click()
        expect(pupil.dialog()).to_have_count(0)
    assert found == []


def test_a_robot_is_connected_and_tried_with_the_keyboard_alone(pupil, reach):
    emulation = reach("ev3")
    open_dialog(pupil)
    tab_to(pupil, "Connect LEGO EV3")
    pupil.page.keyboard.press("Enter")
    expect(button(pupil, "Test wheels")).to_be_visible()
    tab_to(pupil, "Test wheels")
    pupil.page.keyboard.press("Enter")
    wait_for(lambda: wheels(emulation) > 20, "it drives")
    expect(button(pupil, "Stop")).to_be_focused()
    pupil.page.keyboard.press("Enter")
    stands(emulation)
    expect(button(pupil, "Test wheels")).to_be_focused()


def test_face_and_beep_reach_the_robot(pupil, reach):
    emulation = reach("cozmo")
    open_dialog(pupil)
    connect(pupil, "Cozmo")
    button(pupil, "Test face").click()
    wait_for(lambda: emotion(emulation) == "joy", "it looks happy")
    button(pupil, "Beep").click()
    wait_for(lambda: "Speaker" in commanded(emulation), "it beeps")


def test_escape_stops_the_wheels_and_keeps_the_connection(pupil, reach):
    emulation = reach("ev3")
    open_dialog(pupil)
    connect(pupil, "LEGO EV3")
    button(pupil, "Test wheels").click()
    wait_for(lambda: wheels(emulation) > 20, "it drives")
    pupil.page.keyboard.press("Escape")
    stands(emulation)
    expect(button(pupil, "Disconnect")).to_be_visible()


@pytest.mark.parametrize(("name", "how"), [("cozmo", "close"), ("ev3", "reload")])
def test_closing_the_dialog_or_the_page_stops_the_wheels(pupil, reach, name, how):
    emulation = reach(name)
    open_dialog(pupil)
    connect(pupil, ROBOTS[name][0])
    button(pupil, "Test wheels").click()
    wait_for(lambda: wheels(emulation) > 20, "it drives")
    if how == "close":
        button(pupil, "Close").click()
    else:
        pupil.page.reload()
    stands(emulation)


@pytest.mark.parametrize("name", ["cozmo", "ev3"])
def test_a_lost_robot_is_said(pupil, reach, name):
    emulation = reach(name, patience=8.0)
    open_dialog(pupil)
    connect(pupil, ROBOTS[name][0])
    emulation.close()
    expect(pupil.dialog()).to_contain_text(f"Connection to {ROBOTS[name][0]} lost")
    pupil.picture("lost")
    button(pupil, "Help me").click()
    expect(pupil.dialog()).to_contain_text("Question 1 of")


def test_an_ev3_that_drives_too_far_is_calibrated(pupil, reach, own_server):
    # It believes that its wheels are smaller than they are.
    emulation = reach("ev3", wheel_radius=25.0)
    open_dialog(pupil)
    connect(pupil, "LEGO EV3")
    button(pupil, "Calibrate").click()
    button(pupil, "Drive 500 mm").click()
    expect(button(pupil, "Stop")).to_be_visible()
    expect(button(pupil, "Stop")).to_have_count(0)
    stands(emulation)
    driven = way(emulation)[-1]
    assert driven > 550
    pupil.dialog().get_by_label("It drove").fill(str(round(driven)))
    row = pupil.dialog().get_by_role("row", name="Wheel radius")
    expect(row).to_contain_text(re.compile("25.*(29|30|31)"))
    pupil.picture("calibrated")
    button(pupil, "Save new settings").click()
    expect(pupil.dialog()).to_contain_text("Saved. The robot uses them from now on.")
    settings = tomllib.loads((own_server.home / "settings.toml").read_text())["robots"]["ev3"]
    # 30 is the default, which is not saved.
    assert settings.get("wheel_radius", 30) == pytest.approx(30, abs=1.5)


def test_a_robot_that_is_not_found_is_helped_with_until_it_answers(pupil, reach):
    open_dialog(pupil)
    button(pupil, "Help me find Cozmo").click()
    dialog = pupil.dialog()
    expect(dialog).to_contain_text("Question 1 of 5")
    expect(dialog).to_contain_text("Is Cozmo awake?")
    button(pupil, "Yes, next").click()
    expect(dialog).to_contain_text("Is Cozmo charged?")
    button(pupil, "Back").click()
    expect(dialog).to_contain_text("Is Cozmo awake?")
    pupil.picture("help")
    reach("cozmo")
    expect(dialog).to_contain_text("Cozmo is here!")
    dialog.locator(".connect-help").get_by_role("button", name="Connect").click()
    expect(button(pupil, "Disconnect")).to_be_visible()


def test_a_robot_used_before_stays_in_the_list_with_its_name(pupil, reach):
    emulation = reach("cozmo")
    open_dialog(pupil)
    connect(pupil, "Cozmo")
    pupil.dialog().get_by_label("Name of this Cozmo").fill("Ada")
    pupil.dialog().get_by_label("Name of this Cozmo").press("Enter")
    expect(pupil.dialog().get_by_role("listitem", name="Ada")).to_contain_text("Connected")
    button(pupil, "Disconnect").click()
    emulation.close()
    before = pupil.dialog().get_by_role("region", name="Used before")
    expect(before.get_by_role("listitem", name="Ada")).to_contain_text("Not found")


def test_another_page_sees_that_a_robot_is_in_use(pupil, reach):
    reach("cozmo")
    open_dialog(pupil)
    connect(pupil, "Cozmo")
    other = pupil.open(pupil.page.url)
    mine, pupil.page = pupil.page, other
    open_dialog(pupil)
    expect(pupil.dialog()).to_contain_text("In use by another page or a program")
    expect(button(pupil, "Connect Cozmo")).to_be_disabled()
    pupil.page = mine
    button(pupil, "Disconnect").click()
    pupil.page = other
    connect(pupil, "Cozmo")


@pytest.mark.parametrize("name", ["cozmo", "ev3"])
def test_two_clicks_connect_a_robot_that_answers(pupil, reach, name):
    reach(name)
    pupil.menu("Robot").click()
    pupil.page.get_by_role("menuitem", name=f"Connect {ROBOTS[name][0]}").click()
    expect(button(pupil, "Disconnect")).to_be_visible()
    expect(pupil.dialog()).to_contain_text(re.compile(r"answers in \d+ ms"))
    pupil.picture("connected")


def test_robots_are_looked_for_only_while_the_menu_or_the_dialog_is_open(pupil, reach):
    reach("ev3")
    found = pupil.page.get_by_role("menuitem", name="Connect LEGO EV3")
    pupil.menu("Robot").click()
    expect(found).to_be_visible()
    pupil.page.keyboard.press("Escape")
    expect(found).to_have_count(0)
    open_dialog(pupil)
    expect(button(pupil, "Connect LEGO EV3")).to_be_visible()


def test_a_cozmo_that_another_program_uses_is_left_in_peace(pupil, reach):
    settings = reach("cozmo").settings
    with find("cozmo").load()(**settings) as robot:
        open_dialog(pupil)
        cozmo = pupil.dialog().get_by_role("listitem", name="Cozmo")
        expect(cozmo).to_contain_text("In use by another page or a program")
        robot.check_link()
        assert robot.status().silence < 2
    expect(button(pupil, "Connect Cozmo")).to_be_visible()


def test_its_twin_is_one_switch_away(pupil, reach):
    reach("ev3")
    open_dialog(pupil)
    connect(pupil, "LEGO EV3")
    pupil.dialog().get_by_role("radio", name="Simulated").check()
    twin = pupil.dialog().get_by_role("listitem").filter(has_text="Twin of your robot")
    expect(twin).to_contain_text("EV3")
    pupil.picture("twins")
    twin.get_by_role("button", name="Use this robot").click()
    expect(pupil.menu("Robot")).to_contain_text("EV3")
    expect(pupil.menu("Robot")).to_contain_text("simulated")


def test_an_address_is_entered_in_the_dialog(pupil, reach, own_server):
    settings = reach("ev3").settings
    settle("ev3", {"agent_port": 9})
    open_dialog(pupil)
    button(pupil, "Enter an address").click()
    pupil.dialog().get_by_role("combobox", name="Robot").select_option(label="LEGO EV3")
    pupil.dialog().get_by_label("LearnBlock agent port").fill(str(settings["agent_port"]))
    button(pupil, "Save and connect").click()
    expect(button(pupil, "Test wheels")).to_be_visible()
