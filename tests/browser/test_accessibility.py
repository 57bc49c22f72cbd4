"""Accessibility: axe finds no violation on the page, and screen readers hear what happens."""

import re

import pytest
from playwright.sync_api import expect

WIDE = {"width": 1600, "height": 900}
THEMES = ("Light", "Dark", "High contrast")
WAITS = "main:\n    function.sleep(600)\nend\n"
OUTPUT = "[data-region=panel]"
FAILS = "main:\n    x = 1 / 0\nend\n"

#: Records what the live regions say, as a screen reader does: it also reads what is soon replaced.
LISTEN = """() => {
    window.announced = {status: [], alert: []};
    for (const region of document.querySelectorAll("[role=status].hidden, [role=alert].hidden")) {
        const listen = () => announced[region.role].push(region.textContent);
        const changes = {childList: true, characterData: true, subtree: true};
        new MutationObserver(listen).observe(region, changes);
    }
}"""


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with all views of a program on the screen."""
    return with_all_views(sit_down(server, viewport=WIDE, empty=True, flat=True))


def with_all_views(pupil):
    pupil.show("Blocks", "Block-Text", "Python")
    return pupil


def test_axe_finds_a_button_without_a_name(pupil, axe):
    pupil.page.get_by_role("button", name="Show views side by side").evaluate(
        "button => button.replaceWith(document.createElement('button'))"
    )
    assert [fault[0] for fault in faults(pupil, axe, ".program-head")] == ["button-name"]


def test_the_dark_page_has_no_violation_during_a_run(pupil, axe):
    run_in_the_dark(pupil)
    assert faults(pupil, axe) == []


def test_the_dark_page_has_no_violation_during_and_after_a_run(sit_down, server, axe):
    pupil = with_all_views(sit_down(server, viewport=WIDE, empty=True))
    # In the other themes, and in all other states: test_states.py.
    run_in_the_dark(pupil)
    # The rest of the page is the same beside each of them.
    for tab, part in (("Variables", OUTPUT), ("Sensors", OUTPUT), ("Console", "body")):
        pupil.tab(tab)
        assert (tab, faults(pupil, axe, part)) == (tab, [])
    pupil.press("Stop")
    pupil.state("Ended")
    pupil.tab("Result")
    assert faults(pupil, axe) == []


def run_in_the_dark(pupil):
    """Run a program that waits, with everything on the page that can be shown."""
    choose_theme(pupil, "Dark")
    for name in ("Robot camera", "Manual control"):
        pupil.press(name)
    pupil.write("blocktext", WAITS)
    expect(pupil.blocks("lb_skill_sleep")).to_be_visible()
    pupil.press("Run")
    pupil.state("Running")


def test_a_screen_reader_reads_out_the_state_of_the_program(pupil):
    pupil.page.evaluate(LISTEN)
    pupil.write("blocktext", WAITS)
    expect(pupil.blocks("lb_skill_sleep")).to_be_visible()
    pupil.press("Run")
    expect_announcement(pupil, "status", "Running")
    pupil.press("Pause")
    expect_announcement(pupil, "status", "Paused")
    pupil.press("Stop")
    expect_announcement(pupil, "status", re.compile(r"Stopped after \d"))
    pupil.write("blocktext", FAILS)
    expect(pupil.blocks("lb_skill_sleep")).to_have_count(0)
    pupil.press("Run")
    expect_announcement(
        pupil, "alert", re.compile("Stopped by an error .*A number was divided by 0")
    )


def test_a_selected_block_is_read_out_with_its_words_and_values(pupil):
    pupil.write("blocktext", "main:\n    while x < 4:\n        function.sleep(5)\n    end\nend\n")
    expect(pupil.blocks("lb_skill_sleep")).to_be_visible()
    names = {
        "lb_main": "when Run is pressed",
        "controls_whileUntil": "while Variable 'x' less than 4",
        "lb_skill_sleep": "wait 5 seconds",
    }
    for kind, words in names.items():
        block = pupil.blocks(kind)
        pupil.select_block(block)
        name = block.locator("> .blocklyPath").first
        expect(name).to_have_accessible_name(re.compile(words))


def expect_announcement(pupil, role, words):
    """Wait until the page's live region of this role has had these words."""
    pattern = words.pattern if isinstance(words, re.Pattern) else re.escape(words)
    pupil.page.wait_for_function(
        "([role, pattern]) => announced[role].some((text) => new RegExp(pattern).test(text))",
        arg=[role, pattern],
    )


def choose_theme(pupil, theme):
    pupil.command("Settings and help", "Settings")
    pupil.dialog().get_by_role("combobox", name="Theme").select_option(label=theme)
    pupil.page.keyboard.press("Escape")


def faults(pupil, axe, part="body"):
    """Return the violations in a part of the page, whatever their impact, with their elements."""
    pupil.page.evaluate(f"() => {{ if (!globalThis.axe) {{ {axe} }} }}")
    found = pupil.page.evaluate("(part) => axe.run(part, { resultTypes: ['violations'] })", part)
    return [
        (fault["id"], node["target"], re.sub(r"\s+", " ", node["failureSummary"]))
        for fault in found["violations"]
        for node in fault["nodes"]
    ]
