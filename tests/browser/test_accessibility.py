"""Nothing on the page that axe, which knows what assistive technology needs, calls serious."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import expect

AXE = Path(__file__).parents[2] / "frontend/node_modules/axe-core/axe.min.js"
THEMES = ("Light", "Dark", "High contrast")
WAITS = "main:\n    function.sleep(600)\nend\n"
WRONG = "main:\n    while\nend\n"
FAILS = "main:\n    x = 1 / 0\nend\n"


@pytest.fixture(scope="module")
def axe():
    """The code of axe, which is no part of what is installed."""
    if not AXE.exists():
        pytest.skip("no axe-core: npm ci in frontend")
    return AXE.read_text()


@pytest.fixture
def pupil(sit_down, server):
    """With all views of a program on the screen."""
    pupil = sit_down(server, viewport={"width": 1600, "height": 900})
    pupil.begin()
    pupil.show("Blocks", "Block-Text", "Python")
    return pupil


def test_axe_finds_what_is_wrong(pupil, axe):
    pupil.page.get_by_role("button", name="Undo").evaluate(
        "button => button.replaceWith(document.createElement('button'))"
    )
    assert [fault[0] for fault in faults(pupil, axe, "header")] == ["button-name"]


def test_what_the_page_shows_of_a_run_has_no_serious_fault_in_any_theme(pupil, axe):
    for name in ("Robot's camera", "Drive by hand"):
        pupil.press(name)
    pupil.write("blocktext", WAITS)
    expect(pupil.blocks("lb_skill_sleep")).to_be_visible()
    pupil.press("Run")
    pupil.state("Running")
    for theme, tab in zip(THEMES, ("Variables", "Sensors", "Console"), strict=True):
        put_on(pupil, theme)
        pupil.tab(tab)
        pupil.picture(theme)
        assert (theme, faults(pupil, axe)) == (theme, [])
    pupil.press("Stop")
    pupil.state("Ended")
    pupil.tab("Result")
    assert faults(pupil, axe) == []


def test_errors_are_shown_without_a_serious_fault_in_any_theme(pupil, axe):
    pupil.write("blocktext", WRONG)
    expect(pupil.page.locator(".stale-note")).to_be_visible()
    pupil.tab("Problems")
    for theme in THEMES:
        put_on(pupil, theme)
        pupil.picture(theme)
        assert (theme, faults(pupil, axe)) == (theme, [])


def test_what_is_open_over_the_page_has_no_serious_fault_in_any_theme(pupil, axe):
    for theme in THEMES:
        put_on(pupil, theme)
        pupil.open_category("Control")
        expect(pupil.page.locator(".blocklyFlyout .controls_if").first).to_be_visible()
        pupil.picture(f"{theme}-palette")
        assert (theme, faults(pupil, axe, "[data-region=blocks]")) == (theme, [])
        pupil.editor("python").press("Control+f")
        pupil.page.locator("header").get_by_role("button").first.click()
        expect(pupil.page.get_by_role("menu")).to_be_visible()
        pupil.picture(theme)
        assert (theme, faults(pupil, axe)) == (theme, [])
        pupil.page.keyboard.press("Escape")


def test_a_screen_reader_is_told_what_the_program_does(pupil):
    pupil.write("blocktext", WAITS)
    expect(pupil.blocks("lb_skill_sleep")).to_be_visible()
    pupil.press("Run")
    says(pupil, "status", "Running")
    pupil.press("Pause")
    says(pupil, "status", "Paused")
    pupil.press("Stop")
    says(pupil, "status", re.compile(r"Stopped after \d"))
    pupil.write("blocktext", FAILS)
    expect(pupil.blocks("lb_skill_sleep")).to_have_count(0)
    pupil.press("Run")
    says(pupil, "alert", re.compile("Stopped by an error .*Nothing can be divided by zero"))


def test_a_block_is_read_out_by_its_words_and_values_when_it_is_come_to(pupil):
    pupil.write("blocktext", "main:\n    while x < 4:\n        function.sleep(5)\n    end\nend\n")
    expect(pupil.blocks("lb_skill_sleep")).to_be_visible()
    names = {
        "lb_main": "main program",
        "controls_whileUntil": "while, Variable 'x', less than, 4",
        "lb_skill_sleep": "wait seconds, 5",
    }
    for kind, words in names.items():
        block = pupil.blocks(kind)
        pupil.select_block(block)
        name = block.locator("> .blocklyPath").first
        expect(name).to_have_accessible_name(re.compile(words))


def test_no_dialog_has_a_serious_fault_in_any_theme(pupil, axe):
    found = []
    for theme in THEMES:
        put_on(pupil, theme)
        for name, opened in DIALOGS.items():
            found += [(theme, name, fault) for fault in faults_of_dialog(pupil, axe, opened)]
    assert found == []


def test_the_world_editor_has_no_serious_fault_in_any_theme(pupil, axe):
    for theme in THEMES:
        put_on(pupil, theme)
        pupil.press("Edit the world")
        for thing in ("Wall", "Tag", "Line", "Line to follow"):
            pupil.dialog().get_by_role("button", name=thing, exact=True).click()
        pupil.picture(theme)
        assert (theme, faults(pupil, axe, "dialog")) == (theme, [])
        pupil.page.keyboard.press("Escape")
        pupil.page.keyboard.press("Escape")
        expect(pupil.dialog()).to_have_count(0)


def says(pupil, role, words):
    """Wait until the page's own live region of that role says so."""
    told = pupil.page.locator(f"[role={role}].hidden").filter(has_text=words)
    expect(told).to_have_count(1)


