"""The world: looked at from all sides, changed by hand, driven in, and made anew."""

import re

import pytest
from playwright.sync_api import expect

WAITS = "main:\n    function.sleep(600)\nend\n"
WAVE = "main:\n    function.expressJoy()\nend\n"


@pytest.fixture
def pupil(sit_down, server):
    """With a program that ends at once, on an empty floor."""
    pupil = sit_down(server, reduced_motion="reduce")
    pupil.begin()
    pupil.write("blocktext", WAVE)
    expect(pupil.blocks("lb_skill_expressJoy")).to_be_visible()
    return pupil


# The robot, set down.


def test_a_robot_that_is_dragged_elsewhere_starts_there_until_all_is_put_back(pupil):
    pupil.press("Look from above")
    before = pupil.where_is_the_robot()
    pupil.carry_robot(right=60, down=-30)
    pupil.robot_is(r"at \d{3} mm east, \d{3} mm north")
    pupil.picture("carried")
    carried = pupil.where_is_the_robot()
    assert before == "EBO at 0 mm east, 0 mm north, looking east"
    pupil.choose("Speed", "As fast as it goes")
    pupil.press("Run")
    pupil.state("Ended")
    assert pupil.where_is_the_robot() == carried
    pupil.press("Put everything back")
    pupil.robot_is(before)


def test_a_robot_is_not_dragged_while_its_program_runs_but_while_that_is_paused(pupil):
    pupil.write("blocktext", WAITS)
    expect(pupil.blocks("lb_skill_sleep")).to_be_visible()
    pupil.press("Look from above")
    pupil.press("Run")
    pupil.state("Running")
    before = pupil.where_is_the_robot()
    pupil.carry_robot(right=60, down=0)
    assert pupil.where_is_the_robot() == before
    pupil.press("Pause")
    pupil.state("Paused")
    pupil.press("Look from above")
    pupil.carry_robot(right=60, down=0)
    pupil.robot_is(r"at \d{3} mm east")
    pupil.press("Stop")
    pupil.state("Ended")


def test_the_robot_is_set_down_with_the_keys(pupil):
    pupil.press("Set the robot down with the keys")
    pupil.press_keys("Shift+ArrowUp", 2)
    pupil.press_keys("ArrowLeft", 3)
    pupil.press_keys("Shift+>", 2)
    pupil.picture("by-keys")
    pupil.page.keyboard.press("Escape")
    pupil.robot_is("EBO at 30 mm west, 200 mm north, looking south")


# Looking.


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
    for view in ("Look from above", "Follow the robot", "Look around freely"):
        pupil.press(view)
        expect(pupil.page.get_by_role("button", name=view)).to_have_attribute(
            "aria-pressed", "true"
        )
        pupil.picture(view.split()[1])
    pupil.press("Show what the distance sensors see")
    pupil.picture("beams")
    pupil.press("Stop")
    pupil.state("Ended")
    assert pupil.foreign == []


def test_the_camera_shows_what_perception_found_in_its_picture(pupil):
    pupil.open_example("Tour of tags")
    pupil.press("Robot's camera")
    camera = pupil.page.get_by_role("complementary", name="Robot's camera")
    pupil.press("Run")
    expect(camera.get_by_role("listitem").first).to_have_text(re.compile(r"Tag \d"))
    pupil.picture("tags")
    pupil.press("Stop")
    pupil.press("Robot's camera")
    expect(camera).to_have_count(0)


def test_the_camera_s_picture_tells_what_a_face_expresses(pupil):
    pupil.open_example("Imitate feelings")
    pupil.press("Robot's camera")
    camera = pupil.page.get_by_role("complementary", name="Robot's camera")
    pupil.press("Run")
    expect(camera.get_by_role("listitem").first).to_have_text("Face: happy")
    pupil.picture("feelings")
    pupil.press("Stop")


# Driving by hand.


