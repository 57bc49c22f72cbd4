"""The world editor: things put, dragged, turned and undone, in 3D, on the plan and by keyboard."""

import re
import tomllib

import pytest
from playwright.sync_api import expect


@pytest.fixture
def pupil(sit_down, server):
    """A pupil on an empty floor."""
    return sit_down(server, reduced_motion="reduce", empty=True)


def test_a_new_world_is_created_and_used(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.press("Edit world")
    editor = pupil.dialog()
    show_plan(editor)
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
    save(pupil, "My maze")
    pupil.expect_robot("obstacle 2[0-9][0-9] mm ahead")
    pupil.picture("own-world")
    assert list(own_server.home.rglob("My maze.toml"))


def test_a_custom_world_is_replaced_only_after_confirmation(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.press("Edit world")
    save(pupil, "Mine")
    pupil.choose("World", "Line")
    pupil.expect_robot("World: A closed black line")
    pupil.press("Edit world")
    press_save(pupil, "Mine")
    expect(pupil.dialog()).to_contain_text("You already have a world 'Mine'")
    pupil.picture("refused")
    save(pupil, "Mine")


def press_save(pupil, name):
    expect(pupil.dialog().get_by_label("Save as")).not_to_have_value("")
    pupil.dialog().get_by_label("Save as").fill(name)
    pupil.dialog().get_by_role("button", name="Save and use").click()


def save(pupil, name):
    """Save the world; the editor closes, and the page uses the world."""
    press_save(pupil, name)
    expect(pupil.dialog()).to_have_count(0)
    pupil.expect_note(f"Saved. Now using {name}.")
    pupil.expect_chosen("World", name)


def show_plan(editor):
    expect(editor.get_by_role("button", name="3D")).to_have_attribute("aria-pressed", "true")
    button = editor.get_by_role("button", name="Plan", exact=True)
    button.click()
    expect(button).to_have_attribute("aria-pressed", "true")


def show_more(editor):
    editor.get_by_text("More: numbers and fine settings").click()


def test_every_kind_of_goal_is_added_saved_and_counted(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.press("Edit world")
    editor = pupil.dialog()
    kinds = ("Place to reach", "Places in order", "Place to stop", "Emotion to show")
    for number, kind in enumerate(kinds):
        pupil.put_in_world(kind, right=-150 + 90 * number)
    editor.get_by_role("button", name="Drive without bumps", exact=True).click()
    show_more(editor)
    editor.get_by_label("After the goal").fill("stop")
    pupil.picture("goals")
    save(pupil, "Tasks")
    expect(pupil.page.get_by_text("Goal 1 of 5: reach")).to_be_visible()
    pupil.picture("tasks")


def test_a_game_is_built_from_its_things_saved_and_won(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.press("Edit world")
    editor = pupil.dialog()
    editor.get_by_label("Game: lives").fill("2")
    editor.get_by_label("Game: time in seconds").fill("20")
    show_plan(editor)
    for name, right, up in (("Star", 60, 0), ("Bug", 60, 120), ("Moving obstacle", -160, 120)):
        pupil.put_in_world(name, right, up)
    editor.get_by_role("button", name="Things to collect", exact=True).click()
    editor.get_by_label("Kind").select_option("Star")
    pupil.picture("plan")
    editor.get_by_role("button", name="3D").click()
    pupil.picture("room")
    save(pupil, "Star hunt")
    [file] = own_server.home.rglob("Star hunt.toml")
    world = tomllib.loads(file.read_text("utf-8"))
    star, bug = world["collectable"]
    assert (star["kind"], star["score"], bug["kind"], bug["lives"]) == ("star", 1, "bug", -1)
    assert world["game"] == {"lives": 2, "countdown": 20}
    pupil.write("blocktext", "main:\n    function.drive_distance(600)\nend\n")
    pupil.choose("Speed", "Fastest")
    pupil.press("Run")
    expect(pupil.page.get_by_role("heading", name="You win")).to_be_visible()
    pupil.picture("won")


def test_an_invalid_value_of_a_world_is_reported_at_its_field(pupil):
    pupil.press("Edit world")
    editor = pupil.dialog()
    pupil.put_in_world("Box")
    show_more(editor)
    height = editor.get_by_label("Height (mm)")
    height.fill("-5")
    height.press("Tab")
    expect(height).to_have_attribute("aria-invalid", "true")
    assert height.evaluate("field => field.validationMessage").startswith("Enter a number from ")
    pupil.picture("wrong")


def drag(pupil, start, end):
    mouse = pupil.page.mouse
    mouse.move(*start)
    mouse.down()
    mouse.move(*end, steps=5)
    mouse.up()


def tile(editor, name):
    """Return a button of the palette; nothing can be put before the world has come."""
    button = editor.get_by_role("button", name=name, exact=True)
    expect(button).to_be_enabled()
    button.scroll_into_view_if_needed()
    return button


def thing(editor, words):
    """Return an object in the world by the beginning of its description."""
    return editor.get_by_role("button", name=re.compile(f"^{words}"))


@pytest.mark.parametrize("view", ["in 3D", "plan"])
def test_a_thing_is_dragged_from_the_palette_to_where_the_pointer_is(pupil, view):
    pupil.press("Edit world")
    editor = pupil.dialog()
    button = tile(editor, "Tree")
    if view == "plan":
        show_plan(editor)
    x, y = middle(editor.locator("svg.plan"))
    mouse = pupil.page.mouse
    mouse.move(*middle(button))
    mouse.down()
    mouse.move(x + 100, y, steps=5)
    ring = editor.locator(".cross .ring")
    expect(ring).to_have_count(1)
    ring_x, ring_y = middle(ring)
    assert abs(ring_x - x - 100) < 8
    assert abs(ring_y - y) < 8
    mouse.up()
    expect(thing(editor, "Decoration 1: Tree")).to_have_attribute("aria-pressed", "true")
    expect(ring).to_have_count(0)


def test_a_world_is_made_by_dragging_turned_undone_saved_and_used(own_server, sit_down):
    pupil = sit_down(own_server, empty=True, reduced_motion="reduce")
    pupil.press("Edit world")
    editor = pupil.dialog()
    x, y = middle(editor.locator("svg.plan"))
    drag(pupil, middle(tile(editor, "Box")), (x - 120, y + 40))
    box = thing(editor, "Box 1")
    before = box.get_attribute("aria-label")
    drag(pupil, middle(editor.locator(".knob.turn")), (x - 120, y + 160))
    expect(box).not_to_have_attribute("aria-label", before)
    assert "facing 0°" not in box.get_attribute("aria-label")
    turned = box.get_attribute("aria-label")
    drag(pupil, middle(box.locator(".body")), (x + 60, y + 60))
    expect(box).not_to_have_attribute("aria-label", turned)
    pupil.picture("dragged")
    editor.get_by_role("button", name="Undo").click()
    expect(box).to_have_attribute("aria-label", turned)
    save(pupil, "Boxes")
    pupil.picture("used")
    saved = tomllib.loads(next(own_server.home.rglob("Boxes.toml")).read_text(encoding="utf-8"))
    assert len(saved["box"]) == 1


def test_a_world_is_made_with_the_keyboard_alone(own_server, sit_down):
    pupil = sit_down(own_server, empty=True, reduced_motion="reduce")
    pupil.press("Edit world")
    editor = pupil.dialog()
    tile(editor, "House").focus()
    pupil.press_keys("Enter", 1)
    pupil.press_keys("Shift+ArrowRight", 3)
    pupil.press_keys("Enter", 1)
    house = thing(editor, "Decoration 1: House")
    expect(house).to_be_focused()
    placed = house.get_attribute("aria-label")
    pupil.press_keys("]", 2)
    expect(house).to_have_attribute("aria-label", re.compile("facing 30°"))
    pupil.press_keys("+", 1)
    show_more(editor)
    expect(editor.get_by_label("Size (1: usual)")).to_have_value("1.25")
    house.focus()
    pupil.press_keys("Control+z", 2)
    expect(house).to_have_attribute("aria-label", placed)
    pupil.press_keys("Control+y", 1)
    expect(house).to_have_attribute("aria-label", re.compile("facing 30°"))
    name = editor.get_by_label("Save as")
    name.fill("Houses")
    name.press("Enter")
    expect(pupil.dialog()).to_have_count(0)
    pupil.expect_chosen("World", "Houses")


def test_the_floor_is_named_as_it_is_seen(pupil):
    pupil.press("Edit world")
    editor = pupil.dialog()
    chosen = editor.get_by_role("radio", name="As the theme (sensors see white)")
    expect(chosen).to_be_checked()
    shown = chosen.locator("+ span").evaluate("swatch => getComputedStyle(swatch).backgroundColor")
    show_plan(editor)
    floor = editor.locator("svg.plan rect").first
    assert shown == floor.evaluate("floor => getComputedStyle(floor).fill")
    editor.get_by_role("radio", name="white", exact=True).check(force=True)
    expect(floor).to_have_css("fill", "rgb(255, 255, 255)")


def test_engineers_numbers_are_under_more(pupil):
    pupil.press("Edit world")
    editor = pupil.dialog()
    numbers = ("Sensor noise", "Wheel slip (0 to 0.3)", "Floor picture", "Ambient light")
    expect(editor.get_by_label("Theme", exact=True)).to_be_visible()
    for name in numbers:
        expect(editor.get_by_label(name).first).to_be_hidden()
    show_more(editor)
    for name in numbers:
        expect(editor.get_by_label(name).first).to_be_visible()


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
    show_more(editor)
    corners = editor.locator(".form-rows li")
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
    show_more(editor)
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
    show_plan(editor)
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
    pupil.put_in_world("Tree")
    expect(share).to_be_disabled()
    save(pupil, "Shared")
    pupil.press("Edit world")
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
    show_more(editor)
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
