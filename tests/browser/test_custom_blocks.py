"""Custom blocks: writing, using, trying and sharing them, and their errors."""

import re

import pytest
from playwright.sync_api import expect

from browser.conftest import Server
from browser.custom_blocks import USES_ZIGZAG, ZIGZAG, Bench
from browser.test_accessibility import THEMES, choose_theme, faults
from browser.typist import Typist

RAISES = """\
def count_down(robot, seconds: int = 3) -> None:
    steps = 10 / (seconds - seconds)
"""
NEVER_ENDS = """\
def spin(robot) -> None:
    while True:
        pass
"""
NO_PYTHON = "def hop(robot) -> None:\n    if True\n        robot.sleep(1)\n"
SHADOWS = "def stop_bot(robot) -> None:\n    robot.sleep(1)\n"
FIELDS = '''\
from typing import Annotated, Literal

from learnblock.fields import Angle, Colour, Range, TagName


def paint(
    robot,
    speed: Annotated[float, Range(0, 100)] = 50,
    brush: Literal["thin", "thick"] = "thin",
    colour: Colour = "#ff8800",
    direction: Angle = 90,
    stop_at: TagName = "ball",
) -> None:
    """Paint the floor."""
'''


@pytest.fixture(scope="module")
def workshop(tmp_path_factory):
    """A server for the blocks of these tests."""
    server = Server(tmp_path_factory.mktemp("workshop-home"))
    yield server
    assert server.stop() == 0


@pytest.fixture
def pupil(sit_down, workshop):
    return sit_down(workshop, empty=True, flat=True)


@pytest.fixture
def bench(pupil):
    return Bench(pupil)


def test_ten_lines_of_python_become_a_block_that_runs_the_same_in_a_new_profile(
    bench, pupil, sit_down, own_server
):
    pupil.choose("Speed", "Fastest")
    bench.make(ZIGZAG)
    (main,) = pupil.block_ids()
    pupil.take("My blocks", "lb_skill_zigzag", to=lambda: pupil.inside(main))
    pupil.sees("blocktext", "function.zigzag(2)")
    pupil.picture("in-the-palette")
    bench.uses(USES_ZIGZAG, "lb_skill_zigzag")
    trace = pupil.trace_of_a_run()
    filename, content = bench.export("zigzag")
    other = sit_down(own_server, flat=True)
    elsewhere = Bench(other)
    other.choose("Speed", "Fastest")
    elsewhere.list()
    elsewhere.choose_import(filename, content)
    expect(elsewhere.dialog.get_by_text("zigzag added to the palette")).to_be_visible()
    elsewhere.close()
    elsewhere.uses(USES_ZIGZAG, "lb_skill_zigzag")
    assert other.trace_of_a_run() == trace


def test_an_error_inside_a_block_is_shown_at_its_call_and_opens_its_line(bench, pupil):
    bench.make(RAISES)
    bench.uses("main:\n    function.count_down()\nend\n", "lb_skill_count_down")
    pupil.press("Run")
    pupil.state("Ended")
    expect(pupil.blocks("lb_skill_count_down.lbError")).to_be_visible()
    problems = pupil.tab("Problems")
    expect(problems).to_contain_text("A number was divided by 0")
    problems.get_by_role("button", name="Open the block count_down at line 2").click()
    expect(bench.code.locator(".cm-activeLine")).to_have_text(re.compile("steps = 10"))
    pupil.picture("line")


def test_a_block_that_never_ends_can_be_stopped(bench, pupil):
    bench.make(NEVER_ENDS)
    bench.uses("main:\n    function.spin()\nend\n", "lb_skill_spin")
    pupil.press("Run")
    pupil.state("Running")
    pupil.press("Stop")
    pupil.state("Ended")
    expect(pupil.tab("Result")).to_contain_text("Stopped")


