"""Lessons that a teacher makes in the page: from the open project to a pupil's star."""

import io
import re
import zipfile

import pytest
from playwright.sync_api import expect

import small_lesson
from browser.conftest import Server
from browser.test_accessibility import faults
from browser.typist import Typist

PROGRAM = (
    "main:\n    function.move_straight(40)\n    function.sleep(4)\n    function.stop_bot()\nend\n"
)
TEXT = "Drive **100 mm**.\n\n```blocks\nfunction.stop_bot()\n```\n"


@pytest.fixture
def teacher(own_server, sit_down):
    """A teacher with a program."""
    teacher = sit_down(own_server, empty=True)
    teacher.show("Block-Text")
    teacher.write("blocktext", PROGRAM)
    teacher.wait_until_saved()
    return teacher


def part(teacher, name):
    """Show a part of the lesson."""
    teacher.dialog().get_by_role("navigation").get_by_role("button", name=name).click()


def fill(teacher, field, text):
    """Write into the first field with this label."""
    teacher.dialog().get_by_label(field).first.fill(text)


def begin(teacher):
    """Make a lesson of the open project, and say what it is about."""
    teacher.project("Make a lesson of this project…")
    fill(teacher, "Title", "My drive")
    fill(teacher, "What pupils learn", "Drive and stop")


def write_step(teacher, number, title):
    """Write a step in which the robot has to drive."""
    part(teacher, re.compile(f"^{number}\\."))
    fill(teacher, "Title of the step", title)
    fill(teacher, "Instructions (Markdown)", TEXT)
    fill_check(teacher, "drives")
    fill(teacher, "At least", "100")


def fill_check(teacher, kind):
    """Choose what is checked first."""
    teacher.dialog().get_by_label("What is checked").first.select_option(kind)


def save(teacher):
    """Save the lesson."""
    teacher.dialog().get_by_role("button", name="Save lesson").click()
    expect(teacher.dialog().locator(".maker-foot")).to_contain_text("Saved")


def make(teacher):
    """Make and save a lesson with two steps."""
    begin(teacher)
    write_step(teacher, 1, "Drive 100 mm")
    teacher.dialog().get_by_role("button", name="Add a step").click()
    write_step(teacher, 2, "Again")
    save(teacher)


def leave_for_the_start_page(teacher):
    """Close the editor, and go to the start page."""
    teacher.dialog().get_by_role("button", name="Close").first.click()
    show_the_first_lessons(teacher)


def show_the_first_lessons(teacher):
    """Go to the lessons of the first level on the start page."""
    teacher.page.close()
    teacher.page = teacher.open_start()
    teacher.page.get_by_role("button", name="1 · First drive").click()


def card(teacher, title="My drive"):
    """The card of the lesson on the start page."""
    return teacher.page.locator(".lesson-card", has_text=title)


def choose(teacher, item):
    """Choose what to do with the lesson."""
    card(teacher).get_by_role("button", name="More for My drive").click()
    assert teacher.page.get_by_role("menu").bounding_box()["x"] >= 0
    teacher.page.get_by_role("menuitem", name=item, exact=True).click()


def test_a_teacher_makes_a_lesson_that_a_pupil_plays_to_a_star(teacher):
    make(teacher)
    leave_for_the_start_page(teacher)
    expect(card(teacher)).to_contain_text("0/2")
    card(teacher).get_by_role("button", name="My drive").first.click()
    lesson = teacher.page.locator("[data-region=lesson]")
    expect(lesson).to_contain_text("Drive at least 100 mm")
    expect(lesson.locator(".block-drawing .lb_skill_stop_bot")).to_have_count(1)
    teacher.choose("Speed", "Fastest")
    teacher.press("Run")
    expect(lesson.locator(".lesson-goal")).to_have_class(re.compile("met"))
    stars = lesson.locator(".lesson-stars").first
    expect(stars).to_have_attribute("aria-label", re.compile("^1 of 1 star"))


def test_what_pupils_download_has_no_solution(teacher):
    make(teacher)
    part(teacher, "For the teacher")
    names = {}
    for who in ("for pupils", "with the teacher's part"):
        with teacher.page.expect_download() as download:
            teacher.dialog().get_by_role("button", name=f"Download {who}").click()
        content = download.value.path().read_bytes()
        names[who] = zipfile.ZipFile(io.BytesIO(content)).namelist()
    assert not any("teacher" in name for name in names["for pupils"])
    assert "teacher/solutions/step-1.bt" in names["with the teacher's part"]


