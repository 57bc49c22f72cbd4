"""Creating a robot from its description on the page."""

import re

import pytest
from playwright.sync_api import expect

from learnblock.new.template import read

WRONG = read("robot/description.toml").replace("radius = 33", "radius = -1")


@pytest.fixture
def pupil(sit_down, own_server):
    """A pupil with their own server."""
    return sit_down(own_server)


@pytest.fixture
def dialog(pupil):
    pupil.press("Settings and help")
    pupil.page.get_by_role("menuitem", name="New robot…").click()
    return pupil.page.get_by_role("dialog", name="New robot")


def test_a_robot_is_created_from_its_description_and_its_twin_is_chosen(dialog, pupil):
    expect(description(dialog)).to_have_value(re.compile("maximum_speed"))
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


def test_a_mistake_in_a_description_is_reported_at_its_line(dialog, pupil):
    expect(description(dialog)).not_to_be_empty()
    description(dialog).fill(WRONG)
    dialog.get_by_role("textbox", name="Name").fill("rover")
    dialog.get_by_role("button", name="Create robot").click()
    expect(dialog.get_by_role("alert")).to_contain_text("wheels.radius")
    dialog.get_by_role("button", name=re.compile("^Line ")).click()
    assert selected(description(dialog)) == "radius = -1"
    pupil.page.keyboard.press("Escape")
    # The dialog keeps the text after Escape.
    pupil.press("Settings and help")
    pupil.page.get_by_role("menuitem", name="New robot…").click()
    expect(description(dialog)).to_have_value(WRONG)


def test_a_name_that_is_taken_or_is_a_path_is_refused(dialog):
    expect(description(dialog)).not_to_be_empty()
    for name, problem in {
        "cozmo": "There is already a robot",
        "../away": "cannot be named",
    }.items():
        dialog.get_by_role("textbox", name="Name").fill(name)
        dialog.get_by_role("button", name="Create robot").click()
        expect(dialog.get_by_role("alert")).to_contain_text(problem)


def test_in_spanish_by_keyboard(pupil):
    pupil.press("Settings and help")
    pupil.page.get_by_role("menuitemradio", name="Español").click()
    pupil.page.get_by_role("button", name="Ayuda").focus()
    pupil.page.keyboard.press("Enter")
    # The menu focuses its first item in a frame after it is shown.
    expect(pupil.page.get_by_role("menuitem").first).to_be_focused()
    pupil.page.get_by_role("menuitem", name="Robot nuevo…").focus()
    pupil.page.keyboard.press("Enter")
    dialog = pupil.page.get_by_role("dialog", name="Robot nuevo")
    expect(dialog.get_by_role("textbox", name="Descripción")).not_to_be_empty()
    dialog.get_by_role("textbox", name="Nombre").focus()
    pupil.page.keyboard.type("cozmo")
    pupil.page.keyboard.press("Enter")
    expect(dialog.get_by_role("alert")).to_contain_text("Ya hay un robot 'cozmo'")


def description(dialog):
    return dialog.get_by_role("textbox", name="Description")


def selected(box):
    return box.evaluate("box => box.value.slice(box.selectionStart, box.selectionEnd)")