def test_a_trial_of_a_block_that_never_ends_can_be_stopped(bench):
    bench.new()
    bench.write(NEVER_ENDS)
    panel = bench.tab("Try it")
    panel.get_by_role("button", name="Try it on").click()
    expect(panel).to_contain_text("Running…")
    panel.get_by_role("button", name="Stop").click()
    expect(panel).to_contain_text("Stopped after")
    discard(bench)


def test_invalid_python_is_reported_at_its_line_and_not_saved(bench, pupil):
    bench.new()
    bench.write(NO_PYTHON)
    expect(bench.problems).to_contain_text("line 2")
    expect(bench.dialog.locator(".cm-lint-marker-error")).to_be_visible()
    bench.dialog.get_by_role("textbox", name="File name").fill("hop")
    bench.dialog.get_by_role("button", name="Save", exact=True).click()
    expect(bench.dialog.get_by_role("alert")).to_contain_text("Not saved")
    pupil.picture("refused")
    discard(bench)
    expect(bench.list().get_by_text("hop")).to_have_count(0)


def test_a_block_with_the_name_of_a_skill_is_refused(bench):
    bench.new()
    bench.write(SHADOWS)
    expect(bench.problems).to_contain_text("stop_bot")
    bench.dialog.get_by_role("button", name="Save", exact=True).click()
    expect(bench.dialog.get_by_role("alert")).to_contain_text("Not saved")
    discard(bench)


def test_a_block_can_be_tried_with_arguments_before_it_is_saved(bench, pupil):
    bench.new()
    panel = bench.tab("Try it")
    panel.get_by_role("spinbutton", name="times").fill("2")
    panel.get_by_role("button", name="Try it on EBO").click()
    expect(panel.get_by_role("log")).to_have_text(re.compile(r"^Hello!\s+Hello!\s*$"))
    expect(panel).to_contain_text("Finished after 1 s")
    pupil.picture("tried")
    bench.write(RAISES)
    panel.get_by_role("spinbutton", name="seconds").fill("2")
    panel.get_by_role("button", name="Try it on EBO").click()
    expect(panel).to_contain_text("Line 2 of this code")
    bench.problems.get_by_role("button", name="divided by 0").click()
    expect(bench.code.locator(".cm-activeLine")).to_contain_text("steps = 10")
    discard(bench)


def test_a_block_shows_its_translated_text_in_each_language(bench, pupil):
    bench.make(ZIGZAG.replace("zigzag(", "slalom("))
    bench.edit("slalom")
    bench.dialog.get_by_role("textbox", name="Text on the block, Spanish").fill("hacer eslalon")
    bench.dialog.get_by_role("combobox", name="Category").fill("Dance")
    bench.dialog.get_by_role("combobox", name="Add language…").select_option("DE")
    bench.dialog.get_by_role("textbox", name="corners, German").fill("Ecken")
    bench.tab("Configuration")
    expect(bench.dialog.get_by_role("textbox", name="Configuration as JSON")).to_contain_text(
        "Ecken"
    )
    bench.save()
    bench.close()
    pupil.open_category("My blocks")
    expect(pupil.page.locator(".blocklyFlyout .lb_skill_slalom")).to_contain_text("slalom")
    pupil.press("Settings and help")
    pupil.page.get_by_role("menuitemradio", name="Español").click()
    # The palette changes with the blocks, later than the rest of the page.
    expect(pupil.blocks("lb_main")).to_contain_text("al pulsar Ejecutar")
    pupil.open_category("Mis bloques")
    expect(pupil.page.locator(".blocklyFlyout .lb_skill_slalom")).to_contain_text("hacer eslalon")
    pupil.picture("slalom")


@pytest.mark.certain
def test_unsaved_changes_are_restored_and_can_be_discarded(bench, pupil):
    bench.new()
    bench.write(ZIGZAG.replace("zigzag", "later"))
    expect(bench.dialog.get_by_text("Not saved yet")).to_be_visible()
    bench.close()
    pupil.page.reload()
    bench.list().get_by_role("button", name="New block").click()
    expect(bench.code).to_contain_text("def later")
    expect(bench.dialog.get_by_text("Your unsaved changes were restored")).to_be_visible()
    bench.dialog.get_by_role("button", name="Discard changes").click()
    expect(bench.code).to_contain_text("def my_block")


