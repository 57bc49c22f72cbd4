"""One program in three views: an edit in one appears in the others."""

from datetime import UTC, datetime, timedelta

import pytest
from playwright.sync_api import expect

from places import ROOT, TESTS

CASES = TESTS / "cases"
STATES = ROOT / "examples" / "line-states.bt"
ALL = ("Blocks", "Block-Text", "Python")
#: A function, a global variable, and a `when` that another one starts.
NAMES = """\
count = 0

def step_on(x):
    function.sleep(x)
end

when start:
    count = 1
    step_on(count)
    activate turning
end

when turning:
    count += 1
    if time_turning > 2:
        deactivate turning
    end
end
"""


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with an empty program in all three views on a wide screen."""
    pupil = sit_down(server, viewport={"width": 1800, "height": 900}, empty=True, flat=True)
    pupil.show(*ALL)
    return pupil


@pytest.mark.parametrize(
    ("robot", "half", "sensor"),
    [("EBO", "ebo", "is_center_black_line"), ("Thymio II", "thymio", "is_center_ground_line")],
)
def test_figure_9_typed_as_in_the_paper_appears_in_blocks_and_python_and_finds_the_line(
    pupil, robot, half, sensor
):
    case = CASES / f"line_follower_{half}"
    pupil.choose("Robot", robot)
    pupil.choose("World", "Line")
    pupil.write("blocktext", (case / "program.bt").read_text())
    pupil.sees("python", f"if robot.{sensor}():", "robot.slow_down()")
    expect(pupil.blocks(f"lb_skill_{sensor}")).to_have_count(1)
    pupil.choose("Speed", "10×")
    pupil.press("Run")
    expect(pupil.page.locator(".lbRunning")).not_to_have_count(0)
    pupil.picture("drives")
    pupil.press("Stop")
    pupil.state("Ended")
    assert pupil.foreign == []


def test_the_states_of_whens_are_shown_while_they_change(pupil):
    pupil.choose("World", "Line")
    pupil.write("blocktext", STATES.read_text())
    expect(pupil.blocks("lb_when")).to_have_count(3)
    pupil.sees("python", "@robot.when_start", "def lost():")
    shown = pupil.tab("Variables")
    pupil.choose("Speed", "10×")
    pupil.press("Run")
    on_line = shown.locator("tr[data-name=on_line]")
    expect(on_line).to_contain_text("● active")
    expect(shown.locator("tr[data-name=lost]")).to_contain_text("○ waiting")
    pupil.picture("whens")
    pupil.press("Stop")
    pupil.state("Ended")
    assert pupil.foreign == []


# Edits in one view.


LONG = "main:\n" + "    function.move_straight()\n    function.sleep(5)\n" * 30 + "end\n"


def test_a_number_changed_in_python_changes_in_blocks_and_block_text_and_nothing_else(pupil):
    pupil.write("blocktext", LONG)
    pupil.sees("python", "robot.sleep(5)")
    before = pupil.places_of_blocks()
    pupil.put_cursor("python", "5)", 24)
    pupil.press_keys("ArrowUp", 10)
    pupil.page.keyboard.press("Delete")
    scrolled = pupil.scrolled("python")
    pupil.page.keyboard.type("77")
    expect(pupil.blocks("lb_skill_sleep").nth(19)).to_contain_text("77")
    pupil.expect_cursor("python", 45, "robot.sleep(77")
    assert pupil.scrolled("python") == scrolled > 0
    pupil.page.keyboard.press("Alt+Enter")
    expect(pupil.blocks("lb_skill_sleep").nth(19)).to_be_in_viewport()
    pupil.picture("changed")
    assert pupil.places_of_blocks() == before


def test_a_statement_typed_in_python_appears_as_a_block_in_its_position(pupil):
    pupil.write("blocktext", "main:\n    function.move_straight()\n    function.sleep(5)\nend\n")
    pupil.sees("python", "robot.sleep(5)")
    before = pupil.block_ids()
    pupil.put_cursor("python", "robot.sleep")
    pupil.page.keyboard.type("robot.stop_bot()\n")
    pupil.sees("blocktext", "function.stop_bot()")
    expect(pupil.blocks("lb_skill_stop_bot")).to_have_count(1)
    pupil.picture("inserted")
    assert [one for one in pupil.block_ids() if one in before] == before
    pupil.expect_cursor("python", pupil.line_of("python", "robot.sleep"), "")
    assert pupil.foreign == []


def test_python_without_matching_blocks_is_kept_as_a_block_with_its_text(pupil):
    pupil.write("blocktext", "main:\n    function.move_straight()\nend\n")
    pupil.sees("python", "robot.move_straight()")
    pupil.put_cursor("python", "robot.move")
    by_hand = '# forward, and not back\nspeeds = b"10 20"\n'
    pupil.page.keyboard.insert_text(by_hand)
    expect(pupil.blocks("lb_python_value")).to_have_count(1)
    pupil.picture("grey")
    pupil.put_cursor("blocktext", "move_straight()")
    pupil.page.keyboard.insert_text("reset_orientation()\n    function.")
    pupil.sees("python", "robot.reset_orientation()")
    assert by_hand in pupil.text("python")
    assert pupil.foreign == []


# Help while typing.


@pytest.mark.parametrize(
    ("view", "typed", "offered"),
    [
        ("blocktext", "function.move_st", "move_straight"),
        ("python", "robot.move_st", "move_straight"),
    ],
)
def test_a_completion_is_suggested_and_inserted_by_enter(pupil, view, typed, offered):
    pupil.write("blocktext", "main:\n    function.stop_bot()\nend\n")
    pupil.sees("python", "robot.stop_bot()")
    pupil.put_cursor(view, "function.stop" if view == "blocktext" else "robot.stop")
    pupil.page.keyboard.type(typed)
    # Until the newest answer has come, Enter begins a new line.
    usable = pupil.page.locator(".cm-tooltip-autocomplete:not(.cm-tooltip-autocomplete-disabled)")
    expect(usable.locator("li[aria-selected]")).to_contain_text(offered)
    pupil.picture("offered")
    # For 75 ms after they appear, by the page's clock, Enter still begins a new line.
    pupil.page.clock.set_fixed_time(datetime.now(UTC) + timedelta(seconds=1))
    pupil.page.keyboard.press("Enter")
    pupil.sees(view, f"{typed}raight")


def test_the_word_at_the_cursor_is_explained_and_f12_goes_to_its_definition(pupil):
    pupil.write("blocktext", NAMES)
    pupil.sees("python", "step_on(count)")
    pupil.put_cursor("blocktext", "sleep")
    pupil.page.keyboard.press("Control+i")
    expect(pupil.page.locator(".text-help-title")).to_contain_text("sleep")
    pupil.picture("explained")
    pupil.put_cursor("blocktext", "step_on(count)")
    pupil.page.keyboard.press("F12")
    pupil.expect_cursor("blocktext", 3, "def ")
    pupil.put_cursor("python", "step_on(count)")
    pupil.page.keyboard.press("F12")
    pupil.expect_cursor("python", pupil.line_of("python", "def step_on"), "def ")
    pupil.editor("python").get_by_text("sleep", exact=True).hover()
    expect(pupil.page.locator(".cm-tooltip-hover .text-help-title")).to_contain_text("sleep")
    assert pupil.foreign == []


@pytest.mark.parametrize(
    ("language", "robot", "served"),
    [
        ("en", "Thymio II", "On this robot: the sensors under it"),
        ("en", "EBO", "On this robot: the camera"),
        ("es", "Thymio II", "En este robot: los sensores de debajo"),
    ],
)
def test_help_says_what_serves_a_sense_on_the_chosen_robot(
    own_server, sit_down, language, robot, served
):
    pupil = sit_down(own_server, empty=True, language=language)
    pupil.write("blocktext", "main:\n    x = function.is_center_black_line()\nend\n")
    pupil.choose("Robot", robot)
    pupil.put_cursor("blocktext", "black_line")
    pupil.page.keyboard.press("Control+i")
    expect(pupil.page.locator(".text-help-serves")).to_have_text(served)
    pupil.picture(f"{language}-{robot}")


@pytest.mark.parametrize(
    ("view", "word", "new", "seen"),
    [
        ("blocktext", "count = 1", "steps", {"blocktext": "steps += 1", "python": "steps += 1"}),
        ("python", "step_on(c", "shine", {"blocktext": "def shine(x):", "python": "def shine(x):"}),
        (
            "blocktext",
            "turning:",
            "spin",
            {"blocktext": "if time_spin > 2", "python": "def spin():"},
        ),
    ],
    ids=["variable", "function", "when"],
)
def test_a_rename_changes_all_views_and_one_undo_reverts_it(pupil, view, word, new, seen):
    pupil.write("blocktext", NAMES)
    pupil.sees("python", "turning.deactivate()")
    before = {one: pupil.text(one) for one in ("blocktext", "python")}
    pupil.put_cursor(view, word)
    pupil.page.keyboard.press("F2")
    field = pupil.page.locator(".text-rename input")
    field.fill(new)
    pupil.picture("asked")
    field.press("Enter")
    for one, line in seen.items():
        pupil.sees(one, line)
    expect(pupil.all_blocks().filter(has_text=new)).not_to_have_count(0)
    pupil.picture("renamed")
    pupil.press("Undo")
    pupil.sees("blocktext", before["blocktext"].split("\n")[0])
    expect(pupil.all_blocks().filter(has_text=new)).to_have_count(0)
    assert {one: pupil.text(one) for one in before} == before
    assert pupil.foreign == []


def test_undo_and_redo_follow_the_order_of_edits_in_all_views(pupil):
    pupil.write("blocktext", "main:\n    function.move_straight()\n    function.sleep(5)\nend\n")
    pupil.sees("python", "robot.sleep(5)")
    pupil.select_block(pupil.blocks("lb_skill_move_straight"))
    pupil.page.keyboard.press("Delete")
    pupil.lacks("blocktext", "move_straight")
    pupil.put_cursor("python", "robot.sleep")
    pupil.page.keyboard.insert_text("robot.stop_bot()\n")
    expect(pupil.blocks("lb_skill_stop_bot")).to_have_count(1)
    pupil.press("Undo")
    expect(pupil.blocks("lb_skill_stop_bot")).to_have_count(0)
    pupil.lacks("blocktext", "stop_bot")
    pupil.press("Undo")
    expect(pupil.blocks("lb_skill_move_straight")).to_have_count(1)
    pupil.sees("python", "robot.move_straight()")
    pupil.press("Redo")
    expect(pupil.blocks("lb_skill_move_straight")).to_have_count(0)
    pupil.lacks("python", "move_straight")
    pupil.picture("redone")
    assert pupil.foreign == []


def test_a_block_that_is_cut_is_pasted_into_each_text(pupil):
    pupil.context.grant_permissions(["clipboard-read", "clipboard-write"])
    pupil.write("blocktext", "main:\n    function.move_straight()\n    function.sleep(5)\nend\n")
    pupil.sees("python", "robot.sleep(5)")
    pupil.select_block(pupil.blocks("lb_skill_move_straight"))
    pupil.page.keyboard.press("Control+x")
    pupil.lacks("python", "move_straight")
    pupil.put_cursor("python", "robot.sleep")
    pupil.page.keyboard.press("Control+v")
    expect(pupil.blocks("lb_skill_move_straight")).to_have_count(1)
    pupil.put_cursor("blocktext", "end")
    pupil.page.keyboard.press("Control+v")
    expect(pupil.blocks("lb_skill_move_straight")).to_have_count(2)
    pupil.sees("python", "robot.move_straight()")
