"""The page without a mouse, and the tour for new users."""

import re

import pytest
from playwright.sync_api import expect

from browser.test_square import SQUARE
from browser.typist import IN_TABS, Typist

STEPS = (
    "Add a block",
    "Change a number",
    "Run it",
    "See it as text",
    "Try another robot",
)


def test_listing_4_is_built_with_the_keyboard_alone_and_the_robot_closes_the_square(pupil):
    keys = Typist(pupil)
    keys.begin()
    keys.choose("Robot", "Cozmo")
    build_listing_4(keys)
    pupil.sees("blocktext", "angle += 90")
    assert pupil.reads("blocktext") == SQUARE.split("\n")
    keys.switch("Python")
    pupil.sees("python", "robot.set_orientation(angle)")
    pupil.picture("built")
    assert pupil.reads("python")[-4:] == [
        "    robot.set_orientation(angle)",
        "    times += 1",
        "    angle += 90",
        "",
    ]
    keys.speed(steps=4)
    pupil.note_running_blocks()
    keys.press("Control+Enter")
    pupil.have_run("lb_skill_set_orientation")
    pupil.picture("running")
    pupil.wait_for_the_end()
    pupil.picture("closed")
    keys.command("View and robot", "Where is the robot")
    x, y = pupil.described_place()
    assert abs(x) < 10
    assert abs(y) < 10
    assert pupil.foreign == []


def test_f6_reaches_every_region_of_the_page(pupil):
    keys = Typist(pupil)
    seen = []
    for _ in range(6):
        keys.press("F6")
        seen.append(keys.region())
    assert sorted(seen) == ["bar", "blocks", "blocktext", "panel", "program", "world"]
    keys.press("Shift+F6")
    assert keys.region() == seen[-2]


def test_a_text_is_edited_and_left_with_the_keyboard(pupil):
    keys = Typist(pupil)
    keys.begin()
    keys.go_to("blocktext")
    keys.press("Control+a")
    pupil.page.keyboard.insert_text("main:\n    function.expressJoy()\nend\n")
    expect(pupil.blocks("lb_skill_expressJoy")).to_be_visible()
    # The first one closes the suggestions, where there are any.
    keys.press("Escape", "Escape", "Tab")
    expect(pupil.editor("blocktext")).not_to_be_focused()


def test_a_letter_typed_in_the_dropdown_of_a_block_does_not_leave_it(pupil):
    pupil.open_example("square")
    expect(pupil.blocks("controls_whileUntil")).to_be_visible()
    keys = Typist(pupil)
    keys.go_to("blocks")
    keys.walk("ArrowDown", "^repeat while")
    keys.walk("ArrowRight", "^dropdown: while")
    keys.press("Enter", "t", "ArrowDown", "Enter")
    assert keys.hears() == "dropdown: until"
    pupil.sees("blocktext", "while not times < 4")


def test_removing_a_breakpoint_at_its_dot_moves_the_focus_to_its_block(pupil):
    pupil.open_example("square")
    expect(pupil.blocks("controls_whileUntil")).to_be_visible()
    keys = Typist(pupil)
    keys.go_to("blocks")
    keys.walk("ArrowDown", "^wait")
    keys.press("F9")
    dot = pupil.page.locator(".lbBreakpoint")
    expect(dot).to_have_count(1)
    keys.walk("ArrowRight", "^Remove breakpoint")
    keys.press("Enter")
    expect(dot).to_have_count(0)
    assert keys.hears().startswith("wait")


def test_the_search_can_be_opened_from_the_blocks_of_the_palette(pupil):
    keys = Typist(pupil)
    keys.begin()
    keys.go_to("blocks")
    keys.walk("ArrowDown", "when Run is pressed")
    keys.press("t")
    keys.walk("ArrowDown", "^Control$")
    keys.press("ArrowRight")
    keys.find("wait", "^wait")
    assert keys.hears().startswith("wait")
    pupil.sees("blocktext", "function.sleep(1)")


