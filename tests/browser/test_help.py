"""The help: of one block, and the search over blocks, lessons and docs."""

import re

from playwright.sync_api import expect


def test_the_help_searches_and_explains_a_block_with_its_example(sit_down, server):
    pupil = sit_down(server, empty=True, flat=True)
    pupil.command("Settings and help", "Help")
    dialog = pupil.dialog()
    expect(dialog.get_by_role("searchbox")).to_be_focused()
    # A word of Scratch, in any place of the keyboard's focus: no letter is a shortcut.
    pupil.page.keyboard.type("repeat")
    times = dialog.get_by_role("button", name="repeat 10 times")
    expect(times).to_be_visible()
    pupil.picture("search")
    for _ in range(2):
        pupil.page.keyboard.press("ArrowDown")
    expect(times).to_be_focused()
    pupil.page.keyboard.press("Enter")
    expect(dialog.locator(".lbSentence .controls_repeat_ext")).to_be_visible()
    expect(dialog).to_contain_text("Scratch: repeat (10)")
    expect(dialog.locator(".lbMoving .robot")).to_be_visible()
    expect(dialog.locator(".lbMoving .lbRunning")).to_have_count(1)
    pupil.picture("block")
    pupil.page.keyboard.press("Escape")
    expect(dialog.get_by_role("searchbox")).to_be_focused()


def test_f1_on_a_block_shows_its_example_beside_the_program_in_its_colours(sit_down, server):
    pupil = sit_down(server, theme="system", empty=True, flat=True)
    pupil.write("blocktext", "main:\n    function.turn(90)\nend\n")
    pupil.select_block(pupil.blocks("lb_skill_turn"))
    pupil.page.keyboard.press("F1")
    panel = pupil.page.locator(".lbHelp")
    expect(panel.locator(".lbSentence .lb_skill_turn")).to_be_visible()
    expect(panel.locator(".lbMoving .robot")).to_be_visible()
    pupil.picture("panel")
    pupil.page.emulate_media(color_scheme="dark")
    for picture in (".lbSentence", ".lbMoving"):
        drawn = panel.locator(f"{picture} .injectionDiv")
        expect(drawn).to_have_class(re.compile("learnblock-dark-theme"))