def test_a_lesson_is_changed_and_deleted_from_its_card(teacher):
    make(teacher)
    leave_for_the_start_page(teacher)
    choose(teacher, "Change…")
    expect(teacher.dialog().get_by_label("Title")).to_have_value("My drive")
    fill(teacher, "Minutes", "77")
    part(teacher, re.compile("^2\\. Again"))
    teacher.dialog().get_by_role("button", name="Move this step up").click()
    expect(teacher.dialog().get_by_role("navigation")).to_contain_text("1. Again")
    save(teacher)
    teacher.dialog().get_by_role("button", name="Close").first.click()
    expect(card(teacher)).to_contain_text("77 min")
    choose(teacher, "Delete…")
    teacher.dialog().get_by_role("button", name="Delete lesson").click()
    expect(card(teacher)).to_have_count(0)


def our_lesson(teacher, item, title="A square with a loop"):
    """Choose what to do with a lesson that comes with LearnBlock."""
    button = teacher.page.get_by_role("button", name=f"More for {title}", exact=True)
    button.click()
    teacher.page.get_by_role("menuitem", name=item, exact=True).click()


def test_the_teacher_reads_notes_and_solutions_of_a_lesson_of_ours(teacher):
    show_the_first_lessons(teacher)
    our_lesson(teacher, "Notes and solutions")
    shown = teacher.dialog()
    expect(shown).to_contain_text("A square with a loop: notes and solutions")
    expect(shown.get_by_text("Common mistakes")).to_be_visible()
    expect(shown.get_by_text("function.drive_distance(300)").first).to_be_visible()
    teacher.picture("lesson-notes")
    wrong = shown.get_by_text("Typical wrong programs (2)")
    wrong.click()
    expect(shown.get_by_text("Look at the first corner: does the robot reach it?")).to_be_visible()
    wrong.scroll_into_view_if_needed()
    teacher.picture("lesson-notes-wrong")
    with teacher.page.expect_download() as download:
        shown.get_by_role("button", name="Save worksheet").click()
    assert download.value.suggested_filename == "1-03-square.html"
    teacher.page.keyboard.press("Escape")
    expect(shown).to_have_count(0)


def test_a_lesson_of_ours_is_copied_and_changed(teacher):
    show_the_first_lessons(teacher)
    our_lesson(teacher, "Copy and change…")
    expect(teacher.dialog().get_by_label("Title")).to_have_value("A square with a loop (copy)")
    expect(teacher.dialog().locator(".maker-foot")).to_contain_text("Saved")
    fill(teacher, "Minutes", "77")
    save(teacher)
    teacher.picture("lesson-copied")
    teacher.dialog().get_by_role("button", name="Close").first.click()
    copy = card(teacher, "A square with a loop (copy)")
    expect(copy).to_contain_text("77 min")
    copy.get_by_role("button", name="A square with a loop (copy)").first.click()
    expect(teacher.page.locator("[data-region=lesson]")).to_contain_text("Four times")


def test_a_page_that_may_be_on_another_computer_offers_nothing_of_the_teachers(tmp_path, sit_down):
    behind_a_proxy = Server(tmp_path, "--allow-host=school.example")
    pupil = sit_down(behind_a_proxy, empty=True)
    pupil.project("More…")
    expect(pupil.dialog().get_by_role("button", name="Tag names")).to_be_visible()
    expect(pupil.dialog().get_by_role("button", name="Make a lesson of")).to_have_count(0)
    show_the_first_lessons(pupil)
    expect(card(pupil, "A square with a loop")).to_have_count(1)
    expect(pupil.page.get_by_role("button", name="More for A square with")).to_have_count(0)
    expect(pupil.page.get_by_role("button", name="Add a lesson")).to_have_count(0)
    assert behind_a_proxy.stop() == 0


