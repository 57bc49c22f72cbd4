"""Kept runs: looked back at, named, downloaded, deleted, and opened from a file."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.certain

DRIVING = """\
count = 0
main:
    repeat {times}:
        count += 1
        function.move_straight(60)
        function.sleep(1)
    end
    print(count)
end
"""


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with a run of one second, and a newer one of two."""
    pupil = sit_down(server, empty=True, flat=True)
    pupil.choose("Speed", "Fastest")
    for times in (1, 2):
        pupil.write("blocktext", DRIVING.format(times=times))
        pupil.wait_until_saved()
        pupil.run_to_the_end()
    pupil.tab("Runs")
    expect(rows(pupil)).to_have_count(2)
    return pupil


def rows(pupil):
    return pupil.page.locator(".run-row")


def show(pupil, index):
    rows(pupil).nth(index).locator(".row-main").click()
    expect(pupil.page.locator(".shown-run")).to_contain_text("Run shown")


def timeline(pupil):
    return pupil.page.get_by_role("slider", name="Moment of the run")


def name(pupil, index, title):
    rows(pupil).nth(index).get_by_role("button", name=re.compile("^Name ")).click()
    pupil.page.get_by_label("Name", exact=True).fill(title)
    pupil.page.keyboard.press("Enter")


def test_an_older_run_is_shown_with_its_timeline_its_variables_and_its_output(pupil):
    expect(rows(pupil).nth(1)).to_contain_text("Finished · 1.0 s · EBO in")
    show(pupil, 1)
    expect(timeline(pupil)).to_have_attribute("max", "1")
    note = pupil.page.locator(".shown-run")
    expect(note).to_contain_text("answers name lines of the older program")
    pupil.picture("kept-run")
    expect(pupil.tab("Console")).to_contain_text("1")
    pupil.tab("Variables")
    expect(pupil.page.get_by_role("row", name=re.compile("^count "))).to_contain_text("1")
    pupil.press("Back to the newest run")
    expect(timeline(pupil)).to_have_attribute("max", "2")
    expect(note).to_have_count(0)
    expect(pupil.page.locator(".status")).to_contain_text("Ended · 2.0 s")


def test_back_to_now_and_run_lead_to_the_newest_run(pupil):
    show(pupil, 1)
    pupil.press("Back to now")
    expect(timeline(pupil)).to_have_attribute("max", "2")
    show(pupil, 1)
    pupil.press("Run")
    expect(pupil.page.locator(".shown-run")).to_have_count(0)
    pupil.wait_for_the_end()
    expect(rows(pupil)).to_have_count(3)


def test_an_edit_makes_the_run_one_of_an_older_program_which_can_be_used_again(pupil):
    show(pupil, 0)
    expect(pupil.page.locator(".shown-run")).not_to_contain_text("older")
    pupil.write("blocktext", "main:\n    print(7)\nend\n")
    expect(pupil.page.locator(".shown-run")).to_contain_text("older program")
    pupil.press("Use its program again")
    pupil.sees("blocktext", "repeat 2:")


def test_a_named_run_is_found_after_a_reload_and_asks_before_it_is_deleted(pupil):
    name(pupil, 1, "my best")
    expect(rows(pupil).nth(1)).to_contain_text("my best")
    pupil.page.reload()
    pupil.tab("Runs")
    expect(rows(pupil).nth(1)).to_contain_text("my best")
    pupil.page.get_by_role("button", name="Delete my best").click()
    pupil.page.get_by_role("button", name="Delete run").click()
    expect(rows(pupil)).to_have_count(1)


def test_a_run_is_taken_to_another_project_as_a_file(pupil, tmp_path):
    name(pupil, 1, "my best")
    with pupil.page.expect_download() as download:
        pupil.page.get_by_role("button", name="Download my best").click()
    assert download.value.suggested_filename == "my best.why"
    file = tmp_path / "from home.why"
    download.value.save_as(file)
    with pupil.page.expect_file_chooser() as chooser:
        pupil.press("Open a run from a file")
    chooser.value.set_files(file)
    expect(pupil.page.locator(".shown-run")).to_contain_text("Run shown: from home.")
    expect(timeline(pupil)).to_have_attribute("max", "1")


@pytest.mark.parametrize(
    ("name", "words"),
    [("letter.why", "not the log of a run"), ("letter.txt", "letter.txt is not a run")],
)
def test_a_file_that_is_no_run_is_refused_in_words(pupil, tmp_path, name, words):
    file = tmp_path / name
    file.write_text("Dear robot,")
    with pupil.page.expect_file_chooser() as chooser:
        pupil.press("Open a run from a file")
    chooser.value.set_files(file)
    pupil.expect_note(words)


def test_the_keyboard_opens_a_run_and_leaves_it(pupil):
    row = rows(pupil).nth(1).locator(".row-main")
    row.focus()
    pupil.page.keyboard.press("Enter")
    expect(row).to_have_attribute("aria-pressed", "true")
    pupil.page.keyboard.press("Enter")
    expect(row).to_have_attribute("aria-pressed", "false")


def compare(pupil):
    for row in rows(pupil).all():
        row.get_by_role("checkbox").check()
    pupil.press("Compare")
    comparison = pupil.page.get_by_role("region", name="Comparison")
    expect(comparison).to_be_visible()
    return comparison


def test_two_runs_are_compared_and_their_ways_drawn_over_each_other(pupil):
    comparison = compare(pupil)
    expect(comparison).to_contain_text("Both runs did the same until 1.00 s.")
    expect(comparison).to_contain_text("was edited: for _ in range(1): became for _ in range(2):")
    legend = pupil.page.get_by_role("list", name="Ways of the compared runs")
    expect(legend.get_by_role("listitem")).to_have_count(2)
    pupil.picture("compared-runs")
    pupil.press("End comparison")
    expect(legend).to_have_count(0)


def test_the_moment_at_which_they_part_is_shown_in_either_run(pupil):
    comparison = compare(pupil)
    links = comparison.locator(".moment-link")
    links.nth(1).click()
    expect(timeline(pupil)).to_have_attribute("max", "2")
    expect(timeline(pupil)).to_have_attribute("aria-valuetext", re.compile("^1.00 s"))
    expect(comparison).to_be_visible()


def test_a_new_run_ends_the_comparison(pupil):
    comparison = compare(pupil)
    pupil.press("Run")
    expect(comparison).to_have_count(0)


def test_the_calls_of_two_runs_are_shown_at_the_same_places(pupil):
    compare(pupil)
    pupil.press("Calls side by side")
    dialog = pupil.page.get_by_role("dialog")
    expect(dialog).to_contain_text("All rows have the same functions.")
    first, second = dialog.locator(".calls svg").all()
    turns = [
        graph.get_by_role("button", name=re.compile("^move_straight,")) for graph in (first, second)
    ]
    places = [turn.get_attribute("transform") for turn in turns]
    assert places[0] == places[1]
    expect(second).to_contain_text("2×")
    pupil.picture("calls-beside")
    turns[1].focus()
    pupil.page.keyboard.press("Enter")
    expect(dialog).to_have_count(0)
    expect(timeline(pupil)).to_have_attribute("aria-valuetext", re.compile("^0.00 s"))
    expect(timeline(pupil)).to_have_attribute("max", "2")
