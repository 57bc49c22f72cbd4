"""Block sets: the blocks in the palette, from a first lesson to everything."""

import re

import pytest
from playwright.sync_api import expect

FIRST_STEPS = {
    "move_straight", "turn_90_left", "turn_90_right", "stop_bot", "expressJoy", "expressSadness",
    "expressSurprise", "expressNeutral", "sleep",
}  # fmt: skip
LOOP = "main:\n    repeat 4:\n        function.turn_back()\n    end\nend\n"
EXERCISE = """\
{
  "learnblock": 1,
  "shown": "tuesday",
  "block_sets": [
    {
      "name": "tuesday",
      "title": {"en": "On Tuesday"},
      "show": {"blocks": ["lb_main", "controls_if", "function.sleep", "function.of_our_school"]}
    }
  ],
  "blocktext": ["main:", "    function.turn_back()", "end", ""]
}
"""


@pytest.fixture
def pupil(sit_down, own_server):
    pupil = sit_down(own_server)
    pupil.begin()
    return pupil


def test_a_first_lesson_shows_ten_blocks_and_does_not_change_the_program(pupil):
    pupil.write("blocktext", LOOP)
    expect(pupil.blocks("controls_repeat_ext")).to_be_visible()
    assert len(pupil.groups()) == 9
    open_dialog(pupil)
    pupil.picture("dialog")
    pupil.dialog().get_by_role("radio", name="First steps").check()
    expect(pupil.dialog().get_by_role("status").first).to_have_text(re.compile("^10 of"))
    pupil.dialog().get_by_role("button", name="Show these blocks").click()
    expect(pupil.page.locator(".blocklyToolboxCategory")).to_have_count(5)
    pupil.picture("first-steps")
    expect_groups(pupil, "Events", "Move", "Show", "Control")
    expect(pupil.blocks("controls_repeat_ext")).to_be_visible()
    expect(pupil.blocks("lb_skill_turn_back")).to_be_visible()
    pupil.expect_note("Now showing").get_by_role("button", name="Undo").click()
    expect(pupil.page.locator(".shown-blocks")).to_have_count(0)
    assert len(pupil.groups()) == 9


def test_the_search_finds_only_shown_blocks(pupil):
    show(pupil, "First steps")
    pupil.search_blocks("repeat")
    expect(pupil.page.locator(".blocklyFlyout").first).to_contain_text("No matching blocks")


def test_the_texts_suggest_shown_blocks_before_hidden_ones(pupil):
    show(pupil, "First steps")
    pupil.write("blocktext", "main:\n    function.tur\nend\n")
    pupil.put_cursor("blocktext", "\nend")
    pupil.page.keyboard.press("Control+Space")
    options = pupil.page.locator(".cm-tooltip-autocomplete .cm-completionLabel")
    expect(options.first).to_have_text("turn_90_left")
    assert "turn_back" in options.all_text_contents()


def test_an_exercise_contains_its_own_set_and_keeps_it(pupil, own_server, tmp_path):
    file = tmp_path / "exercise.learnblock"
    file.write_text(EXERCISE, "utf-8")
    pupil.upload(file)
    pupil.expect_project("exercise")
    expect(pupil.page.locator(".shown-blocks")).to_have_accessible_name("Blocks: On Tuesday")
    expect_groups(pupil, "Events", "Control")
    expect(pupil.blocks("lb_skill_turn_back")).to_be_visible()
    open_dialog(pupil)
    expect(pupil.dialog().get_by_role("checkbox", name="function.of_our_school")).to_be_checked()
    pupil.dialog().get_by_role("radio", name="Everything").check()
    pupil.dialog().get_by_role("button", name="Show these blocks").click()
    expect(pupil.page.locator(".shown-blocks")).to_have_count(0)
    pupil.wait_until_saved()
    pupil.page.reload()
    pupil.expect_project("exercise")
    show(pupil, "On Tuesday")
    expect_groups(pupil, "Events", "Control")


def test_a_set_is_exported_deleted_and_imported_again(pupil, own_server, tmp_path):
    (own_server.home / "sets").mkdir()
    lesson = '[title]\nen = "Lesson one"\n\n[show]\nblocks = [\n    "lb_main",\n]\n'
    (own_server.home / "sets" / "lesson.toml").write_text(lesson)
    open_dialog(pupil)
    dialog = pupil.dialog()
    dialog.get_by_role("radio", name="Lesson one").check()
    with pupil.page.expect_download() as started:
        dialog.get_by_role("button", name="Export set").click()
    file = tmp_path / started.value.suggested_filename
    started.value.save_as(file)
    assert file.read_text() == lesson
    dialog.get_by_role("button", name="Delete").click()
    expect(dialog.get_by_role("radio", name="Lesson one")).to_have_count(0)
    dialog.get_by_role("button", name="Undo").click()
    expect(dialog.get_by_role("radio", name="Lesson one")).to_be_checked()
    assert (own_server.home / "sets" / "lesson.toml").read_text("utf-8") == lesson
    dialog.get_by_role("button", name="Delete").click()
    expect(dialog.get_by_role("radio", name="Lesson one")).to_have_count(0)
    with pupil.page.expect_file_chooser() as chooser:
        dialog.get_by_role("button", name="Import set…").click()
    chooser.value.set_files(file)
    expect(dialog.get_by_role("status").first).to_have_text(re.compile("^1 of"))
    dialog.get_by_role("button", name="Show these blocks").click()
    pupil.expect_note("Now showing: Lesson one")
    expect_groups(pupil, "Events")


def test_the_dialog_works_with_the_keyboard_alone(pupil):
    open_dialog(pupil)
    page = pupil.page
    page.get_by_role("radio", name="Everything").focus()
    page.keyboard.press("ArrowDown")
    expect(page.get_by_role("radio", name="First steps")).to_be_checked()
    focus_by_tab(page, "Show these blocks")
    page.keyboard.press("Enter")
    pupil.expect_note("Now showing: First steps")
    expect(pupil.dialog()).to_have_count(0)


def test_two_pages_of_a_project_show_the_same_blocks(pupil):
    first, second = pupil.page, pupil.open(pupil.page.url)
    show(pupil, "Events")
    pupil.page = second
    expect(second.locator(".shown-blocks")).to_have_accessible_name("Blocks: Events")
    pupil.page = first


def open_dialog(pupil):
    pupil.project("Choose blocks…")
    expect(pupil.dialog().get_by_role("checkbox", name="Distances")).to_be_visible()


def show(pupil, title):
    open_dialog(pupil)
    pupil.dialog().get_by_role("radio", name=title).check()
    pupil.dialog().get_by_role("button", name="Show these blocks").click()
    expect(pupil.page.locator(".shown-blocks")).to_have_accessible_name(f"Blocks: {title}")


def expect_groups(pupil, *names):
    """Wait until these are the groups of the palette."""
    expect(pupil.page.locator(".blocklyToolboxCategoryLabel")).to_have_text(names)


def focus_by_tab(page, name):
    for _ in range(200):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.textContent") == name:
            return
    raise AssertionError(f"{name} is not reached")