def test_a_lesson_is_opened_from_its_folder(teacher, tmp_path):
    for path, text in small_lesson.FILES.items():
        (tmp_path / "my-lesson" / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "my-lesson" / path).write_text(text)
    (tmp_path / "my-lesson" / ".git").mkdir()
    (tmp_path / "my-lesson" / ".git" / "large").write_bytes(bytes(3_000_000))
    show_the_first_lessons(teacher)
    open_folder(teacher, tmp_path / "my-lesson" / "programs")
    expect(teacher.page.locator(".toast")).to_contain_text("has no lesson.toml")
    open_folder(teacher, tmp_path / "my-lesson")
    lesson = teacher.page.locator("[data-region=lesson]")
    expect(lesson).to_contain_text("What happens?")
    show_the_first_lessons(teacher)
    teacher.picture("lessons-with-own")
    expect(card(teacher, "10 min")).to_have_count(1)


def open_folder(teacher, folder):
    """Choose a folder as the one of a lesson."""
    with teacher.page.expect_file_chooser() as chooser:
        teacher.command("Add a lesson", "From a folder…")
    chooser.value.set_files(folder)


def test_what_is_missing_is_shown_at_its_place_and_in_a_list(teacher):
    begin(teacher)
    teacher.dialog().get_by_role("button", name="Save lesson").click()
    found = teacher.dialog().get_by_role("alert")
    expect(found).to_contain_text("2 things are missing or wrong")
    found.get_by_role("button", name="Step 1 · Title").click()
    title = teacher.dialog().get_by_label("Title of the step")
    expect(title).to_have_attribute("aria-invalid", "true")
    title.fill("Drive")
    expect(title).to_have_attribute("aria-invalid", "false")


def test_a_check_is_said_in_words_while_it_is_written(teacher):
    begin(teacher)
    part(teacher, re.compile("^1\\."))
    sentence = teacher.dialog().locator(".maker-sentence").first
    fill_check(teacher, "never")
    expect(sentence).to_contain_text("bump")
    fill_check(teacher, "uses")
    expect(sentence).to_contain_text("Fill in the fields")
    teacher.dialog().get_by_label("Part of a program").select_option("loop")
    expect(sentence).to_contain_text("loop")


def test_the_checks_are_tried_on_the_solution(teacher):
    make(teacher)
    part(teacher, "For the teacher")
    teacher.dialog().get_by_role("button", name="Try the checks on the solutions").click()
    tried = teacher.dialog().locator(".maker-tried li")
    expect(tried.first).to_contain_text("Step 1: the solution passes in 1 of 1 runs", timeout=60000)
    expect(tried.last).to_contain_text("Step 2 has checks, but no solution.")


def test_a_lesson_is_written_in_two_languages(teacher, own_server):
    make(teacher)
    part(teacher, "About the lesson")
    teacher.dialog().get_by_role("button", name="Español").click()
    title = teacher.dialog().get_by_label("Title")
    expect(title).to_have_attribute("placeholder", re.compile("My drive"))
    title.fill("Mi viaje")
    save(teacher)
    (file,) = (own_server.home / "lessons").iterdir()
    lesson = zipfile.ZipFile(file).read("lesson.toml").decode()
    assert 'en = "My drive"' in lesson
    assert 'es = "Mi viaje"' in lesson


@pytest.mark.certain
def test_what_is_not_saved_is_still_there_after_closing(teacher):
    begin(teacher)
    teacher.page.keyboard.press("Escape")
    expect(teacher.dialog()).to_have_count(0)
    teacher.expect_note("“My drive” is not saved.").get_by_role("button").first.click()
    expect(teacher.dialog().get_by_label("Title")).to_have_value("My drive")


@pytest.mark.certain
def test_what_is_not_saved_survives_a_reload_until_it_is_discarded(teacher):
    begin(teacher)
    teacher.page.reload()
    teacher.project("Make a lesson of this project…")
    title = teacher.dialog().get_by_label("Title")
    expect(title).to_have_value("My drive")
    teacher.dialog().get_by_role("button", name="Discard changes").click()
    expect(teacher.dialog()).to_have_count(0)
    teacher.project("Make a lesson of this project…")
    expect(title).to_have_value(teacher.name_of_project())


def test_a_saved_lesson_is_shown_as_it_is_saved_once_its_changes_are_discarded(teacher):
    make(teacher)
    part(teacher, "About the lesson")
    title = teacher.dialog().get_by_label("Title")
    title.fill("My long drive")
    discard = teacher.dialog().get_by_role("button", name="Discard changes")
    discard.click()
    expect(title).to_have_value("My drive")
    expect(discard).to_have_count(0)