def test_a_program_keeps_a_changed_or_deleted_block_and_every_page_is_updated(
    bench, pupil, sit_down, workshop
):
    bench.make(ZIGZAG.replace("zigzag", "weave"))
    other = sit_down(workshop)
    bench.uses("main:\n    function.weave(3)\nend\n", "lb_skill_weave")
    other.open_category("My blocks")
    expect(other.page.locator(".blocklyFlyout .lb_skill_weave")).to_be_visible()
    bench.edit("weave")
    bench.write(ZIGZAG.replace("zigzag", "weave").replace("corners", "bends"))
    bench.save()
    bench.close()
    expect(pupil.blocks("lb_skill_weave")).to_contain_text("bends")
    expect(other.page.locator(".blocklyFlyout .lb_skill_weave")).to_contain_text("bends")
    bench.list().get_by_role("button", name="Delete weave").click()
    expect(bench.dialog.get_by_text("weave deleted")).to_be_visible()
    expect(other.page.locator(".blocklyFlyout .lb_skill_weave")).to_have_count(0)
    pupil.sees("blocktext", "function.weave(3)")
    bench.dialog.get_by_role("button", name="Undo").click()
    expect(bench.dialog.get_by_text("weave restored")).to_be_visible()
    bench.close()
    expect(pupil.blocks("lb_skill_weave")).to_contain_text("bends")
    expect(pupil.page.get_by_role("tab", name="Problems")).to_have_text(re.compile("^Problems *$"))


def test_a_block_is_duplicated_and_replaced_by_an_import_only_after_confirmation(bench):
    bench.make(ZIGZAG.replace("zigzag", "swerve"))
    filename, content = bench.export("swerve")
    bench.list().get_by_role("button", name="Duplicate swerve").click()
    expect(bench.dialog.get_by_text("swerve_2 is a copy of swerve")).to_be_visible()
    bench.choose_import(filename, content)
    expect(bench.dialog.get_by_role("alert")).to_contain_text(
        "You already have a block named swerve"
    )
    bench.dialog.get_by_role("button", name="Replace").click()
    expect(bench.dialog.get_by_text("swerve added to the palette")).to_be_visible()
    bench.dialog.get_by_role("searchbox").fill("swerve_2")
    expect(bench.dialog.get_by_role("listitem")).to_have_count(1)


def test_each_parameter_has_a_field_that_fits_its_type(bench, pupil):
    bench.make(FIELDS)
    bench.uses("main:\n    function.paint()\nend\n", "lb_skill_paint")
    pupil.show("Blocks")
    pupil.click_on(pupil.blocks("lb_slider"))
    pupil.page.keyboard.press("ArrowRight")
    pupil.page.keyboard.press("Enter")
    pupil.click_on(pupil.blocks("lb_choice"))
    pupil.page.locator(".blocklyMenuItem", has_text="thick").click()
    pupil.click_on(pupil.blocks("lb_colour"))
    pupil.picture("colours")
    pupil.page.get_by_role("button", name="green", exact=True).click()
    pupil.click_on(pupil.blocks("lb_angle"))
    pupil.picture("dial")
    pupil.page.keyboard.press("ArrowLeft")
    pupil.page.keyboard.press("Enter")
    pupil.fill(pupil.blocks("lb_tag"), "8")
    pupil.show("Blocks", "Block-Text")
    pupil.sees("blocktext", 'function.paint(51, "thick", "#00ff00", 85, 8)')


def test_escape_restores_the_value_of_a_field(bench, pupil):
    bench.make(FIELDS.replace("paint", "tint"))
    bench.uses("main:\n    function.tint(30)\nend\n", "lb_skill_tint")
    pupil.show("Blocks", "Block-Text")
    pupil.blocks("lb_slider").click()
    pupil.page.keyboard.press("ArrowRight")
    pupil.page.keyboard.press("Escape")
    expect(pupil.blocks("lb_slider")).to_have_text("30")
    pupil.sees("blocktext", "function.tint(30)")


