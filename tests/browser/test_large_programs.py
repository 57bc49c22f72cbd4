"""A long program: what is in sight is drawn first, and nothing is lost of what is not drawn."""

import json
import re

import pytest
from playwright.sync_api import expect

from browser.pupil import LONGEST_RUN
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.project import Project

# Programs of 5,000 lines, which a busy machine draws slowly.
pytestmark = pytest.mark.timeout(400)

FUNCTIONS = 40
FUNCTION = """
def step_{number}(x):
    y = x + 2 * (x - 1)
    for i from 1 to 5:
        y = y + i
        if y > 3 and not function.is_front_obstacle(100):
            y += 1
            function.move_straight(advSpeed=x)
        elif y < -3:
            function.stop_bot()
        else:
            y = y - 1
        end
    end
    function.turn(90)
end
"""
SHORT = "def first():\n    function.sleep(1)\nend\n"
#: The server writes it last.
MAIN = "\nmain:\n    step_0(1)\nend\n"
PROGRAM = SHORT + "".join(FUNCTION.format(number=number) for number in range(FUNCTIONS)) + MAIN
#: Statements in one list; the last one is at the end of the scrollbar.
LIST = "main:\n" + "".join(f"    x = {number}\n" for number in range(1200)) + "end\n"
BRIEF = """
def step_{number}():
    function.sleep(1)
    function.stop_bot()
end
"""
#: More functions than are drawn at once.
COUNT = 120
MANY = "main:\n    function.sleep(1)\nend\n" + "".join(
    BRIEF.format(number=number) for number in range(COUNT)
)
#: Once the text is there while blocks load: note what can be seen, and paste a line at its start.
WATCH = """
globalThis.loadings = [];
const loads = () => document.querySelector(".blocks-loading") !== null;
const watcher = new MutationObserver(() => {
  const text = document.querySelector("[data-region=blocktext] .cm-content");
  if (!loads() || !text?.textContent) return;
  watcher.disconnect();
  setTimeout(() => {
    loadings.push({ loads: loads(), text: text.textContent });
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", "added = 7\\n");
    text.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true }));
  });
});
watcher.observe(document, { subtree: true, childList: true });
"""


@pytest.fixture
def open_program(sit_down, server):
    """A function that opens a saved program as a pupil."""

    def open_program(text):
        projects = ProjectFolder(server.home / "projects")
        projects.write(Project(projects.free_name("long"), text))
        pupil = sit_down(server, viewport={"width": 1800, "height": 900}, flat=True)
        pupil.sees("blocktext", text.splitlines()[1])
        return pupil

    return open_program


def function(pupil, number):
    """Return the definition of a function."""
    return pupil.blocks("procedures_defnoreturn").filter(has_text=re.compile(rf"step_{number}\D"))


def expect_functions(pupil, count=FUNCTIONS + 1):
    """Wait until all definitions of functions are there."""
    found = pupil.blocks("procedures_defnoreturn")
    expect(found).to_have_count(count, timeout=LONGEST_RUN)
    expect(pupil.page.locator(".blocks-loading")).to_have_count(0)


def unfold(pupil, number):
    """Open the folded function with this number among those that are drawn."""
    rest = function(pupil, number).locator(".lb_rest")
    pupil.click_on(rest.locator("image").last)
    expect(rest).to_have_count(0)


def saved(pupil, server):
    """Return the program as it is saved."""
    pupil.wait_until_saved()
    (file,) = server.home.rglob(f"{pupil.name_of_project()}.learnblock")
    return "\n".join(json.loads(file.read_text())["blocktext"])


@pytest.mark.certain
def test_the_text_of_a_long_program_is_shown_before_its_blocks_and_an_edit_meanwhile_is_kept(
    open_program,
):
    pupil = open_program(MANY)
    expect_functions(pupil, COUNT)
    pupil.page.add_init_script(WATCH)
    pupil.page.reload()
    pupil.sees("blocktext", "added = 7")
    seen = pupil.page.evaluate("() => loadings")
    assert [one["loads"] for one in seen] == [True]
    assert "function.sleep(1)" in seen[0]["text"]
    expect_functions(pupil, COUNT)
    expect(pupil.blocks("variables_set").filter(has_text="added")).to_have_count(1)
    pupil.wait_until_saved()
    pupil.page.reload()
    expect_functions(pupil, COUNT)
    pupil.sees("blocktext", "added = 7", "function.sleep(1)")


