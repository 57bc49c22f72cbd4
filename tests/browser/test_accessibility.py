"""Accessibility: axe finds no violation on the page, and screen readers hear what happens."""

import re

import pytest
from playwright.sync_api import expect

THEMES = ("Light", "Dark", "High contrast")
WAITS = "main:\n    function.sleep(600)\nend\n"
WRONG = "main:\n    while\nend\n"
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
    pupil = sit_down(server, viewport={"width": 1600, "height": 900}, empty=True)
    pupil.show("Blocks", "Block-Text", "Python")
    return pupil


def test_axe_finds_a_button_without_a_name(pupil, axe):
    pupil.page.get_by_role("button", name="Show views side by side").evaluate(
        "button => button.replaceWith(document.createElement('button'))"
    )
    assert [fault[0] for fault in faults(pupil, axe, ".program-head")] == ["button-name"]


@pytest.mark.parametrize("theme", THEMES)
def test_the_page_has_no_violation_during_and_after_a_run_in_any_theme(pupil, axe, theme):
    choose_theme(pupil, theme)
    for name in ("Robot camera", "Manual control"):
        pupil.press(name)
    pupil.write("blocktext", WAITS)
    expect(pupil.blocks("lb_skill_sleep")).to_be_visible()
    pupil.press("Run")
    pupil.state("Running")
    # The rest of the page is the same beside each of them.
    for tab, part in (("Variables", OUTPUT), ("Sensors", OUTPUT), ("Console", "body")):
        pupil.tab(tab)
        pupil.picture(f"{theme}-{tab}")
        assert (tab, faults(pupil, axe, part)) == (tab, [])
    pupil.press("Stop")
    pupil.state("Ended")
    pupil.tab("Result")
    assert faults(pupil, axe) == []


def test_errors_have_no_violation_in_any_theme(pupil, axe):
    pupil.write("blocktext", WRONG)
    expect(pupil.page.locator(".stale-note")).to_be_visible()
    pupil.tab("Problems")
    for theme in THEMES:
        choose_theme(pupil, theme)
        pupil.picture(theme)
        assert (theme, faults(pupil, axe)) == (theme, [])


def test_palette_search_and_menu_have_no_violation_in_any_theme(pupil, axe):
    for theme in THEMES:
        choose_theme(pupil, theme)
        pupil.open_category("Control")
        expect(pupil.page.locator(".blocklyFlyout .controls_if").first).to_be_visible()
        pupil.picture(f"{theme}-palette")
        assert (theme, faults(pupil, axe, "[data-region=blocks]")) == (theme, [])
        pupil.editor("python").press("Control+f")
        pupil.page.locator("header .project-name").click()
        expect(pupil.page.get_by_role("menu")).to_be_visible()
        pupil.picture(theme)
        assert (theme, faults(pupil, axe)) == (theme, [])
        pupil.page.keyboard.press("Escape")


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


def test_no_dialog_has_a_violation_in_any_theme(pupil, axe):
    found = []
    for theme in THEMES:
        choose_theme(pupil, theme)
        for name, opened in DIALOGS.items():
            found += [(theme, name, fault) for fault in faults_of_dialog(pupil, axe, opened)]
    assert found == []


def test_the_start_page_has_no_violation_in_any_theme_and_size(own_server, sit_down, axe):
    own_server.address_of_new_project()
    for theme in ("light", "dark", "contrast"):
        for width, height in ((1366, 768), (820, 1180), (390, 844)):
            size = {"width": width, "height": height}
            pupil = sit_down(own_server, start=True, theme=theme, viewport=size)
            pupil.page.get_by_role("button", name="All examples").click()
            pupil.picture(f"start-{theme}-{width}")
            assert (theme, width, faults(pupil, axe)) == (theme, width, [])
    pupil.page.get_by_role("button", name="More for program").click()
    assert faults(pupil, axe) == []
    pupil.page.keyboard.press("Escape")
    pupil.page.get_by_role("button", name="For teachers").click()
    assert faults(pupil, axe, "dialog") == []
    pupil.dialog().get_by_role("button", name="What learnblock grade does").click()
    pupil.picture("grading")
    assert faults(pupil, axe, "dialog") == []


