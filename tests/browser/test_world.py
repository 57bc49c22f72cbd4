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
    pupil.choose("World", "Sumo (2 robots)")
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


# The world editor.


def test_a_new_world_is_created_and_used(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.press("Edit world")
    editor = pupil.dialog()
    pupil.put_in_world("Wall")
    turn_wall(pupil, editor)
    editor.get_by_role("button", name="Tag", exact=True).press("Enter")
    expect(editor.get_by_text("Click where to put it: Tag")).to_be_visible()
    pupil.press_keys("Shift+ArrowRight", 5)
    pupil.press_keys("ArrowUp", 2)
    expect(editor.get_by_role("status").filter(has_text="Tag: x 500 mm, y 20 mm")).to_have_count(1)
    pupil.press_keys("Enter", 1)
    pupil.press_keys("ArrowDown", 3)
    pupil.picture("edited")
    expect(
        editor.get_by_role("button", name=re.compile("^Tag.*x 500 mm, y -10 mm"))
    ).to_be_focused()
    editor.get_by_label("Save as").fill("My maze")
    editor.get_by_role("button", name="Save and use").click()
    expect(editor.get_by_role("status").filter(has_text="Saved. Now using My maze")).to_be_visible()
    pupil.page.keyboard.press("Escape")
    pupil.expect_chosen("World", "My maze")
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


def test_every_kind_of_goal_is_added_saved_and_counted(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.press("Edit world")
    editor = pupil.dialog()
    kinds = ("Place to reach", "Places in order", "Place to stop", "Emotion to show")
    for number, kind in enumerate(kinds):
        pupil.put_in_world(kind, right=-150 + 90 * number)
    editor.get_by_role("button", name="Drive without bumps", exact=True).click()
    editor.get_by_label("After the goal").fill("stop")
    pupil.picture("goals")
    editor.get_by_label("Save as").fill("Tasks")
    editor.get_by_role("button", name="Save and use").click()
    expect(editor.get_by_role("status").filter(has_text="Saved. Now using Tasks")).to_be_visible()
    pupil.page.keyboard.press("Escape")
    pupil.expect_chosen("World", "Tasks")
    expect(pupil.page.get_by_text("Goal 1 of 5: reach")).to_be_visible()
    pupil.picture("tasks")


def test_an_invalid_value_of_a_world_is_reported_at_its_field(pupil):
    pupil.press("Edit world")
    editor = pupil.dialog()
    pupil.put_in_world("Box")
    height = editor.get_by_label("Height (mm)")
    height.fill("-5")
    height.press("Tab")
    expect(height).to_have_attribute("aria-invalid", "true")
    assert height.evaluate("field => field.validationMessage").startswith("Enter a number from ")
    pupil.picture("wrong")


def test_a_thing_is_dragged_from_the_palette_to_where_the_pointer_is(pupil):
    pupil.press("Edit world")
    editor = pupil.dialog()
    button = editor.get_by_role("button", name="Decoration", exact=True)
    # Nothing can be put before the world has come, and the mouse doesn't wait for it.
    expect(button).to_be_enabled()
    plan = editor.locator("svg.plan").bounding_box()
    box = button.bounding_box()
    mouse = pupil.page.mouse
    mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    mouse.down()
    mouse.move(plan["x"] + plan["width"] / 2 + 100, plan["y"] + plan["height"] / 2, steps=5)
    expect(editor.locator(".cross circle")).to_have_count(1)
    mouse.up()
    tree = editor.get_by_role("button", name=re.compile("^Decoration 1: Tree"))
    expect(tree).to_have_attribute("aria-pressed", "true")
    shape = tree.bounding_box()
    assert abs(shape["x"] + shape["width"] / 2 - plan["x"] - plan["width"] / 2 - 100) < 5
    assert abs(shape["y"] + shape["height"] / 2 - plan["y"] - plan["height"] / 2) < 5
    expect(editor.locator(".cross circle")).to_have_count(0)


def test_escape_ends_putting_before_it_closes_the_editor(pupil):
    pupil.press("Edit world")
    editor = pupil.dialog()
    wall = editor.get_by_role("button", name="Wall", exact=True)
    wall.click()
    expect(wall).to_have_attribute("aria-pressed", "true")
    pupil.page.keyboard.press("Escape")
    expect(wall).to_have_attribute("aria-pressed", "false")
    expect(wall).to_be_focused()
    expect(editor).to_be_visible()


def test_a_corner_of_a_wall_is_dragged_added_and_removed(pupil):
    pupil.press("Edit world")
    editor = pupil.dialog()
    pupil.put_in_world("Wall")
    corners = editor.locator(".points li")
    expect(corners).to_have_count(2)
    mouse = pupil.page.mouse
    x, y = middle(editor.locator(".knob.insert"))
    mouse.move(x, y)
    mouse.down()
    mouse.move(x, y - 60, steps=4)
    mouse.up()
    expect(corners).to_have_count(3)
    before = editor.get_by_label("Corner 2: y (mm)").input_value()
    x, y = middle(editor.locator(".knob.corner").nth(1))
    mouse.move(x, y)
    mouse.down()
    mouse.move(x, y - 40, steps=4)
    mouse.up()
    expect(editor.get_by_label("Corner 2: y (mm)")).not_to_have_value(before)
    mouse.dblclick(*middle(editor.locator(".knob.corner").nth(1)))
    expect(corners).to_have_count(2)


def test_a_goal_behind_a_wall_is_told_while_editing(pupil):
    pupil.press("Edit world")
    editor = pupil.dialog()
    editor.get_by_role("button", name="New world", exact=True).click()
    editor.get_by_role("button", name="Empty", exact=True).click()
    pupil.put_in_world("Place to reach", right=150)
    pupil.put_in_world("Wall")
    for name, value in (
        ("Corner 1: x (mm)", "100"),
        ("Corner 1: y (mm)", "-1000"),
        ("Corner 2: x (mm)", "100"),
        ("Corner 2: y (mm)", "1000"),
    ):
        editor.get_by_label(name).fill(value)
    reason = "The goal 'reach' cannot be reached: a wall is in the way."
    expect(editor.get_by_text(reason)).to_be_visible()
    goal = editor.get_by_role("button", name=re.compile(f"^Place to reach 1.*{reason}"))
    expect(goal).to_have_count(1)
    pupil.picture("unreachable")
    editor.get_by_role("button", name="Delete", exact=True).click()
    expect(editor.get_by_text(reason)).to_have_count(0)
    expect(goal).to_have_count(0)


@pytest.mark.certain
def test_the_same_template_size_and_number_make_the_same_world(pupil):
    pupil.press("Edit world")
    editor = pupil.dialog()
    editor.get_by_role("button", name="New world", exact=True).click()
    editor.get_by_role("button", name="Maze", exact=True).click()
    walls = editor.locator("[data-thing^=wall]")
    size, number = editor.get_by_label("Size"), editor.get_by_label("Number")
    size.fill("4")
    number.fill("7")
    expect(editor.get_by_label("West to east (mm)")).to_have_value("1600")
    expect(editor.get_by_label("Save as")).to_have_value("Maze 7")
    drawn = walls.locator("polyline.outline").evaluate_all("all => all.map(one => one.outerHTML)")
    pupil.picture("maze")
    number.fill("8")
    expect(editor.get_by_label("Save as")).to_have_value("Maze 8")
    number.fill("7")
    expect(editor.get_by_label("Save as")).to_have_value("Maze 7")
    again = walls.locator("polyline.outline").evaluate_all("all => all.map(one => one.outerHTML)")
    assert again == drawn
    editor.get_by_role("button", name="Undo").click()
    expect(walls).to_have_count(0)


def test_a_saved_world_is_downloaded_from_the_editor(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.press("Edit world")
    editor = pupil.dialog()
    share = editor.get_by_role("button", name="Download this world as a file")
    pupil.put_in_world("Decoration")
    expect(share).to_be_disabled()
    editor.get_by_label("Save as").fill("Shared")
    editor.get_by_role("button", name="Save and use").click()
    expect(share).to_be_enabled()
    with pupil.page.expect_download() as downloaded:
        share.click()
    assert downloaded.value.suggested_filename == "Shared.toml"
    assert 'kind = "tree"' in downloaded.value.path().read_text()


def test_handles_are_large_enough_for_a_finger(own_server, sit_down):
    size = {"width": 820, "height": 1180}
    pupil = sit_down(own_server, empty=True, viewport=size, has_touch=True, is_mobile=True)
    pupil.press("Edit world")
    pupil.put_in_world("Wall")
    hits = (
        pupil.dialog()
        .locator(".hit")
        .evaluate_all("all => all.map((one) => one.getBoundingClientRect().width)")
    )
    assert len(hits) == 3
    assert min(hits) >= 43.9


def middle(element):
    box = element.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


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