def test_the_robot_is_driven_by_keys_and_by_the_joystick(pupil):
    pupil.press("Drive by hand")
    stick = pupil.page.get_by_role("application", name="Joystick")
    stick.focus()
    pupil.page.keyboard.down("ArrowUp")
    pupil.robot_is(r"EBO at [1-9]\d+ mm east")
    pupil.page.keyboard.up("ArrowUp")
    box = stick.bounding_box()
    mouse = pupil.page.mouse
    mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    mouse.down()
    mouse.move(box["x"] + 0.9 * box["width"], box["y"] + 0.4 * box["height"], steps=3)
    pupil.robot_is("looking (south|west)")
    pupil.picture("joystick")
    mouse.up()
    pupil.press("Drive by hand")


def test_nobody_drives_by_hand_while_a_program_does(pupil):
    pupil.write("blocktext", WAITS)
    expect(pupil.blocks("lb_skill_sleep")).to_be_visible()
    pupil.press("Drive by hand")
    pupil.press("Run")
    stick = pupil.page.get_by_role("application", name="Joystick")
    expect(stick).to_have_attribute("aria-disabled", "true")
    expect(pupil.page.get_by_text("A program drives the robot.")).to_be_visible()
    pupil.press("Stop")
    expect(stick).to_have_attribute("aria-disabled", "false")


# Worlds of one's own.


def test_a_world_of_ones_own_is_made_and_driven_in(own_server, sit_down):
    pupil = sit_down(own_server)
    pupil.begin()
    pupil.press("Edit the world")
    editor = pupil.dialog()
    editor.get_by_role("button", name="Wall", exact=True).click()
    turn_wall(pupil, editor)
    editor.get_by_role("button", name="Tag", exact=True).click()
    pupil.press_keys("Shift+ArrowRight", 4)
    pupil.press_keys("ArrowUp", 5)
    pupil.picture("edited")
    expect(
        editor.get_by_role("button", name=re.compile("^Tag.*520 mm east, -10 mm north"))
    ).to_be_focused()
    editor.get_by_label("Save as").fill("My maze")
    editor.get_by_role("button", name="Save and use").click()
    expect(editor.get_by_role("status").filter(has_text="Saved as My maze")).to_be_visible()
    pupil.page.keyboard.press("Escape")
    expect(pupil.page.get_by_role("combobox", name="World")).to_have_value("My maze")
    pupil.robot_is("something ahead at 2[0-9][0-9] mm")
    pupil.picture("own-world")
    assert list(own_server.home.rglob("My maze.toml"))


def test_a_world_of_ones_own_is_replaced_only_by_whoever_says_so_twice(own_server, sit_down):
    pupil = sit_down(own_server)
    pupil.begin()
    save_world_as(pupil, "Mine")
    expect(pupil.dialog().get_by_role("status").filter(has_text="Saved as Mine")).to_be_visible()
    pupil.page.keyboard.press("Escape")
    pupil.choose("World", "Line")
    save_world_as(pupil, "Mine")
    expect(pupil.dialog()).to_contain_text("you have a world `Mine` already")
    pupil.picture("refused")
    pupil.dialog().get_by_role("button", name="Save and use").click()
    expect(pupil.dialog().get_by_role("status").filter(has_text="Saved as Mine")).to_be_visible()


def save_world_as(pupil, name):
    pupil.press("Edit the world")
    expect(pupil.dialog().get_by_label("Save as")).not_to_have_value("")
    pupil.dialog().get_by_label("Save as").fill(name)
    pupil.dialog().get_by_role("button", name="Save and use").click()


def test_a_wrong_value_of_a_world_is_told_at_its_field(pupil):
    pupil.press("Edit the world")
    editor = pupil.dialog()
    editor.get_by_role("button", name="Box", exact=True).click()
    height = editor.get_by_label("Height (mm)")
    height.fill("-5")
    height.press("Tab")
    expect(height).to_have_attribute("aria-invalid", "true")
    assert height.evaluate("field => field.validationMessage").startswith("A number from ")
    pupil.picture("wrong")


def turn_wall(pupil, editor):
    """Have the wall stand across, 300 mm before the robot, by its fields and by dragging."""
    for name, value in (
        ("Corner 1: east, mm", "100"),
        ("Corner 1: north, mm", "-300"),
        ("Corner 2: east, mm", "100"),
        ("Corner 2: north, mm", "300"),
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