def test_the_world_editor_has_no_violation_in_any_theme(pupil, axe):
    for theme in THEMES:
        choose_theme(pupil, theme)
        pupil.press("Edit world")
        for number, thing in enumerate(("Wall", "Tag", "Line", "Place to reach", "Tree")):
            pupil.put_in_world(thing, up=100 - 60 * number)
        pupil.dialog().get_by_role("button", name="Line to follow", exact=True).click()
        pupil.dialog().get_by_role("button", name="New world", exact=True).click()
        pupil.picture(theme)
        assert (theme, faults(pupil, axe)) == (theme, [])
        pupil.page.keyboard.press("Escape")
        pupil.page.keyboard.press("Escape")
        expect(pupil.dialog()).to_have_count(0)


def test_the_editor_of_a_custom_block_has_its_content_in_landmarks(pupil, axe):
    pupil.project("My blocks…")
    pupil.dialog().get_by_role("button", name="New block").click()
    expect(pupil.dialog().locator(".cm-content").first).to_be_visible()
    assert faults(pupil, axe) == []


def expect_announcement(pupil, role, words):
    """Wait until the page's live region of this role has had these words."""
    pattern = words.pattern if isinstance(words, re.Pattern) else re.escape(words)
    pupil.page.wait_for_function(
        "([role, pattern]) => announced[role].some((text) => new RegExp(pattern).test(text))",
        arg=[role, pattern],
    )


def choose_theme(pupil, theme):
    pupil.press("Settings and help")
    pupil.page.get_by_role("menuitemradio", name=theme).click()


def open_block_sets(pupil):
    pupil.project("Choose blocks…")
    pupil.dialog().get_by_role("button", name="Blocks in Control", exact=True).click()


def open_tag_names(pupil):
    pupil.project("Tag names…")
    pupil.dialog().get_by_role("button", name="Add a name").click()


def open_simulated_robots(pupil):
    pupil.command("Robot", "Connect a robot…")
    pupil.dialog().get_by_role("radio", name="Simulated").check()


def open_real_robots(pupil, button):
    pupil.command("Robot", "Connect a robot…")
    pupil.dialog().get_by_role("button", name=button).click()


DIALOGS = {
    "open": lambda pupil: pupil.project("Open…"),
    "examples": lambda pupil: pupil.project("Examples…"),
    "new": lambda pupil: pupil.project("New…"),
    "rename": lambda pupil: pupil.project("Rename…"),
    "save as": lambda pupil: pupil.project("Save as…"),
    "history": lambda pupil: pupil.project("History…"),
    "delete": lambda pupil: pupil.project("Delete…"),
    "shortcuts": lambda pupil: pupil.page.keyboard.press("F1"),
    "settings": lambda pupil: open_from_help_menu(pupil, "Settings"),
    "block sets": open_block_sets,
    "tag names": open_tag_names,
    "robot settings": lambda pupil: open_settings(pupil, "Robot settings…", "Address", "Robot"),
    "real robots": lambda pupil: pupil.command("Robot", "Connect a robot…"),
    "simulated robots": open_simulated_robots,
    "help with a robot": lambda pupil: open_real_robots(pupil, "Help me find Cozmo"),
    "a robot's address": lambda pupil: open_real_robots(pupil, "Enter an address"),
    "camera recognition": lambda pupil: open_settings(pupil, "Camera recognition…", "Webcam"),
    "new robot": lambda pupil: open_settings(pupil, "New robot…", "Description (TOML)"),
    "other device": lambda pupil: open_from_help_menu(pupil, "Open on another device…"),
    "add robots": lambda pupil: pupil.command("Robot", "Add robots…"),
}


def open_from_help_menu(pupil, command):
    pupil.press("Settings and help")
    pupil.page.get_by_role("menuitem", name=command, exact=True).click()


def open_settings(pupil, command, field, menu="Settings and help"):
    pupil.menu(menu).click()
    pupil.page.get_by_role("menuitem", name=command, exact=True).click()
    expect(pupil.dialog().get_by_label(field, exact=True)).to_be_visible()


def faults_of_dialog(pupil, axe, opened):
    opened(pupil)
    expect(pupil.dialog()).to_be_visible()
    found = faults(pupil, axe, "dialog")
    pupil.page.keyboard.press("Escape")
    expect(pupil.dialog()).to_have_count(0)
    return found


def faults(pupil, axe, part="body"):
    """Return the violations in a part of the page, whatever their impact, with their elements."""
    pupil.page.evaluate(f"() => {{ if (!globalThis.axe) {{ {axe} }} }}")
    found = pupil.page.evaluate("(part) => axe.run(part, { resultTypes: ['violations'] })", part)
    return [
        (fault["id"], node["target"], re.sub(r"\s+", " ", node["failureSummary"]))
        for fault in found["violations"]
        for node in fault["nodes"]
    ]