def test_a_lesson_is_written_by_keyboard(teacher):
    begin(teacher)
    keys = Typist(teacher)
    teacher.dialog().get_by_label("Title").focus()
    keys.walk("Tab", "^Minutes")
    keys.press("ArrowUp")
    expect(teacher.dialog().get_by_label("Minutes")).to_have_value("31")
    teacher.dialog().get_by_role("navigation").get_by_role("button").first.focus()
    keys.walk("Tab", "^Add a step")
    keys.press("Enter")
    expect(teacher.dialog().get_by_role("heading", name="2. New step")).to_be_visible()
    keys.walk("Tab", "^Move this step up")
    keys.press("Enter")
    expect(teacher.dialog().get_by_role("heading", name="1. New step")).to_be_visible()
    keys.walk("Tab", "^Save lesson")
    keys.press("Enter")
    expect(teacher.dialog().get_by_role("alert")).to_be_focused()


def test_a_step_gets_a_puzzle_of_the_open_program(teacher, own_server):
    make(teacher)
    part(teacher, re.compile("^1\\."))
    teacher.dialog().get_by_label("Let pupils put the lines").check()
    shown = teacher.dialog().get_by_label("Program in the right order")
    expect(shown).to_have_value(re.compile("move_straight"))
    fill(teacher, "Lines that don't belong to it", "function.turn(90)")
    save(teacher)
    (file,) = (own_server.home / "lessons").iterdir()
    assert "programs/puzzle-1.bt" in zipfile.ZipFile(file).namelist()


def test_a_puzzle_gets_another_right_order(teacher, own_server):
    make(teacher)
    part(teacher, re.compile("^1\\."))
    teacher.dialog().get_by_label("Let pupils put the lines").check()
    teacher.dialog().get_by_role("button", name="Add another right order").click()
    also = teacher.dialog().get_by_label("The same lines in another order")
    expect(also).to_have_value(re.compile("move_straight"))
    also.fill("main:\n    function.stop_bot()\nend\n")
    teacher.dialog().get_by_role("button", name="Save lesson").click()
    expect(teacher.dialog()).to_contain_text("This order has other pieces than 'puzzle-1.bt'")
    teacher.dialog().get_by_label("Program in the right order").fill(
        "main:\n    function.stop_bot()\nend\n"
    )
    save(teacher)
    (file,) = (own_server.home / "lessons").iterdir()
    assert "also = [" in zipfile.ZipFile(file).read("lesson.toml").decode()


@pytest.mark.parametrize("theme", ["light", "dark", "contrast"])
@pytest.mark.parametrize("width", [1366, 390])
def test_the_editor_is_accessible_in_all_themes_and_sizes(own_server, sit_down, axe, theme, width):
    small_lesson.put_in(own_server.home)
    height = {1366: 768, 390: 844}[width]
    viewport = {"width": width, "height": height}
    teacher = sit_down(own_server, start=True, viewport=viewport, theme=theme)
    teacher.page.get_by_role("button", name="1 · First drive").click()
    # One of ours has the same title.
    own = card(teacher, "10 min")
    own.get_by_role("button", name="More for First drive").click()
    teacher.page.get_by_role("menuitem", name="Change…", exact=True).click()
    for name in ("About the lesson", re.compile("^1\\."), re.compile("^2\\."), "For the teacher"):
        part(teacher, name)
        teacher.picture(f"{theme}-{width}-{name if isinstance(name, str) else name.pattern[1]}")
        assert faults(teacher, axe) == []
    assert teacher.page.evaluate("document.documentElement.scrollWidth") <= width


@pytest.mark.parametrize(("theme", "width"), [("light", 390), ("dark", 1366), ("contrast", 390)])
def test_notes_and_solutions_are_accessible(own_server, sit_down, axe, theme, width):
    viewport = {"width": width, "height": {1366: 768, 390: 844}[width]}
    teacher = sit_down(own_server, start=True, viewport=viewport, theme=theme)
    teacher.page.get_by_role("button", name="1 · First drive").click()
    our_lesson(teacher, "Notes and solutions")
    teacher.dialog().get_by_text("Typical wrong programs").first.click()
    expect(teacher.dialog().get_by_text("The hint for it:").first).to_be_visible()
    teacher.picture(f"notes-{theme}-{width}")
    assert faults(teacher, axe) == []
    assert teacher.page.evaluate("document.documentElement.scrollWidth") <= width