def put_on(pupil, theme):
    pupil.press("Colours")
    pupil.page.get_by_role("menuitemradio", name=theme).click()


def blocks_shown(pupil):
    pupil.project("Blocks shown…")
    pupil.dialog().get_by_role("button", name="Blocks of Control", exact=True).click()


def names_of_tags(pupil):
    pupil.project("Names of tags…")
    pupil.dialog().get_by_role("button", name="Add a name").click()


DIALOGS = {
    "open": lambda pupil: pupil.project("Open…"),
    "examples": lambda pupil: pupil.project("Examples…"),
    "save as": lambda pupil: pupil.project("Save as…"),
    "history": lambda pupil: pupil.project("History…"),
    "delete": lambda pupil: pupil.project("Delete…"),
    "shortcuts": lambda pupil: pupil.page.keyboard.press("F1"),
    "settings": lambda pupil: help_menu(pupil, "Settings"),
    "blocks shown": blocks_shown,
    "names of tags": names_of_tags,
    "settings of robots": lambda pupil: settings(pupil, "Settings of robots…", "Address"),
    "perception": lambda pupil: settings(pupil, "Perception…", "Webcam"),
    "new robot": lambda pupil: settings(pupil, "New robot…", "Description (TOML)"),
    "tour": lambda pupil: help_menu(pupil, "A tour of the page"),
}


def help_menu(pupil, command):
    pupil.press("Help and settings")
    pupil.page.get_by_role("menuitem", name=command, exact=True).click()


def settings(pupil, command, field):
    help_menu(pupil, command)
    expect(pupil.dialog().get_by_label(field, exact=True)).to_be_visible()


def faults_of_dialog(pupil, axe, opened):
    opened(pupil)
    expect(pupil.dialog()).to_be_visible()
    found = faults(pupil, axe, "dialog")
    pupil.page.keyboard.press("Escape")
    expect(pupil.dialog()).to_have_count(0)
    return found


def faults(pupil, axe, part="body"):
    """What is wrong in a part of the page and where, if it is serious or critical."""
    pupil.page.evaluate(f"() => {{ if (!globalThis.axe) {{ {axe} }} }}")
    found = pupil.page.evaluate("(part) => axe.run(part, { resultTypes: ['violations'] })", part)
    return [
        (fault["id"], node["target"], re.sub(r"\s+", " ", node["failureSummary"]))
        for fault in found["violations"]
        if fault["impact"] in ("serious", "critical")
        for node in fault["nodes"]
    ]