def test_functions_of_a_long_program_are_folded_and_one_opens_with_a_click(open_program):
    pupil = open_program(PROGRAM)
    expect_functions(pupil)
    expect(pupil.blocks("lb_rest")).to_have_count(FUNCTIONS)
    pupil.picture("folded")
    unfold(pupil, 0)
    expect(pupil.blocks("lb_skill_turn")).to_have_count(1)
    expect(pupil.blocks("lb_rest")).to_have_count(FUNCTIONS - 1)
    pupil.picture("open")


def test_an_edit_beside_folded_functions_changes_nothing_in_them(open_program, server):
    pupil = open_program(PROGRAM)
    expect_functions(pupil)
    before = saved(pupil, server)
    pupil.fill(pupil.blocks("lb_skill_sleep").locator("> .blocklyShadow").first, "4")
    pupil.sees("blocktext", "function.sleep(4)")
    assert saved(pupil, server) == before.replace("sleep(1)", "sleep(4)")
    pupil.page.keyboard.press("Control+z")
    pupil.sees("blocktext", "function.sleep(1)")
    expect(pupil.blocks("lb_rest")).to_have_count(FUNCTIONS)


def test_a_block_in_an_opened_function_is_edited_and_undone(open_program):
    pupil = open_program(PROGRAM)
    expect_functions(pupil)
    unfold(pupil, 1)
    pupil.fill(pupil.blocks("math_change").locator("> .blocklyShadow").first, "4")
    pupil.sees("blocktext", "y += 4")
    pupil.page.keyboard.press("Control+z")
    pupil.lacks("blocktext", "y += 4")
    expect(pupil.blocks("lb_rest")).to_have_count(FUNCTIONS - 1)


def test_a_new_name_of_a_function_reaches_calls_that_are_not_drawn(open_program, server):
    calls = "def last():\n" + 4 * "    step_0(2)\n" + "end\n"
    pupil = open_program(PROGRAM + calls)
    expect_functions(pupil, FUNCTIONS + 2)
    pupil.fill(function(pupil, 0).get_by_text("step_0", exact=True).first, "jump")
    pupil.sees("blocktext", "def jump(x):")
    text = saved(pupil, server)
    assert text.count("jump(2)") == 4
    assert "step_0(" not in text


def test_a_program_that_pauses_in_a_folded_function_shows_where(open_program):
    pupil = open_program(PROGRAM)
    expect_functions(pupil)
    pupil.click_beside("blocktext", pupil.line_of("blocktext", "y = x + 2"))
    pupil.choose("Speed", "Fastest")
    pupil.press("Run")
    pupil.state("Paused at breakpoint")
    expect(function(pupil, 0).locator(".lbRunning")).to_have_count(1)
    expect(function(pupil, 0).locator(".lb_rest")).to_have_count(0)
    pupil.press("Stop")


def test_the_search_finds_a_block_that_is_not_drawn(open_program):
    last = PROGRAM + "def last():\n    x = 1\n    x = 2\n    x = 3\n    x = 98765\nend\n"
    pupil = open_program(last)
    expect_functions(pupil, FUNCTIONS + 2)
    expect(number(pupil, 98765)).to_have_count(0)
    pupil.select_block(pupil.blocks("lb_skill_sleep").first)
    pupil.page.keyboard.press("Control+f")
    pupil.page.keyboard.type("98765")
    expect(pupil.page.locator(".blockly-ws-search-current")).to_be_visible()
    expect(number(pupil, 98765)).to_be_visible()


def test_a_long_list_of_statements_is_drawn_where_it_is_in_sight(open_program, server):
    pupil = open_program(LIST)
    expect(number(pupil, 0)).to_have_count(1)
    expect(pupil.blocks("lb_rest")).to_have_count(1)
    assert pupil.blocks("variables_set").count() < 200
    before = saved(pupil, server)
    pupil.blocks("variables_set").first.hover(position={"x": 20, "y": 20})
    pupil.page.mouse.wheel(0, 200_000)
    expect(number(pupil, 1199)).to_be_visible()
    assert pupil.blocks("variables_set").count() < 400
    pupil.editor("blocktext").focus()
    pupil.page.keyboard.press("Control+End")
    pupil.fill(number(pupil, 1199), "7000")
    pupil.sees("blocktext", "x = 7000")
    assert saved(pupil, server) == before.replace("1199", "7000")


def number(pupil, value):
    """Return the drawn block of a number."""
    return pupil.blocks("math_number").filter(has_text=re.compile(rf"^{value}$"))
