"""Errors are shown where they are, and the last working program stays visible."""

import pytest
from playwright.sync_api import expect

GOOD = "main:\n    x = 3\n    while x > 0:\n        x -= 1\n    end\nend\n"


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with a correct program in all three views on a wide screen."""
    pupil = sit_down(server, viewport={"width": 1800, "height": 900}, empty=True, flat=True)
    pupil.show("Blocks", "Block-Text", "Python")
    pupil.write("blocktext", GOOD)
    pupil.sees("python", "while x > 0:")
    return pupil


@pytest.mark.parametrize(
    ("view", "name", "line"), [("blocktext", "Block-Text", 3), ("python", "Python", 7)]
)
def test_an_invalid_line_is_underlined_and_listed_and_the_other_views_wait_for_its_correction(
    pupil, view, name, line
):
    pupil.put_cursor(view, "while")
    pupil.press_keys("Delete", len("while"))
    pupil.page.keyboard.type("whle")
    note = pupil.page.locator(".stale-note")
    expect(note).to_contain_text(f"{name} has an error on line {line}")
    expect(pupil.editor(view).locator(".cm-lintRange-error")).not_to_have_count(0)
    for other in {"blocks", "blocktext", "python"} - {view}:
        expect(pupil.page.locator(f"[data-region={other}] .stale")).to_be_visible()
    expect(pupil.page.locator(f"[data-region={view}] .stale")).to_have_count(0)
    expect(pupil.blocks("controls_whileUntil")).to_have_count(1)
    problem = pupil.tab("Problems").locator(".problem.error")
    pupil.picture("wrong")
    pupil.put_cursor(view, "end" if view == "blocktext" else "from")
    problem.click()
    pupil.expect_cursor_in(view, line)
    pupil.put_cursor(view, "whle")
    pupil.press_keys("Delete", len("whle"))
    pupil.page.keyboard.type("while not")
    expect(note).to_have_count(0)
    expect(problem).to_have_count(0)
    pupil.sees("python", "while not x > 0:")
    pupil.sees("blocktext", "while not x > 0:")
    expect(pupil.blocks("logic_negate")).to_have_count(1)
    assert pupil.foreign == []


def test_a_block_with_an_empty_input_is_marked_until_that_is_undone(pupil):
    first = pupil.blocks("variables_set").first.get_attribute("data-id")
    pupil.put_below(pupil.take("Control", "controls_forEach"), first)
    expect(pupil.page.locator(".blocks .lbError")).not_to_have_count(0)
    expect(pupil.page.locator(".stale-note")).to_be_visible()
    expect(pupil.tab("Problems").locator(".problem.error")).not_to_have_count(0)
    pupil.picture("hole")
    pupil.press("Undo")
    expect(pupil.page.locator(".stale-note")).to_have_count(0)
    expect(pupil.page.locator(".blocks .lbError")).to_have_count(0)
    assert pupil.foreign == []


def test_an_empty_if_is_marked_once_it_is_to_run_and_the_program_runs(pupil):
    first = pupil.blocks("variables_set").first.get_attribute("data-id")
    pupil.put_below(pupil.take("Control", "controls_if"), first)
    pupil.sees("blocktext", "if False:")
    expect(pupil.page.locator(".blocks .lbWarning")).to_have_count(0)
    pupil.press("Run")
    expect(pupil.page.locator(".blocks .lbWarning")).to_have_count(1)
    expect(pupil.tab("Problems").locator(".problem.warning")).to_contain_text(
        "A condition is missing"
    )
    pupil.picture("empty-if")
    pupil.state("Ended")
    assert pupil.foreign == []


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ("print(1 / x)", "A number was divided by 0"),
        ("print(late[0])", "'late' has no value yet"),
    ],
    ids=["division by zero", "a name without a value"],
)
def test_a_runtime_error_is_shown_at_its_block_and_its_lines(pupil, wrong, said):
    never = "    if x > 5:\n        late = [1]\n    end\n"
    pupil.write("blocktext", GOOD.removesuffix("end\n") + f"{never}    {wrong}\nend\n")
    pupil.sees("python", wrong)
    pupil.press("Run")
    pupil.state("Ended")
    expect(pupil.page.locator(".blocks .lbError")).to_have_count(1)
    expect(pupil.page.locator(".blocks .lbError")).to_contain_text("print")
    for view in ("blocktext", "python"):
        expect(pupil.editor(view).locator(".cm-lintRange-error")).to_have_text(wrong)
    problem = pupil.tab("Problems").locator(".problem.error")
    expect(problem).to_contain_text(said)
    problem.click()
    pupil.expect_cursor("blocktext", 9, "    ")
    pupil.picture("shown")
    pupil.page.keyboard.type("pass # ")
    expect(pupil.page.locator(".blocks .lbError")).to_have_count(0)
    assert pupil.foreign == []


def test_below_the_problems_stands_which_robots_can_run_the_program(pupil):
    robots = pupil.tab("Problems").locator(".runs-on")
    expect(robots.locator("li.runs").filter(has_text="EBO").first).to_be_visible()
    pupil.write("blocktext", "main:\n    x = function.is_left_obstacle()\nend\n")
    refused = robots.locator("li.refused").filter(has_text="EV3").first
    expect(refused).to_contain_text("has no distance sensor on the left")
    served = robots.locator("li.runs").filter(has_text="EBO").first
    expect(served).to_contain_text("runs, with the distance sensors on the left")
    expect(pupil.page.locator(".toast")).to_have_count(0)
    pupil.picture("runs-on")


def test_a_button_adds_a_robot_to_a_pasted_program_that_uses_one(sit_down, server):
    pupil = sit_down(server, viewport={"width": 1800, "height": 900}, empty=True, flat=True)
    pupil.show("Blocks", "Block-Text", "Python")
    pupil.write("python", "import math\n\n\nrobot.turn(math.degrees(1))\n")
    offer = pupil.tab("Problems").get_by_role("button", name="Add a robot")
    expect(offer).to_be_visible()
    expect(pupil.tab("Problems").locator(".problem.error")).to_have_count(1)
    pupil.picture("no-robot")
    offer.click()
    expect(pupil.tab("Problems")).to_contain_text("No problems. The program is ready to run.")
    pupil.sees("python", "robot = Robot()")
    expect(offer).to_have_count(0)
    pupil.press("Undo")
    expect(offer).to_be_visible()
