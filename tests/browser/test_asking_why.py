"""Asking why: by mouse and by keyboard, on whatever the page shows of a run."""

import re

import pytest
from playwright.sync_api import expect

from browser.test_looking_back import look, moment

#: It counts, prints and smiles, and drives into a wall.
DRIVING = """\
count = 0
main:
    function.expressJoy()
    repeat 3:
        count += 1
        function.move_straight(60)
        function.sleep(1)
        print("round", count)
    end
    if function.is_front_obstacle(20):
        function.turn(90)
    end
    function.stop_bot()
end
"""


@pytest.fixture
def pupil(sit_down, server):
    """A pupil whose program has run, and has missed its goal."""
    return after_a_run(sit_down(server, empty=True, flat=True))


@pytest.fixture
def onlooker(sit_down, server):
    """The same, with the picture of the world."""
    return after_a_run(sit_down(server, empty=True))


def after_a_run(pupil):
    pupil.choose("World", "Square")
    pupil.choose("Speed", "Fastest")
    pupil.write("blocktext", DRIVING)
    pupil.wait_until_saved()
    pupil.run_to_the_end()
    expect(moment(pupil)).to_be_visible()
    return pupil


def robot(pupil):
    """The place of the robot on the page: the cursor says that one can ask about it."""
    canvas = pupil.page.locator(".world-view canvas")
    box = canvas.bounding_box()
    for down in range(60, int(box["height"]), 15):
        for right in range(10, int(box["width"]), 15):
            pupil.page.mouse.move(box["x"] + right, box["y"] + down)
            if canvas.evaluate("canvas => canvas.style.cursor") == "help":
                return box["x"] + right + 4, box["y"] + down + 4
    raise AssertionError("there is no robot")


def expect_answer(pupil, question, *sentences):
    """Wait until the tab shows this question and an answer with these words."""
    expect(pupil.page.get_by_role("tab", name="Why?")).to_have_attribute("aria-selected", "true")
    expect(pupil.page.locator(".why h3").first).to_have_text(question)
    for sentence in sentences:
        expect(pupil.page.locator(".why-answer")).to_contain_text(sentence)


def test_a_missed_goal_offers_the_question_on_the_world(pupil):
    chip = pupil.page.get_by_role("button", name="Goal not reached. Why?")
    pupil.picture("goal-chip")
    chip.press("Enter")
    expect_answer(pupil, re.compile("^Why was the goal .* not reached"), "was not reached")
    pupil.picture("goal")


def test_the_chip_of_a_goal_asks_about_it(pupil):
    pupil.page.locator("button.chip.goals").click()
    expect_answer(pupil, re.compile("^Why was the goal .* not reached"))


def test_the_robot_is_asked_about_the_moment_that_is_shown(onlooker):
    look(onlooker, 1.5)
    onlooker.page.locator(".world-view").press("y")
    expect_answer(onlooker, "What was the robot doing at 1.5 s?", "move_straight(60)")
    onlooker.picture("robot")
    others = onlooker.page.get_by_role("heading", name="Other questions about this moment")
    expect(others).to_be_visible()
    onlooker.page.get_by_role("button", name="Why did the robot not stand still at 1.5 s?").click()
    expect_answer(onlooker, "Why did the robot not stand still at 1.5 s?")


def test_the_question_about_the_robot_is_in_a_menu_and_on_the_world(onlooker):
    look(onlooker, 0.5)
    onlooker.page.get_by_role("button", name="Why? Why is the robot doing this?").click()
    expect_answer(onlooker, "What was the robot doing at 0.5 s?")
    look(onlooker, 2.5)
    onlooker.command("View and robot", "Why is the robot doing this?")
    expect_answer(onlooker, "What was the robot doing at 2.5 s?")


def test_a_click_on_the_robot_asks_about_it(onlooker):
    look(onlooker, 1.5)
    onlooker.page.locator(".world-view").press("t")
    x, y = robot(onlooker)
    onlooker.page.mouse.click(x, y, button="right")
    expect_answer(onlooker, "What was the robot doing at 1.5 s?")
    onlooker.tab("Console")
    onlooker.page.mouse.click(x, y)
    expect_answer(onlooker, "What was the robot doing at 1.5 s?")


def test_a_variable_is_asked_about(pupil):
    look(pupil, 1.5)
    variables = pupil.tab("Variables")
    variables.get_by_role("button", name="count", exact=True).press("Enter")
    expect_answer(pupil, "Why does count have this value at 1.5 s?", "count was 2")


def test_a_printed_line_is_asked_about_by_mouse(pupil):
    pupil.tab("Console")
    pupil.page.locator(".printed", has_text="round 2").hover()
    pupil.picture("printed")
    pupil.page.get_by_role("button", name="Why was this printed?").click()
    expect_answer(pupil, 'Why was "round 2" printed at 2 s?', "turn 2 of the loop")


def test_a_printed_line_is_asked_about_by_keyboard(pupil):
    pupil.tab("Console")
    pupil.page.locator(".console-lines").focus()
    pupil.press_keys("ArrowUp", 3)
    pupil.press_keys("Enter", 1)
    expect_answer(pupil, 'Why was "round 1" printed at 1 s?', "turn 1 of the loop")


def test_a_mark_of_the_timeline_is_asked_about_by_mouse(pupil):
    pupil.page.locator(".timeline-mark.emotion").click()
    expect_answer(pupil, "Why did the robot show joy at 0 s?", "expressJoy()")


def test_a_mark_of_the_timeline_is_asked_about_by_keyboard(pupil):
    look(pupil, 1.5)
    pupil.press("Back to the mark before")
    expect(moment(pupil)).to_have_attribute("aria-valuetext", re.compile("^1.00 s"))
    pupil.page.get_by_role("button", name="Why? Why is the robot doing this?").press("Enter")
    expect_answer(pupil, 'Why was "round 1" printed at 1 s?')


def test_a_line_is_asked_about_by_keyboard(pupil):
    pupil.put_cursor("blocktext", "function.turn")
    pupil.press_keys("Alt+y", 1)
    expect_answer(pupil, re.compile(r"^Why did line \d+ not run"), "20 mm")
    pupil.picture("line")
