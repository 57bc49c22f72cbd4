"""The world: views, placing the robot and manual control."""

import re

import pytest
from playwright.sync_api import expect

WAITS = "main:\n    function.sleep(600)\nend\n"
WAVE = "main:\n    function.expressJoy()\nend\n"


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with a program that ends at once, on an empty floor."""
    pupil = sit_down(server, reduced_motion="reduce", empty=True)
    pupil.write("blocktext", WAVE)
    expect(pupil.blocks("lb_skill_expressJoy")).to_be_visible()
    return pupil


# Variants.


def choose_variant(pupil, number):
    pupil.menu("World").click()
    pupil.page.get_by_role("menuitem", name="Choose a variant…").click()
    pupil.dialog().get_by_label("Number").fill(number)
    pupil.picture(f"choose-{number}")
    pupil.dialog().get_by_role("button", name="Show").click()
    expect(pupil.dialog()).to_have_count(0)


def test_a_world_that_varies_can_be_run_in_another_variant(pupil):
    variant = pupil.page.get_by_text("Variant 7", exact=True)
    pupil.choose("World", "Arena")
    pupil.expect_robot("EBO at -?\\d+ mm")
    drawn = pupil.where_is_the_robot()
    choose_variant(pupil, "7")
    expect(variant).to_be_visible()
    varied = pupil.where_is_the_robot()
    assert varied != drawn
    pupil.choose("Speed", "Fastest")
    pupil.press("Run")
    pupil.state("Ended")
    expect(variant).to_be_visible()
    assert pupil.where_is_the_robot() == varied
    pupil.picture("variant-7")
    choose_variant(pupil, "0")
    pupil.expect_robot(drawn)
    expect(variant).to_have_count(0)


def test_a_world_without_variants_offers_none(pupil):
    pupil.choose("World", "Sumo")
    pupil.menu("World").click()
    expect(pupil.page.get_by_role("menuitem", name="Download world")).to_be_visible()
    expect(pupil.page.get_by_role("menuitem", name="Choose a variant…")).to_have_count(0)


# Placing the robot.


def test_a_dragged_robot_starts_at_its_new_position_until_the_world_is_reset(pupil):
    pupil.press("View from above")
    before = pupil.where_is_the_robot()
    pupil.carry_robot(right=60, down=-30)
    pupil.expect_robot(r"at \d{3} mm east, \d{3} mm north")
    pupil.picture("carried")
    carried = pupil.where_is_the_robot()
    assert before == "EBO at 0 mm east, 0 mm north, facing east"
    pupil.choose("Speed", "Fastest")
    pupil.press("Run")
    pupil.state("Ended")
    assert pupil.where_is_the_robot() == carried
    pupil.press("Reset world")
    pupil.expect_robot(before)


def test_a_robot_can_be_dragged_while_its_program_is_paused_but_not_while_it_runs(pupil):
    pupil.write("blocktext", WAITS)
    expect(pupil.blocks("lb_skill_sleep")).to_be_visible()
    pupil.press("View from above")
    pupil.press("Run")
    pupil.state("Running")
    before = pupil.where_is_the_robot()
    pupil.carry_robot(right=60, down=0)
    assert pupil.where_is_the_robot() == before
    pupil.press("Pause")
    pupil.state("Paused")
    pupil.press("View from above")
    pupil.carry_robot(right=60, down=0)
    pupil.expect_robot(r"at \d{3} mm east")
    pupil.press("Stop")
    pupil.state("Ended")


def test_the_robot_is_placed_with_the_keyboard(pupil):
    pupil.press("Place robot with keyboard")
    pupil.press_keys("Shift+ArrowUp", 2)
    pupil.press_keys("ArrowLeft", 3)
    pupil.press_keys("Shift+>", 2)
    pupil.picture("by-keys")
    pupil.page.keyboard.press("Escape")
    pupil.expect_robot("EBO at 30 mm west, 200 mm north, facing south")


# Views and camera.


def test_a_drive_is_seen_from_all_sides_with_its_trail(pupil):
    pupil.open_example("Avoid obstacles")
    pupil.choose("Speed", "20×")
    pupil.press("Run")
    pupil.page.wait_for_function(
        "() => parseFloat(document.querySelector('.status > .state')"
        ".textContent.split('·')[1]) > 40"
    )
    pupil.press("Pause")
    pupil.state("Paused")
    for view in ("View from above", "Follow the robot", "Look around"):
        pupil.press(view)
        pupil.expect_view(view)
        pupil.picture(view.split()[1])
    pupil.press("Show distance sensor beams")
    pupil.picture("beams")
    pupil.press("Stop")
    pupil.state("Ended")
    assert pupil.foreign == []


def test_the_camera_lists_the_tags_in_its_picture(pupil):
    pupil.open_example("Tag tour")
    pupil.press("Robot camera")
    camera = pupil.page.get_by_role("complementary", name="Robot camera")
    pupil.press("Run")
    expect(camera.get_by_role("listitem").first).to_have_text(re.compile(r"Tag \d"))
    pupil.picture("tags")
    pupil.press("Stop")
    pupil.press("Robot camera")
    expect(camera).to_have_count(0)


def test_the_camera_lists_the_emotion_of_a_face(pupil):
    pupil.open_example("Imitate feelings")
    pupil.press("Robot camera")
    camera = pupil.page.get_by_role("complementary", name="Robot camera")
    pupil.press("Run")
    expect(camera.get_by_role("listitem").first).to_have_text("Face: happy")
    pupil.picture("feelings")
    pupil.press("Stop")


# Manual control.


def test_the_robot_is_driven_by_keys_and_by_the_joystick(pupil):
    pupil.press("Manual control")
    stick = pupil.page.get_by_role("application", name="Joystick")
    stick.focus()
    pupil.page.keyboard.down("ArrowUp")
    pupil.expect_robot(r"EBO at [1-9]\d+ mm east")
    pupil.page.keyboard.up("ArrowUp")
    box = stick.bounding_box()
    mouse = pupil.page.mouse
    mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    mouse.down()
    mouse.move(box["x"] + 0.9 * box["width"], box["y"] + 0.4 * box["height"], steps=3)
    pupil.expect_robot("facing (south|west)")
    pupil.picture("joystick")
    mouse.up()
    pupil.press("Manual control")


def test_manual_drive_is_disabled_while_a_program_runs(pupil):
    pupil.write("blocktext", WAITS)
    expect(pupil.blocks("lb_skill_sleep")).to_be_visible()
    pupil.press("Manual control")
    pupil.press("Run")
    stick = pupil.page.get_by_role("application", name="Joystick")
    expect(stick).to_have_attribute("aria-disabled", "true")
    expect(pupil.page.get_by_text("A program is driving the robot.")).to_be_visible()
    pupil.press("Stop")
    expect(stick).to_have_attribute("aria-disabled", "false")
