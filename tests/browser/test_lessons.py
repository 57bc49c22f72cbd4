"""Lessons from the start page to the stars: by mouse, by keyboard and by touch."""

import re

import pytest
from playwright.sync_api import expect

import small_lesson
from browser.pupil import LONGEST_RUN
from browser.test_accessibility import faults
from browser.typist import Typist

RIGHT = ("function.expressJoy()", "function.sleep(1)", "function.stop_bot()")
#: The three statements of the drawing, without the numbers in them.
DRAWN = ".block-drawing :is(.lb_skill_move_straight, .lb_skill_sleep, .lb_skill_stop_bot)"
LOST = """() => [...document.querySelectorAll(".lesson-pane button, .lesson-line button")]
    .filter((one) => one.checkVisibility())
    .map((one) => one.getBoundingClientRect())
    .filter(({ left, right }) => left < -1 || right > innerWidth + 1).length"""


@pytest.fixture
def pupil(own_server, sit_down):
    """A pupil on the start page, who sees the output of programs."""
    small_lesson.put_in(own_server.home)
    pupil = sit_down(own_server, flat=True)
    pupil.page.close()
    pupil.page = pupil.open_start()
    pupil.page.get_by_role("button", name="1 · First drive").click()
    return pupil


def panel(pupil):
    """The lesson beside the program."""
    return pupil.page.locator("[data-region=lesson]")


def own_card(pupil):
    """The card of our own lesson on the start page; all others are longer."""
    return pupil.page.locator(".lesson-card", has_text="10 min")


def card(pupil, title="First drive"):
    """What opens our own lesson on the start page."""
    return own_card(pupil).get_by_role("button", name=title).first


def begin(pupil):
    """Open the lesson with a click."""
    card(pupil).click()
    pupil.expect_project("First drive")
    expect(panel(pupil)).to_contain_text("What happens?")


def expect_stars(pupil, earned, stars):
    """Wait until the step has so many stars."""
    shown = panel(pupil).locator(".lesson-stars").first
    expect(shown).to_have_attribute("aria-label", re.compile(f"^{earned} of {stars} star"))


def goal(pupil, text):
    """A goal of the step."""
    return pupil.page.locator(".lesson-goal", has_text=text)


def write(pupil, text):
    """Replace the program."""
    pupil.show("Block-Text")
    pupil.write("blocktext", text)
    pupil.wait_until_saved()


def test_two_browsers_play_the_same_lesson_in_projects_of_their_own(pupil, own_server, sit_down):
    begin(pupil)
    panel(pupil).get_by_label("Forward").check()
    panel(pupil).get_by_role("button", name="Check", exact=True).click()
    expect_stars(pupil, 1, 1)
    other = sit_down(own_server, flat=True)
    other.page.close()
    other.page = other.open_start()
    other.page.get_by_role("button", name="1 · First drive").click()
    expect(own_card(other)).to_contain_text("0/5")
    card(other).click()
    other.expect_project("First drive 2")
    expect_stars(other, 0, 1)
    pupil.page.close()
    pupil.page = pupil.open_start()
    pupil.page.get_by_role("button", name="1 · First drive").click()
    expect(own_card(pupil)).to_contain_text("1/5")
    card(pupil).click()
    pupil.expect_project("First drive")
    expect_stars(pupil, 1, 1)