def test_a_block_can_be_created_with_the_keyboard_alone(pupil):
    keys = Typist(pupil)
    keys.go_to("blocks")
    keys.press("t")
    keys.walk("ArrowDown", "^My blocks$")
    keys.press("ArrowRight")
    keys.walk("ArrowDown", "^New block…")
    keys.press("Enter")
    code = Bench(pupil).code
    expect(code).to_be_focused()
    expect(code).to_contain_text("my_block")
    keys.press("Control+a")
    pupil.page.keyboard.insert_text(ZIGZAG.replace("zigzag", "by_keys"))
    expect(pupil.dialog().get_by_role("textbox", name="File name")).to_have_value("by_keys")
    # The first one closes the suggestions.
    keys.press("Escape", "Escape", "Tab")
    keys.walk("Tab", "^Block$")
    keys.press("ArrowRight")
    assert keys.hears() == "Try it"
    keys.walk("Tab", "^Try it on")
    with pupil.page.expect_response("**/palette/en.json"):
        keys.press("Control+s")
    expect(pupil.dialog().get_by_text("by_keys saved")).to_be_visible()
    keys.press("Escape")
    expect(pupil.dialog()).to_have_count(0)
    expect(pupil.page.locator("[data-region=blocks]:focus-within")).to_be_attached()
    keys.walk("ArrowDown", "when Run is pressed")
    keys.take("My blocks", "by keys")
    pupil.sees("blocktext", "function.by_keys(2)")


def test_the_dialogs_are_in_spanish(sit_down, workshop):
    pupil = sit_down(workshop, language="es")
    pupil.project("Mis bloques…")
    pupil.picture("list")
    pupil.dialog().get_by_role("button", name="Bloque nuevo").click()
    code = pupil.dialog().get_by_role("textbox", name="Python")
    expect(code).to_contain_text("Saluda varias veces")
    code.click()
    pupil.page.keyboard.press("Control+a")
    pupil.page.keyboard.insert_text(SHADOWS)
    problems = pupil.dialog().get_by_role("status", name="Problemas del bloque")
    expect(problems).to_contain_text("stop_bot")
    pupil.picture("editor")
    assert not re.search(r"\b(the|is|name|block|another)\b", problems.inner_text())
    assert pupil.foreign == []


@pytest.mark.parametrize("theme", THEMES)
def test_the_dialogs_have_no_serious_violation(bench, pupil, theme, axe):
    choose_theme(pupil, theme)
    bench.list()
    assert faults(pupil, axe, "dialog") == []
    bench.dialog.get_by_role("button", name="New block").click()
    bench.write(NO_PYTHON)
    expect(bench.problems).to_be_visible()
    assert faults(pupil, axe, "dialog") == []
    bench.write(FIELDS.replace("paint", "draw"))
    expect(bench.dialog.get_by_role("img")).to_be_visible()
    for tab in ("Try it", "Configuration", "Block"):
        bench.tab(tab)
        pupil.picture(tab)
        assert (tab, faults(pupil, axe, "dialog")) == (tab, [])
    discard(bench)


def test_the_dialog_fits_on_a_narrow_screen(sit_down, workshop):
    pupil = sit_down(workshop, viewport={"width": 420, "height": 800})
    bench = Bench(pupil)
    bench.new()
    pupil.picture("narrow")
    bench.dialog.get_by_role("tab", name="Try it").scroll_into_view_if_needed()
    wide = pupil.page.evaluate("document.querySelector('.custom-block').scrollWidth")
    assert wide <= 420


def discard(bench):
    """Discard the changes, which the next new block would restore."""
    bench.dialog.get_by_role("button", name="Discard changes").click()
    bench.close()
