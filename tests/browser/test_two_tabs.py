"""Two tabs of one project, edited at the same time."""

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.certain

PROGRAM = """\
main:
    function.sleep(1)
    function.turn_right()
    function.sleep(2)
end
"""
VIEWS = ("blocktext", "python")
DIGITS = "1234567890"
#: A page sends an edit with one of its next frames.
SOME_FRAMES = """async () => {
    for (let frame = 0; frame < 3; frame++) {
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    }
}"""


@pytest.fixture
def tabs(sit_down, server):
    """Two tabs that show the same program in all views."""
    pupil = sit_down(server, empty=True, flat=True)
    first, second = pupil.page, pupil.open(pupil.page.url)
    pupil.write("blocktext", PROGRAM)
    for pupil.page in (second, first):
        pupil.show("Blocks", "Block-Text", "Python")
        pupil.sees("python", "sleep(2)")
        expect(pupil.blocks("lb_skill_sleep")).to_have_count(2)
    return first, second


def test_typing_in_the_same_text_in_both_tabs_ends_with_the_same_program(pupil, tabs):
    put_cursors(pupil, tabs, ("blocktext", ")", 0), ("blocktext", ")", 2))
    type_at_once(tabs)
    check_same_program(pupil, tabs)
    pupil.picture("same-text")


def test_typing_in_different_texts_in_both_tabs_ends_with_the_same_program(pupil, tabs):
    put_cursors(pupil, tabs, ("blocktext", ")", 0), ("python", ")", 3))
    type_at_once(tabs)
    check_same_program(pupil, tabs)


def test_dragging_a_block_during_typing_in_another_tab_ends_with_the_same_program(pupil, tabs):
    dragging, typing = tabs
    put_cursors(pupil, tabs, ("blocktext", ")", 0), ("blocktext", ")", 2))
    pupil.page = dragging
    ground = pupil.page.locator(".blocklyMainBackground").first.bounding_box()
    free = ground["x"] + 0.7 * ground["width"], ground["y"] + 0.7 * ground["height"]
    with pupil.dragging(pupil.blocks("lb_skill_turn_right"), free):
        typing.keyboard.type(DIGITS[:5])
    typing.keyboard.type(DIGITS[5:])
    check_same_program(pupil, tabs)
    pupil.picture("dragged")


def put_cursors(pupil, tabs, *places):
    """Put the cursor of each tab before a word of a text."""
    for pupil.page, place in zip(tabs, places, strict=True):
        pupil.put_cursor(*place)


def type_at_once(tabs):
    """Type digits in the tabs alternately, each while the previous one is being sent."""
    for digit in DIGITS:
        for page in tabs:
            page.keyboard.press(digit)


def check_same_program(pupil, tabs):
    """Check that every edit is saved, and both tabs show the same as a new one."""
    for pupil.page in tabs:
        pupil.page.evaluate(SOME_FRAMES)
        pupil.wait_until_saved()
    pupil.page = pupil.open(pupil.page.url)
    pupil.sees("python", "robot.sleep(1")
    expect(pupil.blocks("lb_main")).to_have_count(1)
    texts, blocks = {view: pupil.reads(view) for view in VIEWS}, sorted(pupil.block_ids())
    for pupil.page in tabs:
        for view, lines in texts.items():
            expect(pupil.lines(view)).to_have_text(lines)
        expect(pupil.all_blocks()).to_have_count(len(blocks))
        assert sorted(pupil.block_ids()) == blocks