def test_a_lesson_is_played_by_mouse_from_the_first_step_to_the_last_star(pupil):
    begin(pupil)
    expect(panel(pupil)).to_contain_text("<b>no HTML</b>")
    expect(panel(pupil).locator(DRAWN)).to_have_count(3)
    panel(pupil).get_by_role("radio", name="Backward").check()
    panel(pupil).get_by_role("button", name="Check", exact=True).click()
    expect(panel(pupil)).to_contain_text("A negative speed would do that.")
    panel(pupil).get_by_role("radio", name="Forward").check()
    panel(pupil).get_by_role("button", name="Check", exact=True).click()
    expect(panel(pupil)).to_contain_text("Right!")
    expect_stars(pupil, 1, 1)
    panel(pupil).get_by_role("button", name="Next").click()
    expect(panel(pupil)).to_contain_text("Drive 100 mm")
    pupil.choose("Speed", "Fastest")
    pupil.run_to_the_end()
    expect(goal(pupil, "Drive at least")).to_have_class(re.compile("failed"))
    expect(panel(pupil)).to_contain_text("ask for a hint")
    goal(pupil, "Drive at least").get_by_role("button", name="Why?").click()
    expect(pupil.page.locator(".why h3").first).to_contain_text("What was the robot doing at")
    expect(goal(pupil, "The program runs").get_by_role("button", name="Why?")).to_have_count(0)
    pupil.picture("why")
    panel(pupil).get_by_role("button", name="A hint?").click()
    expect(panel(pupil)).to_contain_text("Look at the number in the wait block.")
    panel(pupil).get_by_role("button", name="A hint?").click()
    expect(panel(pupil)).to_contain_text("The wait is too short.")
    write(pupil, small_lesson.SOLUTION)
    pupil.run_to_the_end()
    expect(goal(pupil, "Drive at least")).to_have_class(re.compile("met"))
    panel(pupil).get_by_role("button", name="Check everywhere").click()
    expect(panel(pupil)).to_contain_text("4 of 4 passed", timeout=LONGEST_RUN)
    expect_stars(pupil, 3, 3)
    panel(pupil).get_by_role("button", name="Next").click()
    for piece in RIGHT:
        panel(pupil).get_by_role("button", name=f"Add {piece}").click()
    panel(pupil).get_by_role("button", name="Check", exact=True).click()
    expect_stars(pupil, 1, 1)
    panel(pupil).get_by_role("button", name="Finish").click()
    expect(pupil.page.locator(".lesson-card", has_text="Step 3 of 3")).to_contain_text("5/5")


def test_a_lesson_is_played_by_keyboard(pupil):
    keys = Typist(pupil)
    expect(card(pupil)).to_be_visible()
    card(pupil).focus()
    keys.press("Enter")
    expect(panel(pupil)).to_contain_text("What happens?")
    pupil.page.locator("#lesson-body").focus()
    keys.walk("Tab", "^Forward")
    keys.press("Space")
    keys.walk("Tab", "^Check")
    keys.press("Enter")
    expect_stars(pupil, 1, 1)
    for step in ("Drive 100 mm", "Put it in order"):
        keys.walk("Tab", "^Next")
        keys.press("Enter")
        expect(panel(pupil)).to_contain_text(step)
    pupil.page.locator("#lesson-body").focus()
    # One after the other, in the wrong order: then the last one is moved up.
    for piece in (RIGHT[0], RIGHT[2], RIGHT[1]):
        panel(pupil).get_by_role("button", name=f"Add {piece}").focus()
        keys.press("Enter")
    moved = panel(pupil).locator(".lesson-order li").last
    moved.get_by_role("button", name="Move up").focus()
    keys.press("Enter")
    panel(pupil).get_by_role("button", name="Check", exact=True).focus()
    keys.press("Enter")
    expect_stars(pupil, 1, 1)


def test_a_lesson_is_played_by_touch_on_a_phone(own_server, sit_down):
    small_lesson.put_in(own_server.home)
    viewport = {"width": 390, "height": 844}
    pupil = sit_down(own_server, start=True, viewport=viewport, has_touch=True)
    card(pupil).tap()
    line = pupil.page.locator(".lesson-open")
    expect(line).to_contain_text("What happens?")
    assert line.bounding_box()["height"] >= 44
    line.tap()
    sheet = pupil.dialog()
    sheet.get_by_text("Forward").tap()
    sheet.get_by_role("button", name="Check", exact=True).tap()
    expect(sheet).to_contain_text("Right!")
    sheet.get_by_role("button", name="Next").tap()
    expect(sheet).to_contain_text("Drive 100 mm")
    pupil.picture("sheet")
    assert pupil.page.evaluate(LOST) == 0
    sheet.get_by_role("button", name="Close").tap()
    expect(line).to_contain_text("Drive 100 mm")
    pupil.press("Run")
    pupil.state("Ended")
    line.tap()
    expect(goal(pupil, "Drive at least")).to_have_class(re.compile("failed"))
    expect(goal(pupil, "The program runs")).to_have_class(re.compile("met"))
    goal(pupil, "Drive at least").get_by_role("button", name="Why?").tap()
    expect(sheet).to_have_count(0)
    expect(pupil.page.locator(".why h3").first).to_contain_text("What was the robot doing at")


