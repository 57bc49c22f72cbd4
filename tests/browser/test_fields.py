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
    return sit_down(server, viewport={"width": 1600, "height": 900}, empty=True)


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


def menu_of(pupil, kind):
    """The menu in a block."""
    return pupil.blocks(kind).locator(".lb_choice").first
