"""The world: views, placing the robot, manual control and the world editor."""

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
        "() => parseFloat(document.querySelector('.world-pane .pane-head > .state:last-of-type')"
        ".textContent.split('·')[1]) > 40"
    )
    pupil.press("Pause")
    pupil.state("Paused")
    for view in ("View from above", "Follow the robot", "Look around"):
        pupil.press(view)
        expect(pupil.page.get_by_role("button", name=view)).to_have_attribute(
            "aria-pressed", "true"
        )
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


# The world editor.


def test_a_new_world_is_created_and_used(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.press("Edit world")
    editor = pupil.dialog()
    editor.get_by_role("button", name="Wall", exact=True).click()
    turn_wall(pupil, editor)
    editor.get_by_role("button", name="Tag", exact=True).click()
    pupil.press_keys("Shift+ArrowRight", 4)
    pupil.press_keys("ArrowUp", 5)
    pupil.picture("edited")
    expect(
        editor.get_by_role("button", name=re.compile("^Tag.*x 520 mm, y -10 mm"))
    ).to_be_focused()
    editor.get_by_label("Save as").fill("My maze")
    editor.get_by_role("button", name="Save and use").click()
    expect(editor.get_by_role("status").filter(has_text="Saved. Now using My maze")).to_be_visible()
    pupil.page.keyboard.press("Escape")
    expect(pupil.page.get_by_role("combobox", name="World")).to_have_value("My maze")
    pupil.expect_robot("obstacle 2[0-9][0-9] mm ahead")
    pupil.picture("own-world")
    assert list(own_server.home.rglob("My maze.toml"))


def test_a_custom_world_is_replaced_only_after_confirmation(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    save_world_as(pupil, "Mine")
    expect(
        pupil.dialog().get_by_role("status").filter(has_text="Saved. Now using Mine")
    ).to_be_visible()
    pupil.page.keyboard.press("Escape")
    pupil.choose("World", "Line")
    pupil.expect_robot("World: A closed black line")
    save_world_as(pupil, "Mine")
    expect(pupil.dialog()).to_contain_text("You already have a world 'Mine'")
    pupil.picture("refused")
    pupil.dialog().get_by_role("button", name="Save and use").click()
    expect(
        pupil.dialog().get_by_role("status").filter(has_text="Saved. Now using Mine")
    ).to_be_visible()


def save_world_as(pupil, name):
    pupil.press("Edit world")
    expect(pupil.dialog().get_by_label("Save as")).not_to_have_value("")
    pupil.dialog().get_by_label("Save as").fill(name)
    pupil.dialog().get_by_role("button", name="Save and use").click()


def test_an_invalid_value_of_a_world_is_reported_at_its_field(pupil):
    pupil.press("Edit world")
    editor = pupil.dialog()
    editor.get_by_role("button", name="Box", exact=True).click()
    height = editor.get_by_label("Height (mm)")
    height.fill("-5")
    height.press("Tab")
    expect(height).to_have_attribute("aria-invalid", "true")
    assert height.evaluate("field => field.validationMessage").startswith("Enter a number from ")
    pupil.picture("wrong")


def turn_wall(pupil, editor):
    """Place a wall across, 300 mm in front of the robot, with its fields and by dragging."""
    for name, value in (
        ("Corner 1: x (mm)", "100"),
        ("Corner 1: y (mm)", "-300"),
        ("Corner 2: x (mm)", "100"),
        ("Corner 2: y (mm)", "300"),
    ):
        editor.get_by_label(name).fill(value)
    wall = editor.get_by_role("button", name=re.compile("^Wall 1")).locator("path, polyline").first
    box = wall.bounding_box()
    plan = editor.locator("svg.plan").bounding_box()
    mouse = pupil.page.mouse
    mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 4)
    mouse.down()
    mouse.move(
        box["x"] + box["width"] / 2 + plan["width"] / 15, box["y"] + box["height"] / 4, steps=5
    )
    mouse.up()