def test_the_pieces_of_a_puzzle_are_dragged_with_the_mouse(pupil):
    begin(pupil)
    for step in ("Drive 100 mm", "Put it in order"):
        panel(pupil).get_by_role("button", name="Next").click()
        expect(panel(pupil)).to_contain_text(step)
    expect(panel(pupil).locator(".lesson-piece .block-drawing svg")).not_to_have_count(0)
    program = panel(pupil).locator(".lesson-order")
    drag(pupil, panel(pupil).get_by_role("button", name=f"Add {RIGHT[2]}"), program)
    drag(pupil, panel(pupil).get_by_role("button", name=f"Add {RIGHT[0]}"), program, top=True)
    expect(program.locator("li")).to_have_count(2)
    panel(pupil).get_by_role("button", name=f"Add {RIGHT[1]}").click()
    last = program.locator("li").last.locator(".lesson-piece")
    drag(pupil, last, program.locator("li").nth(1), top=True)
    panel(pupil).get_by_role("button", name="Check", exact=True).click()
    expect_stars(pupil, 1, 1)


def drag(pupil, piece, target, *, top=False):
    """Drag a piece to the lower edge of something, or to its upper edge."""
    piece.scroll_into_view_if_needed()
    start, end = piece.bounding_box(), target.bounding_box()
    mouse = pupil.page.mouse
    mouse.move(start["x"] + 30, start["y"] + 10)
    mouse.down()
    y = end["y"] + 2 if top else end["y"] + end["height"] - 4
    mouse.move(end["x"] + 40, y, steps=5)
    mouse.up()


def test_stars_change_while_the_program_runs(pupil):
    begin(pupil)
    panel(pupil).get_by_role("button", name="Next").click()
    expect(panel(pupil)).to_contain_text("Drive 100 mm")
    write(pupil, small_lesson.START.replace("sleep(1)", "sleep(600)").replace("(40)", "(100)"))
    pupil.press("Run")
    pupil.state("Running")
    expect(goal(pupil, "Drive at least")).to_have_class(re.compile("met"))
    expect(goal(pupil, "The program runs")).to_have_class(re.compile("open"))
    pupil.press("Stop")
    expect(goal(pupil, "The program runs")).to_have_class(re.compile("failed"))


def test_the_variant_in_which_a_program_fails_can_be_watched(pupil):
    begin(pupil)
    panel(pupil).get_by_role("button", name="Next").click()
    expect(panel(pupil)).to_contain_text("Drive 100 mm")
    panel(pupil).get_by_role("button", name="Check everywhere").click()
    expect(panel(pupil)).to_contain_text("0 of 4 passed", timeout=LONGEST_RUN)
    panel(pupil).get_by_role("button", name=re.compile("^Watch Thymio II, variant 1")).click()
    pupil.expect_chosen("Robot", "Thymio II")
    pupil.state("Ended")


def test_a_lesson_is_found_again_where_it_was_left(pupil):
    begin(pupil)
    panel(pupil).get_by_role("button", name="Next").click()
    expect(panel(pupil)).to_contain_text("Drive 100 mm")
    pupil.page.reload()
    expect(panel(pupil)).to_contain_text("Drive 100 mm")
    expect(panel(pupil)).to_contain_text("Step 2 of 3")


@pytest.mark.parametrize("theme", ["light", "dark", "contrast"])
@pytest.mark.parametrize("width", [1366, 820, 390])
def test_a_lesson_is_accessible_in_all_themes_and_sizes(own_server, sit_down, axe, theme, width):
    small_lesson.put_in(own_server.home)
    height = {1366: 768, 820: 1180, 390: 844}[width]
    viewport = {"width": width, "height": height}
    pupil = sit_down(own_server, start=True, viewport=viewport, theme=theme)
    expect(card(pupil)).to_be_visible()
    assert faults(pupil, axe) == []
    begin(pupil)
    if width == 390:
        pupil.page.locator(".lesson-open").click()
    lesson = pupil.dialog() if width == 390 else panel(pupil)
    expect(lesson.locator(DRAWN)).to_have_count(3)
    pupil.picture(f"step-1-{width}-{theme}")
    assert faults(pupil, axe) == []
    lesson.get_by_role("button", name="Next").click()
    expect(lesson).to_contain_text("Goals")
    assert faults(pupil, axe) == []
    lesson.get_by_role("button", name="Next").click()
    expect(lesson.locator(".lesson-piece")).to_have_count(4)
    pupil.picture(f"step-3-{width}-{theme}")
    assert faults(pupil, axe) == []
