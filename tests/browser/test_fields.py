"""The editors of a block's values: the piano, menus with a place for others, faces."""

import re

import pytest
from playwright.sync_api import expect

from browser.test_tablet import tap

NOTE = """\
main:
    function.play_note("C4", 1)
end
"""
GYROSCOPE = """\
main:
    function.reset_orientation("{axis}")
end
"""


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with an empty program."""
    return sit_down(server, viewport={"width": 1600, "height": 900}, empty=True, flat=True)


def test_a_note_is_chosen_on_a_piano_with_the_mouse(pupil):
    pupil.write("blocktext", NOTE)
    pupil.click_on(menu_of(pupil, "lb_skill_play_note"))
    pupil.picture("piano")
    pupil.page.get_by_role("radio", name="E4", exact=True).click()
    pupil.sees("blocktext", 'function.play_note("E4"')


def test_a_note_is_chosen_on_a_piano_with_the_keys(pupil):
    pupil.write("blocktext", NOTE)
    pupil.click_on(menu_of(pupil, "lb_skill_play_note"))
    expect(pupil.page.get_by_role("radio", name="C4", exact=True)).to_be_focused()
    for key in ("ArrowRight", "ArrowUp", "Enter"):
        pupil.page.keyboard.press(key)
    pupil.sees("blocktext", 'function.play_note("C#5"')


def test_escape_keeps_the_note(pupil):
    pupil.write("blocktext", NOTE)
    pupil.click_on(menu_of(pupil, "lb_skill_play_note"))
    pupil.page.keyboard.press("ArrowRight")
    pupil.page.keyboard.press("Escape")
    expect(pupil.page.locator(".lbPiano")).to_be_hidden()
    pupil.sees("blocktext", 'function.play_note("C4"')


def test_on_a_tablet_the_keys_of_the_piano_are_wide_enough_for_a_finger(sit_down, server):
    tablet = {"width": 1024, "height": 768}
    pupil = sit_down(server, stage="starter", viewport=tablet, has_touch=True, empty=True)
    tap(pupil, ".areas button", "Block-Text")
    pupil.write("blocktext", NOTE)
    tap(pupil, ".areas button", "Blocks")
    menu_of(pupil, "lb_skill_play_note").tap()
    key = pupil.page.get_by_role("radio", name="D4", exact=True)
    assert key.bounding_box()["width"] >= 44
    key.tap()
    expect(menu_of(pupil, "lb_skill_play_note")).to_contain_text("D4")


@pytest.mark.parametrize(("language", "words"), [("en", "Z (upright)"), ("es", "Z (vertical)")])
def test_the_gyroscope_is_chosen_by_words(sit_down, server, language, words):
    pupil = sit_down(server, language=language, empty=True)
    pupil.write("blocktext", GYROSCOPE.format(axis="Z_AXIS"))
    expect(menu_of(pupil, "lb_skill_reset_orientation")).to_contain_text(words)


def test_a_menu_keeps_a_text_that_it_does_not_offer_and_takes_another(pupil):
    pupil.write("blocktext", GYROSCOPE.format(axis="MINE"))
    expect(menu_of(pupil, "lb_skill_reset_orientation")).to_contain_text("MINE")
    pupil.click_on(menu_of(pupil, "lb_skill_reset_orientation"))
    pupil.page.locator(".blocklyMenuItem", has_text="Other…").click()
    pupil.answer("TILT")
    pupil.sees("blocktext", 'function.reset_orientation("TILT")')


def test_one_swatch_chooses_red_green_and_blue_of_an_led(pupil):
    pupil.write("blocktext", 'main:\n    function.RGBled(1, 2, 3, "first")\nend\n')
    swatch = pupil.blocks("lb_skill_RGBled").locator("> .blocklyImageField").last
    expect(swatch.locator("image")).to_have_attribute("xlink:href", re.compile("010203"))
    expect(swatch).to_have_accessible_name("colour")
    swatch.click()
    pupil.picture("swatches")
    pupil.page.get_by_role("button", name="orange", exact=True).click()
    pupil.sees("blocktext", 'function.RGBled(255, 136, 0, "first")')
    expect(swatch.locator("image")).to_have_attribute("xlink:href", re.compile("ff8800"))


def test_a_variable_among_the_three_numbers_leaves_them_alone(pupil):
    pupil.write("blocktext", 'main:\n    x = 1\n    function.RGBled(x, 2, 3, "first")\nend\n')
    swatch = pupil.blocks("lb_skill_RGBled").locator("> .blocklyImageField").last
    swatch.click()
    expect(pupil.page.locator(".lbPanel")).to_have_count(0)
    pupil.sees("blocktext", 'function.RGBled(x, 2, 3, "first")')


def test_a_block_about_a_feeling_shows_its_face(pupil):
    pupil.write("blocktext", "main:\n    function.expressJoy()\n    function.sleep(1)\nend\n")
    pictures = "> .blocklyImageField"
    expect(pupil.blocks("lb_skill_expressJoy").locator(pictures)).to_have_count(2)
    expect(pupil.blocks("lb_skill_sleep").locator(pictures)).to_have_count(1)


@pytest.mark.parametrize(
    ("written", "chosen", "becomes"),
    [
        ("function.turn_left(-23)", "right", "function.turn_right(23)"),
        ("function.turn_left()", "right", "function.turn_right()"),
        ("function.turn_left(40)", "left", "function.turn_left(-40)"),
        ("function.move_right(20, 15)", "left", "function.move_left(20, -15)"),
        ("function.move_left(x + 1, -15)", "right", "function.move_right(x + 1, 15)"),
    ],
)
def test_the_other_direction_is_the_other_function(pupil, written, chosen, becomes):
    program = "main:\n    x = 1\n    # round\n    {}\n    function.sleep(2)\nend\n"
    pupil.write("blocktext", program.format(written))
    block = pupil.blocks(f"lb_skill_{written.partition('(')[0].removeprefix('function.')}")
    block.locator("> .blocklyDropdownField").click()
    pupil.page.locator(".blocklyMenuItem", has_text=chosen).click()
    pupil.sees("blocktext", "# round", becomes, "function.sleep(2)")
    pupil.page.keyboard.press("Control+z")
    pupil.sees("blocktext", "# round", written, "function.sleep(2)")


def test_a_direction_that_the_text_turns_round_keeps_its_function(pupil):
    pupil.write("blocktext", "main:\n    function.turn_left(23)\nend\n")
    turn = pupil.blocks("lb_skill_turn_left")
    expect(turn.locator("> .blocklyDropdownField")).to_have_text(re.compile("right"))
    pupil.sees("blocktext", "function.turn_left(23)")


def test_a_menu_has_the_sign_of_a_number(pupil):
    pupil.write("blocktext", "main:\n    function.turn(-90)\nend\n")
    turn = pupil.blocks("lb_skill_turn")
    direction = turn.locator("> .blocklyDropdownField")
    number = turn.locator(".lb_angle .blocklyText")
    expect(direction).to_have_text(re.compile("left"))
    expect(number).to_have_text("90")
    direction.click()
    pupil.page.locator(".blocklyMenuItem", has_text="right").click()
    pupil.sees("blocktext", "function.turn(90)")
    expect(direction).to_have_text(re.compile("right"))
    expect(number).to_have_text("90")


@pytest.mark.parametrize(
    ("before", "typed", "after"), [(-90, "45", -45), (90, "-45", -45), (-90, "0.5", -0.5)]
)
def test_a_typed_number_keeps_its_direction_unless_it_has_a_sign(pupil, before, typed, after):
    pupil.write("blocktext", f"main:\n    function.move_straight({before})\nend\n")
    number = pupil.blocks("lb_skill_move_straight").locator(".blocklyNumberField")
    expect(number).to_have_text("90")
    number.click()
    pupil.page.keyboard.type(typed)
    pupil.page.keyboard.press("Enter")
    pupil.sees("blocktext", f"function.move_straight({after})")
    expect(number).to_have_text(typed.removeprefix("-"))


def test_beside_a_calculated_number_the_direction_is_a_word(pupil):
    pupil.write("blocktext", "main:\n    x = -90\n    function.turn(x)\nend\n")
    word = pupil.blocks("lb_skill_turn").locator("> .blocklyDropdownField")
    expect(word).to_contain_text("right")
    word.click()
    expect(pupil.page.locator(".blocklyMenuItem")).to_have_count(0)
    pupil.write("blocktext", "main:\n    x = -90\n    function.turn(-9)\nend\n")
    expect(word).to_contain_text("left")


def test_what_only_says_the_usual_is_behind_dots_until_it_differs(pupil):
    pupil.write("blocktext", "main:\n    function.drive_distance(200, 80)\nend\n")
    drive = pupil.blocks("lb_skill_drive_distance")
    numbers = drive.locator(".math_number").filter(visible=True)
    expect(numbers).to_have_text(["200"])
    drive.get_by_role("button", name="Show more values").click()
    expect(numbers).to_have_text(["200", "80"])
    pupil.sees("blocktext", "function.drive_distance(200, 80)")
    pupil.write("blocktext", "main:\n    function.drive_distance(9, 70)\nend\n")
    expect(numbers).to_have_text(["9", "70"])


def test_a_unit_is_in_the_singular_beside_a_one(pupil):
    pupil.write("blocktext", "main:\n    function.sleep(1)\nend\n")
    wait = pupil.blocks("lb_skill_sleep")
    words = wait.locator("> .blocklyLabelField")
    expect(words).to_have_text(["wait", "second"])
    wait.locator(".blocklyNumberField").click()
    pupil.page.keyboard.type("2")
    pupil.page.keyboard.press("Enter")
    expect(words).to_have_text(["wait", "seconds"])


def test_a_yes_or_no_of_a_block_is_a_box_to_tick(pupil):
    pupil.write("blocktext", "main:\n    function.led(True)\nend\n")
    pupil.blocks("lb_skill_led").locator("> .lb_truth .blocklyCheckboxField").click()
    pupil.sees("blocktext", "function.led(False)")


def menu_of(pupil, kind):
    """The menu in a block."""
    return pupil.blocks(kind).locator(".lb_choice").first
