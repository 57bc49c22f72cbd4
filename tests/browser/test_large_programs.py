"""A long program: its text can be read and edited before all of its blocks are there."""

import pytest
from playwright.sync_api import expect

from browser.pupil import LONGEST_RUN

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
PROGRAM = "main:\n    function.sleep(1)\nend\n" + "".join(
    FUNCTION.format(number=number) for number in range(FUNCTIONS)
)
#: When blocks begin to load: note what can be seen, and paste a line at the start of the text.
WATCH = """
globalThis.loadings = [];
const loads = () => document.querySelector(".blocks-loading") !== null;
const watcher = new MutationObserver(() => {
  if (!loads()) return;
  watcher.disconnect();
  const disabled = document.querySelector(".blocks .injectionDiv").inert;
  setTimeout(() => {
    const text = document.querySelector("[data-region=blocktext] .cm-content");
    loadings.push({ disabled, loads: loads(), text: text.textContent });
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", "added = 7\\n");
    text.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true }));
  });
});
watcher.observe(document, { subtree: true, childList: true });
"""


@pytest.fixture
def pupil(sit_down, server):
    """A pupil whose project has a long program."""
    pupil = sit_down(server, viewport={"width": 1800, "height": 900})
    pupil.begin("long")
    pupil.show("Blocks", "Block-Text")
    pupil.write("blocktext", PROGRAM)
    expect_all_blocks(pupil)
    pupil.wait_until_saved()
    return pupil


def expect_all_blocks(pupil):
    """Wait until every block is there and can be edited."""
    functions = pupil.blocks("procedures_defnoreturn")
    expect(functions).to_have_count(FUNCTIONS, timeout=LONGEST_RUN)
    expect(pupil.blocks("lb_skill_turn")).to_have_count(FUNCTIONS)
    expect(pupil.page.locator(".blocks-loading")).to_have_count(0)
    assert not pupil.page.locator(".blocks .injectionDiv").evaluate("blocks => blocks.inert")


def test_the_text_of_a_long_program_is_shown_before_its_blocks_and_an_edit_meanwhile_is_kept(pupil):
    pupil.page.add_init_script(WATCH)
    pupil.page.reload()
    pupil.sees("blocktext", "added = 7")
    seen = pupil.page.evaluate("() => loadings")
    assert [(one["disabled"], one["loads"]) for one in seen] == [(True, True)]
    assert "function.sleep(1)" in seen[0]["text"]
    expect_all_blocks(pupil)
    expect(pupil.blocks("variables_set").filter(has_text="added")).to_have_count(1)
    pupil.picture("complete")
    pupil.wait_until_saved()
    pupil.page.reload()
    expect_all_blocks(pupil)
    pupil.sees("blocktext", "added = 7", "function.sleep(1)")


def test_blocks_of_a_long_program_can_be_edited_and_undone_once_they_are_there(pupil):
    pupil.page.reload()
    expect_all_blocks(pupil)
    pupil.fill(pupil.blocks("math_change").locator("> .blocklyShadow").first, "4")
    pupil.sees("blocktext", "y += 4")
    pupil.page.keyboard.press("Control+z")
    pupil.lacks("blocktext", "y += 4")
    expect_all_blocks(pupil)
