"""Running a program: pausing, inspecting, changing its speed, answering and stopping it."""

import json
import re
import subprocess
import sys

import pytest
from playwright.sync_api import expect

from browser.pupil import LONGEST_RUN
from places import ROOT

SQUARE = ROOT / "examples" / "square.bt"
#: The breakpoint is at line 9; `twice` can be stepped over.
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
#: What reaches beyond the right edge of these parts of the page, with more than its shadow.
CUT = """parts => parts.flatMap((part) => {
    const outer = document.querySelector(part);
    const right = outer.getBoundingClientRect().right;
    return [...outer.querySelectorAll("button, output")]
        .filter((one) => one.getBoundingClientRect().right > right)
        .map((one) => one.textContent || one.title);
})"""
DRIVING = """\
main:
    function.move_straight(20)
    function.sleep(500)
end
"""


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with an empty program in all three views on a wide screen, without the world."""
    pupil = sit_down(server, viewport={"width": 1800, "height": 900}, empty=True, flat=True)
    pupil.show("Blocks", "Block-Text", "Python")
    return pupil


def test_a_browser_without_3d_says_so_and_runs_programs(pupil):
    missing = pupil.page.locator(".world-missing")
    expect(missing).to_contain_text("This browser can't show the world in 3D")
    pupil.choose("Speed", "Fastest")
    pupil.run_to_the_end()


def test_a_pause_during_a_sleep_stops_the_world_until_resume(pupil):
    pupil.write("blocktext", DRIVING)
    pupil.sees("python", "robot.sleep(500)")
    pupil.press("Run")
    expect(pupil.blocks("lb_skill_sleep")).to_have_class(re.compile("lbRunning"))
    pupil.press("Pause")
    pupil.state("Paused")
    held = pupil.seconds_at_rest()
    pupil.picture("paused")
    # Without a pause, the robot would drive far during these requests.
    for tab in ("Variables", "Sensors", "Console"):
        pupil.tab(tab)
    assert pupil.seconds() == held
    pupil.press("Resume")
    pupil.state("Running")
    pupil.wait_until_later_than(held)
    pupil.choose("Speed", "20×")
    pupil.wait_until_later_than(held + 20)
    pupil.press("Stop")
    pupil.state("Ended")
    assert "Stopped" in pupil.tab("Result").inner_text()
    assert pupil.foreign == []


def test_a_breakpoint_set_at_a_line_is_shown_at_its_block_and_pauses_the_program(pupil):
    pupil.write("blocktext", TWICE)
    pupil.sees("python", "four = twice(2)")
    pupil.click_beside("blocktext", 9)
    expect(pupil.page.locator("[data-region=blocks] .lbBreakpoint")).to_have_count(1)
    pupil.choose("Speed", "Fastest")
    pupil.press("Run")
    pupil.state("Paused at breakpoint")
    expect(pupil.editor("blocktext").locator(".cm-held")).to_have_text("    four = twice(2)")
    expect(pupil.editor("python").locator(".cm-held")).to_have_text("four = twice(2)")
    pupil.press("Step")
    # Beside it is what it reads.
    expect(pupil.editor("blocktext").locator(".cm-held")).to_have_text("    double = n * 2n = 2")
    pupil.state("Paused after a step")
    variables = pupil.tab("Variables")
    expect(variables.locator("tr[data-name=n]")).to_contain_text("2")
    pupil.press("Step")
    expect(variables.locator("tr[data-name=double]")).to_contain_text("4")
    pupil.picture("within")
    pupil.press("Restart")
    expect(pupil.editor("blocktext").locator(".cm-held")).to_have_text("    four = twice(2)")
    pupil.press("Step over functions")
    expect(pupil.editor("blocktext").locator(".cm-held")).to_have_text("    function.stop_bot()")
    expect(variables.locator("tr[data-name=four]")).to_contain_text("4")
    pupil.picture("over")
    pupil.press("Resume")
    pupil.state("Ended")
    assert pupil.foreign == []


def test_a_click_on_a_line_number_sets_a_breakpoint_and_another_removes_it(pupil):
    pupil.write("blocktext", TWICE)
    pupil.sees("python", "four = twice(2)")
    for view, count in (("blocktext", 1), ("python", 0)):
        pupil.click_line_number(view, pupil.line_of(view, "four = twice(2)"))
        expect(pupil.page.locator("[data-region=blocks] .lbBreakpoint")).to_have_count(count)


def test_the_note_that_refused_a_run_goes_once_the_error_is_fixed(pupil):
    pupil.write("blocktext", "main:\n    function.turn(90\nend\n")
    expect(pupil.page.locator(".stale-note")).to_be_visible()
    pupil.press("Run")
    note = pupil.expect_note("The program has an error on line 2")
    pupil.write("blocktext", "main:\n    function.turn(90)\nend\n")
    expect(note).to_have_count(0)


def test_a_question_of_the_program_is_answered_in_the_console_which_shows_its_output(pupil):
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
        ("again += 1", "did not use the robot"),
    ],
    ids=["prints", "counts"],
)
def test_an_endless_program_is_stopped_with_a_reason_and_the_page_stays_usable(
    pupil, statement, said
):
    pupil.write(
        "blocktext", f"main:\n    again = 0\n    while True:\n        {statement}\n    end\nend\n"
    )
    pupil.sees("python", statement)
    pupil.press("Run")
    # A busy machine takes longer for the seconds of computing that are allowed.
    ending = pupil.tab("Console").locator(".bad")
    expect(ending).to_contain_text(said, timeout=LONGEST_RUN)
    pupil.picture("ended")
    pupil.write("blocktext", "main:\n    function.stop_bot()\nend\n")
    pupil.sees("python", "robot.stop_bot()")
    pupil.press("Run")
    expect(pupil.tab("Console").locator(".good")).to_contain_text("Finished")
    assert pupil.foreign == []


def test_an_error_leads_from_the_console_to_its_line_or_block(pupil):
    pupil.write("blocktext", "main:\n    zero = 0\n    ten = 10 / zero\nend\n")
    pupil.sees("python", "ten = 10 / zero")
    pupil.press("Run")
    console = pupil.tab("Console")
    lead = console.locator(".bad .lead")
    expect(lead).to_have_text("Block-Text, line 3")
    pupil.put_cursor("blocktext", "main")
    lead.click()
    pupil.expect_cursor_in("blocktext", 3)
    pupil.show("Blocks")
    expect(lead).to_contain_text("Block “")
    lead.click()
    expect(pupil.blocks("math_arithmetic")).to_be_visible()
    pupil.press("Run")
    expect(console.locator(".run")).to_have_count(2)


@pytest.mark.certain
def test_the_trace_equals_that_of_the_command_line_after_edits_in_any_view(pupil):
    expected = trace_of_the_command_line()
    pupil.choose("Robot", "Cozmo")
    pupil.choose("Speed", "Fastest")
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


def trace_of_the_command_line():
    """Return the hash of the trace that ``learnblock run`` prints for the square."""
    options = ["--robot", "sim-cozmo", "--world", "empty", "--json"]
    done = subprocess.run(
        [sys.executable, "-m", "learnblock", "run", str(SQUARE), *options],
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(done.stdout)["trace_sha256"]


@pytest.mark.parametrize("language", ["en", "es"])
def test_on_a_laptop_the_run_bar_and_the_tabs_are_whole_and_the_world_is_large(
    sit_down, server, language
):
    pupil = sit_down(server, language=language, empty=True)
    pupil.write("blocktext", "main:\n    function.sleep(0.1)\nend\n")
    expect(pupil.blocks("lb_skill_sleep")).to_be_visible()
    pupil.page.locator("#run button").first.click()
    expect(pupil.page.locator(".timeline")).to_be_visible()
    pupil.picture("laptop")
    for part in (".run-group .halt span", ".speed-number"):
        expect(pupil.page.locator(part)).to_be_visible()
    assert pupil.page.evaluate(CUT, [".run-bar", ".tabs"]) == []
    assert pupil.page.locator(".world-place").bounding_box()["height"] >= 320


def test_the_robot_in_the_bar_is_shown_by_its_picture(sit_down, server):
    pupil = sit_down(server, empty=True, flat=True)
    picture = pupil.menu("Robot").locator("img")
    expect(picture).to_be_visible()
    expect(picture).to_have_js_property("naturalWidth", 320)