def test_t_leads_from_the_blocks_of_the_palette_back_to_its_tabs(pupil):
    keys = Typist(pupil)
    keys.begin()
    keys.go_to("blocks")
    keys.walk("ArrowDown", "when Run is pressed")
    for category, block in (("Sense", "^obstacle"), ("Maths", "^not")):
        keys.go_to_tabs()
        keys.walk("ArrowDown", f"^{category}$")
        keys.press("ArrowRight")
        keys.walk("ArrowDown", block)


def test_closing_a_dialog_restores_the_focus(pupil):
    keys = Typist(pupil)
    for shortcut in ("Control+o", "F1"):
        keys.go_to("world")
        before = keys.hears()
        keys.press(shortcut)
        expect(pupil.dialog()).to_be_visible()
        pupil.picture(shortcut)
        keys.press("Escape")
        expect(pupil.dialog()).to_have_count(0)
        assert keys.hears() == before


def test_arrow_keys_change_tabs_and_move_dividers(pupil):
    keys = Typist(pupil)
    keys.go_to("panel")
    for name in ("Variables", "Calls", "Why?", "Runs", "Sensors", "Problems", "Result", "Console"):
        keys.press("ArrowRight")
        expect(pupil.page.get_by_role("tab", name=name)).to_be_focused()
        expect(pupil.page.get_by_role("tabpanel", name=name)).to_be_visible()
    divider = pupil.page.get_by_role("separator", name="Divider between program and world")
    before = int(divider.get_attribute("aria-valuenow"))
    keys.walk("Shift+Tab", "^Divider between program and world$")
    keys.press("ArrowLeft")
    expect(divider).to_have_attribute("aria-valuenow", str(before - 3))


def test_the_tour_goes_on_with_the_keyboard_once_a_block_was_added_and_ends_at_the_run_button(
    sit_down, server
):
    pupil = sit_down(server, tour=True)
    keys = Typist(pupil)
    offer = pupil.page.get_by_role("button", name="Start tour")
    expect(offer).to_be_visible()
    keys.walk("Tab", "^Start tour")
    keys.press("Enter")
    card = pupil.page.locator(".tour-card")
    expect(card).to_be_focused()
    expect(card.get_by_role("heading")).to_have_text(STEPS[0])
    expect(card.get_by_role("button", name="Next")).to_have_count(0)
    keys.find("turn", "^turn ")
    for number, title in enumerate(STEPS[1:], 2):
        expect(card.get_by_role("heading")).to_have_text(title)
        expect(card).to_contain_text(f"Step {number} of 5")
        pupil.picture(f"step-{number}")
        card.get_by_role("button", name=re.compile("Next|Done")).press("Enter")
    expect(card).to_have_count(0)
    expect(pupil.page.get_by_role("button", name="Run", exact=True)).to_be_focused()
    pupil.page.reload()
    pupil.expect_project(re.compile("."))
    expect(offer).to_have_count(0)


def test_the_tour_goes_on_when_the_pupil_has_done_what_it_says(sit_down, server):
    pupil = sit_down(server, empty=True)
    pupil.command("Settings and help", "Page tour")
    title = pupil.page.locator(".tour-card").get_by_role("heading")
    expect(title).to_have_text(STEPS[0])
    pupil.write("blocktext", "main:\n    function.sleep(20)\nend\n")
    expect(title).to_have_text(STEPS[1])
    pupil.write("blocktext", "main:\n    function.sleep(30)\nend\n")
    expect(title).to_have_text(STEPS[2])
    pupil.press("Run")
    expect(title).to_have_text(STEPS[3])
    pupil.press("Stop")
    pupil.press("Python")
    expect(title).to_have_text(STEPS[4])
    pupil.choose("Robot", "Thymio II")
    expect(title).to_have_count(0)


def go_to_main(keys):
    keys.go_to("blocks")
    keys.walk("ArrowDown", "when Run is pressed")


def build_listing_4(keys):
    go_to_main(keys)
    for name in ("times", "angle"):
        keys.make_variable(name)
    set_variable(keys, "times", "0")
    set_variable(keys, "angle", "90")
    keys.find("gyroscope", "^call this heading")
    keys.find("while", "^repeat while")
    fewer_than_four(keys)
    keys.walk("ArrowLeft", "^repeat while")
    turn_a_corner(keys)


