"""Whoever runs a program can hold it, look into it, change its speed, answer it and end it."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
from playwright.sync_api import expect

SQUARE = Path(__file__).parents[2] / "examples" / "square.bt"
#: Line 9 is held before; `twice` can be stepped over.
TWICE = """\
def twice(n):
    double = n * 2
    return double
end

main:
    function.move_straight()
    function.sleep(1)
    four = twice(2)
    function.stop_bot()
end
"""
ASKING = """\
main:
    name = input("Who are you?")
    print("Good day,", name)
end
"""
DRIVING = """\
main:
    function.move_straight(20)
    function.sleep(500)
end
"""


@pytest.fixture
def pupil(sit_down, server):
    """With an empty program in all three views, on a screen with room for them."""
    pupil = sit_down(server, viewport={"width": 1800, "height": 900})
    pupil.begin()
    pupil.show("Blocks", "Block-Text", "Python")
    return pupil


def test_a_pause_holds_the_world_in_the_midst_of_sleep_and_it_goes_on(pupil):
    pupil.write("blocktext", DRIVING)
    pupil.sees("python", "robot.sleep(500)")
    pupil.press("Run")
    expect(pupil.blocks("lb_skill_sleep")).to_have_class(re.compile("lbRunning"))
    pupil.press("Pause")
    pupil.state("Paused")
    held = pupil.seconds_at_rest()
    pupil.picture("paused")
    # The robot would be far by the time the page has asked and heard all of this.
    for tab in ("Variables", "Sensors", "Console"):
        pupil.tab(tab)
    assert pupil.seconds() == held
    pupil.press("Go on")
    pupil.state("Running")
    pupil.wait_until_later_than(held)
    pupil.choose("Speed", "20×")
    pupil.wait_until_later_than(held + 20)
    pupil.press("Stop")
    pupil.state("Ended")
    assert "Stopped" in pupil.tab("Result").inner_text()
    assert pupil.foreign == []


def test_a_breakpoint_beside_a_line_is_seen_on_its_block_and_holds_the_program_there(pupil):
    pupil.write("blocktext", TWICE)
    pupil.sees("python", "four = twice(2)")
    pupil.click_beside("blocktext", 9)
    expect(pupil.page.locator("[data-region=blocks] .lbBreakpoint")).to_have_count(1)
    pupil.choose("Speed", "As fast as it goes")
    pupil.press("Run")
    pupil.state("Held")
    expect(pupil.editor("blocktext").locator(".cm-held")).to_have_text("    four = twice(2)")
    expect(pupil.editor("python").locator(".cm-held")).to_have_text("four = twice(2)")
    pupil.press("Step")
    expect(pupil.editor("blocktext").locator(".cm-held")).to_have_text("    double = n * 2")
    variables = pupil.tab("Variables")
    expect(variables.locator("tr[data-name=n]")).to_contain_text("2")
    pupil.press("Step")
    expect(variables.locator("tr[data-name=double]")).to_contain_text("4")
    pupil.picture("within")
    pupil.press("Run from the beginning")
    expect(pupil.editor("blocktext").locator(".cm-held")).to_have_text("    four = twice(2)")
    pupil.press("Step over functions")
    expect(pupil.editor("blocktext").locator(".cm-held")).to_have_text("    function.stop_bot()")
    expect(variables.locator("tr[data-name=four]")).to_contain_text("4")
    pupil.picture("over")
    pupil.press("Go on")
    pupil.state("Ended")
    assert pupil.foreign == []


def test_what_the_program_asks_is_answered_in_the_console_and_what_it_prints_is_there(pupil):
    pupil.write("blocktext", ASKING)
    pupil.sees("python", "input(")
    pupil.tab("Sensors")
    pupil.press("Run")
    expect(pupil.page.locator(".question input")).to_be_focused()
    pupil.picture("asked")
    pupil.page.keyboard.type("Ada")
    pupil.page.keyboard.press("Enter")
    expect(pupil.tab("Console")).to_contain_text("Good day, Ada")
    pupil.state("Ended")
    assert pupil.foreign == []


@pytest.mark.parametrize(
    ("statement", "said"),
    [
        ('print("again and again" * 2000)', "printed too much"),
        ("again += 1", "did nothing with the robot"),
    ],
    ids=["prints", "counts"],
)
def test_a_program_without_end_is_ended_with_its_sentence_and_the_page_goes_on(
    pupil, statement, said
):
    pupil.write(
        "blocktext", f"main:\n    again = 0\n    while True:\n        {statement}\n    end\nend\n"
    )
    pupil.sees("python", statement)
    pupil.press("Run")
    expect(pupil.tab("Console").locator(".bad")).to_contain_text(said)
    pupil.picture("ended")
    pupil.write("blocktext", "main:\n    function.stop_bot()\nend\n")
    pupil.sees("python", "robot.stop_bot()")
    pupil.press("Run")
    expect(pupil.tab("Console").locator(".good")).to_contain_text("Finished")
    assert pupil.foreign == []


def test_the_trace_is_that_of_the_command_line_whichever_view_was_edited_last(pupil):
    expected = traced_by_the_command_line()
    pupil.choose("Robot", "Cozmo")
    pupil.choose("Speed", "As fast as it goes")
    pupil.write("blocktext", SQUARE.read_text())
    pupil.sees("python", "times = 0")
    assert pupil.trace_of_a_run() == expected
    waited = pupil.blocks("lb_skill_sleep").first.locator("> .math_number .blocklyNumberField")
    pupil.fill(waited, "4")
    pupil.sees("blocktext", "sleep(4)")
    pupil.fill(waited, "5")
    pupil.sees("blocktext", "sleep(5)")
    assert pupil.trace_of_a_run() == expected
    pupil.put_cursor("python", "5)")
    pupil.page.keyboard.press("Delete")
    pupil.page.keyboard.type("4")
    pupil.sees("blocktext", "sleep(4)")
    pupil.page.keyboard.press("Backspace")
    pupil.page.keyboard.type("5")
    pupil.sees("blocktext", "sleep(5)")
    assert pupil.trace_of_a_run() == expected
    pupil.picture("trace")
    assert pupil.foreign == []


def traced_by_the_command_line():
    """The hash that ``learnblock run`` tells for the square."""
    options = ["--robot", "sim-cozmo", "--world", "empty", "--json"]
    done = subprocess.run(
        [sys.executable, "-m", "learnblock", "run", str(SQUARE), *options],
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(done.stdout)["trace_sha256"]
