"""A simulated robot is shaken and tilted in the page."""

import re

import pytest
from playwright.sync_api import expect

FEELING = """main:
    wait until function.is_tilted("left")
    print("tilted")
    wait until function.is_shaken()
    print("shaken")
    function.sleep(600)
end
"""


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with a program that feels how the robot is held."""
    pupil = sit_down(server, reduced_motion="reduce", empty=True)
    pupil.write("blocktext", FEELING)
    expect(pupil.blocks("lb_skill_is_shaken")).to_be_visible()
    return pupil


def test_a_robot_with_an_accelerometer_is_shaken_and_tilted_by_hand(pupil):
    pupil.choose("Robot", "Cozmo")
    console = pupil.page.locator(".console-lines")
    pupil.press("Run")
    pupil.state("Running")
    # The program has made its robot.
    expect(pupil.page.locator(".status")).to_contain_text(re.compile(r"[1-9] s"))
    pupil.press("Tilt robot to the left")
    pupil.expect_switched("Tilt robot to the left", on=True)
    expect(console).to_contain_text("tilted")
    pupil.press("Shake robot")
    expect(console).to_contain_text("shaken")
    pupil.picture("held")
    pupil.press("Tilt robot to the left")
    pupil.expect_switched("Tilt robot to the left", on=False)


def test_a_robot_without_an_accelerometer_is_not_offered_to_the_hand(pupil):
    pupil.menu("View and robot").click()
    expect(pupil.page.get_by_role("menuitemradio", name="View from above")).to_be_visible()
    expect(pupil.page.get_by_role("menuitemcheckbox", name="Shake robot")).to_have_count(0)
    expect(pupil.page.get_by_role("menuitem", name="Shake robot")).to_have_count(0)
