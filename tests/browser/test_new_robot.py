"""Creating a robot from its description on the page."""

import re

import pytest
from playwright.sync_api import expect


@pytest.fixture
def pupil(sit_down, own_server):
    """A pupil with their own server."""
    return sit_down(own_server)


@pytest.fixture
def dialog(pupil):
    pupil.command("Settings and help", "Coder")
    pupil.command("Settings and help", "New robot…")
    return pupil.page.get_by_role("dialog", name="New robot")


def test_a_robot_is_created_from_its_description_and_its_twin_is_chosen(dialog, pupil):
    expect(dialog.get_by_role("textbox", name="Description")).to_have_value(
        re.compile("maximum_speed")
    )
    dialog.get_by_role("textbox", name="Name").fill("pathfinder")
    pupil.picture("description")
    dialog.get_by_role("button", name="Create robot").click()
    expect(dialog).to_contain_text("sim_pathfinder.py")
    pupil.picture("made")
    dialog.get_by_role("button", name="Use the twin").click()
    pupil.expect_chosen("Robot", "Pathfinder")
    pupil.choose("Speed", "Fastest")
    pupil.press("Run")
    pupil.state("Ended")