def set_variable(keys, name, value):
    keys.take("Variables", "^set Variable")
    keys.choose_in("dropdown: Variable", name)
    keys.walk("ArrowRight", "^Edit value to set, number: 0")
    keys.fill(value)
    keys.walk("ArrowLeft", "^set Variable")


def fewer_than_four(keys):
    keys.walk("ArrowRight", "^condition")
    keys.take("Maths", "Empty equals Empty")
    keys.choose_in("dropdown: equals", "^less than$")
    keys.walk("ArrowRight", "^second value")
    keys.take("Maths", "^number: 123")
    keys.fill("4")
    keys.walk("ArrowLeft", "^first value")
    keys.take("Variables", "^dropdown: Variable 'times'")


def turn_a_corner(keys):
    keys.find("forward", "^keep driving forward at")
    keys.find("wait", "^wait")
    keys.fill("5")
    keys.walk("ArrowLeft", "^wait")
    keys.find("stop", "^stop driving")
    keys.find("to heading", "^turn to heading")
    keys.walk("ArrowRight", "^Edit angle")
    keys.take("Variables", "^dropdown: Variable 'angle'")
    keys.walk("ArrowLeft", "^turn to heading")
    for name, change in (("times", "1"), ("angle", "90")):
        keys.take("Variables", "^change Variable")
        keys.choose_in("dropdown: Variable", name)
        keys.walk("ArrowLeft", "^change Variable")
        keys.fill(change)
        keys.walk("ArrowLeft", "^change Variable")


def test_an_if_with_an_else_and_the_colour_of_a_lamp_are_made_with_the_keyboard(pupil):
    keys = Typist(pupil)
    keys.begin()
    keys.choose("Robot", "Thymio")
    go_to_main(keys)
    keys.find("else", "^if Empty.*2 branches")
    keys.walk("ArrowRight", r"^if Empty: yes or no$")
    keys.find("obstacle ahead", "^obstacle ahead")
    keys.fill("150")
    keys.walk("ArrowLeft", "^if obstacle")
    keys.find("LED", "^set LED first to red")
    keys.walk("ArrowRight", "olour")
    keys.press("Enter")
    keys.walk("Tab", "^green$")
    keys.press("Enter")
    pupil.picture("built")
    pupil.sees("blocktext", "if function.is_front_obstacle(150):", "RGBled(0, 255, 0")


def test_a_when_is_made_with_the_keyboard(pupil):
    keys = Typist(pupil)
    keys.begin()
    go_to_main(keys)
    keys.take("Events", "^event.* when")
    keys.walk("ArrowRight", r"yes or no$")
    keys.find("obstacle ahead", "^obstacle ahead")
    pupil.picture("built")
    pupil.sees("blocktext", "when my_event = function.is_front_obstacle(200):")


@pytest.mark.parametrize("place", ["Run", "Page", "World menu", "Console"])
def test_keys_lead_into_the_blocks_from_everywhere_but_never_from_a_field(sit_down, server, place):
    pupil = sit_down(server, empty=True, flat=True)
    page = pupil.page
    expect(page.locator(".lbGroupIcon").first).to_be_visible()
    keys, found = Typist(pupil), page.locator(".lbSearchHead input")
    outside = {
        "Run": page.get_by_role("button", name="Run", exact=True),
        "Page": page.locator("header [aria-haspopup=menu]").first,
        "World menu": page.locator(".world-place [aria-haspopup=menu]").first,
        "Console": page.get_by_role("tab", name="Console"),
    }[place]
    outside.focus()
    keys.press("Control+b")
    expect(found).to_be_focused()
    page.keyboard.type("twf")
    expect(found).to_have_value("twf")
    outside.focus()
    keys.press("t")
    page.wait_for_function(IN_TABS)
    outside.focus()
    keys.press("w")
    assert keys.region() == "blocks"
    outside.focus()
    keys.press("Control+f")
    expect(page.locator(".blockly-ws-search input")).to_be_focused()
