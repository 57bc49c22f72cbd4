"""Projects: saved automatically, safe from crashes, uploaded and downloaded."""

import json
import os
import re
import signal

import pytest
from playwright.sync_api import expect

from old_projects import forever, main, project, skill
from waiting import wait_for

FOREVER = """\
main:
    while True:
        function.turn_right()
        function.sleep(1)
    end
end
"""
#: The drafts that the browser keeps, as JSON.
DRAFTS = """() => new Promise((done, failed) => {
    const opening = indexedDB.open("keyval-store");
    opening.onerror = failed;
    opening.onsuccess = () => {
        const reading = opening.result.transaction("keyval").objectStore("keyval").getAll();
        reading.onsuccess = () => { opening.result.close(); done(JSON.stringify(reading.result)); };
    };
})"""
WAVE = "main:\n    function.expressJoy()\nend\n"


def test_a_new_project_has_the_name_that_its_owner_gives_it(own_server, sit_down):
    pupil = sit_down(own_server, flat=True)
    pupil.begin("My patrol")
    pupil.expect_project("My patrol")
    expect(pupil.dialog()).to_have_count(0)


def test_a_renamed_project_keeps_its_program_and_its_address(own_server, sit_down):
    # The first page makes the project of an example, whose name the new one cannot have.
    pupil = sit_down(own_server, flat=True)
    pupil.begin()
    wave(pupil)
    pupil.project("Rename…")
    expect(pupil.dialog().get_by_role("textbox")).to_have_value("program")
    pupil.picture("rename")
    pupil.answer("hello")
    pupil.expect_project("hello")
    pupil.wait_until_saved()
    pupil.page.reload()
    pupil.expect_project("hello")
    pupil.sees("blocktext", "function.expressJoy()")
    pupil.project("Rename…")
    for wish, reason in {
        "Square": "There is already a project named 'Square'",
        "a/b": "A project can't be called 'a/b'",
    }.items():
        pupil.answer(wish)
        expect(pupil.dialog()).to_contain_text(reason)
        expect(pupil.dialog().get_by_role("textbox")).to_have_value(wish)
    pupil.picture("refused")
    pupil.page.keyboard.press("Escape")
    pupil.expect_project("hello")


# Saving.


@pytest.mark.certain
def test_no_change_is_lost_when_the_server_is_killed(own_server, sit_down):
    pupil = sit_down(own_server, empty=True, flat=True)
    wave(pupil)
    pupil.wait_until_saved()
    own_server.kill()
    expect(pupil.page.get_by_role("alert").filter(has_text="Connection lost")).to_be_visible()
    pupil.picture("lost")
    pupil.put_cursor("blocktext", "end")
    pupil.page.keyboard.type("    function.sleep(7)\n")
    own_server.start()
    pupil.expect_note("Back online")
    pupil.picture("back")
    pupil.wait_until_saved()
    assert pupil.text("blocktext") == WAVE.replace("end", "    function.sleep(7)\nend")
    assert "sleep(7)" in saved(own_server, "program")
    assert pupil.foreign == []


@pytest.mark.certain
def test_saved_changes_survive_a_crash_of_the_computer(own_server, sit_down):
    pupil = sit_down(own_server, empty=True, flat=True)
    pupil.choose("World", "Line")
    wave(pupil)
    pupil.wait_until_saved()
    own_server.kill()
    pupil.page.close()
    own_server.start()
    pupil.page = pupil.open()
    pupil.expect_project("program")
    pupil.sees("blocktext", "function.expressJoy()")
    pupil.expect_chosen("World", "Line")


@pytest.mark.certain
def test_what_was_typed_without_a_server_survives_closing_the_page(own_server, sit_down):
    pupil = sit_down(own_server, empty=True, flat=True)
    wave(pupil)
    pupil.wait_until_saved()
    own_server.kill()
    pupil.put_cursor("blocktext", "end")
    pupil.page.keyboard.type("    function.sleep(7)\n")
    wait_for(lambda: "sleep(7)" in pupil.page.evaluate(DRAFTS), "a draft of the last edit")
    pupil.page.close()
    own_server.start()
    pupil.page = pupil.open()
    pupil.expect_note("They are back now")
    pupil.picture("recovered")
    pupil.sees("blocktext", "sleep(7)")
    pupil.wait_until_saved()
    assert "sleep(7)" in saved(own_server, "program")
    wait_for(lambda: pupil.page.evaluate(DRAFTS) == "[]", "no drafts")


@pytest.mark.certain
def test_the_browser_asks_before_it_closes_a_page_with_unsaved_changes(own_server, sit_down):
    pupil = sit_down(own_server, empty=True, flat=True)
    own_server.kill()
    pupil.put_cursor("blocktext", "pass")
    pupil.page.keyboard.type("# ")
    with pupil.page.expect_event("dialog") as asked:
        pupil.page.close(run_before_unload=True)
    assert asked.value.type == "beforeunload"
    asked.value.dismiss()


@pytest.mark.certain
def test_where_a_page_and_another_program_change_the_same_line_the_page_asks(own_server, sit_down):
    pupil = sit_down(own_server, empty=True, flat=True)
    wave(pupil)
    pupil.wait_until_saved()
    file = own_server.home / "projects" / "program.learnblock"
    os.kill(own_server.process.pid, signal.SIGSTOP)
    file.write_text(file.read_text("utf-8").replace("expressJoy()", "expressFear()"), "utf-8")
    pupil.put_cursor("blocktext", "function")
    pupil.page.keyboard.type("# ")
    os.kill(own_server.process.pid, signal.SIGCONT)
    pupil.expect_note("the other one is in the history")
    pupil.picture("conflict")
    pupil.page.get_by_role("button", name="Use the other one").click()
    pupil.sees("blocktext", "expressFear")


@pytest.mark.certain
def test_a_new_tab_finds_the_program_still_running_when_the_page_was_closed(pupil):
    pupil.begin()
    turn_forever(pupil)
    pupil.press("Run")
    pupil.state("Running")
    project = pupil.page.url
    pupil.page.close()
    pupil.page = pupil.open(project)
    pupil.state("Running")
    expect(pupil.page.locator(".lbRunning")).not_to_have_count(0)
    pupil.picture("still-running")
    pupil.press("Stop")
    pupil.state("Ended")


# Several projects, several tabs.


def test_a_project_is_copied_opened_again_and_deleted(own_server, sit_down):
    pupil = sit_down(own_server, empty=True, flat=True)
    wave(pupil)
    pupil.wait_until_saved()
    pupil.project("Save as…")
    pupil.answer("My first wave")
    pupil.expect_project("My first wave")
    pupil.sees("blocktext", "expressJoy")
    pupil.project("Open…")
    expect(pupil.dialog().locator("strong").first).to_have_text("My first wave")
    pupil.picture("open")
    pupil.dialog().get_by_role("button", name=re.compile("^program")).click()
    pupil.expect_project("program")
    pupil.project("Delete…")
    pupil.picture("delete")
    pupil.dialog().get_by_role("button", name="Delete", exact=True).click()
    start = pupil.page.get_by_role("main", name="Home")
    expect(start.get_by_role("button", name=re.compile("^My first wave"))).to_be_visible()
    expect(start.get_by_role("button", name=re.compile("^program"))).to_have_count(0)
    pupil.page.keyboard.press("Control+o")
    expect(pupil.dialog().get_by_role("button", name=re.compile("^program"))).to_have_count(0)
    assert list(own_server.home.rglob(".trash/*/program.learnblock"))


def test_the_back_button_returns_to_the_previous_project(pupil):
    pupil.begin()
    wave(pupil)
    pupil.wait_until_saved()
    name = pupil.name_of_project()
    pupil.open_example("Polygons")
    pupil.page.go_back()
    pupil.expect_project(name)
    pupil.sees("blocktext", "expressJoy")


@pytest.mark.certain
def test_the_version_of_an_earlier_run_is_restored(pupil):
    pupil.begin()
    pupil.write("blocktext", WAVE)
    pupil.choose("Speed", "Fastest")
    pupil.press("Run")
    pupil.state("Ended")
    turn_forever(pupil)
    pupil.project("History…")
    runs = pupil.dialog().locator("section", has_text="Runs").get_by_role("listitem")
    expect(runs).to_contain_text("Finished")
    pupil.picture("history")
    runs.get_by_role("button").click()
    pupil.sees("blocktext", "expressJoy")
    expect(pupil.blocks("lb_skill_turn_right")).to_have_count(0)


def test_an_example_opens_as_a_new_project(pupil):
    pupil.project("Examples…")
    expect(pupil.dialog().get_by_role("listitem")).not_to_have_count(0)
    pupil.picture("gallery")
    pupil.dialog().get_by_role("button", name="Line with states").click()
    expect(pupil.page.locator("header .project-name")).to_have_text(re.compile("^Line with states"))
    pupil.expect_chosen("World", "Line")
    expect(pupil.blocks("lb_when")).to_have_count(3)
    pupil.picture("opened")


def test_two_tabs_of_one_project_stay_in_step(pupil):
    pupil.begin()
    first, second = pupil.page, pupil.open(pupil.page.url)
    pupil.page = second
    pupil.write("blocktext", WAVE)
    pupil.page = first
    pupil.sees("blocktext", "function.expressJoy()")
    pupil.press("Run")
    pupil.page = second
    pupil.state("Ended")
    expect(pupil.page.get_by_role("tabpanel", name="Console")).to_contain_text("Finished")


def test_two_tabs_with_two_projects_run_two_programs_at_once(pupil):
    first = pupil.page
    pupil.begin()
    turn_forever(pupil)
    pupil.page = pupil.open()
    pupil.begin()
    pupil.write("blocktext", FOREVER.replace("right", "left"))
    expect(pupil.blocks("lb_skill_turn_left")).to_be_visible()
    assert pupil.page.url != first.url
    for page in (first, pupil.page):
        pupil.page = page
        pupil.press("Run")
        pupil.state("Running")
    pupil.press("Stop")
    pupil.state("Ended")
    pupil.page = first
    pupil.state("Running")
    pupil.press("Stop")
    pupil.state("Ended")


# Files.


def test_a_project_is_downloaded_and_uploaded_again(pupil, tmp_path):
    pupil.begin()
    pupil.choose("Robot", "Cozmo")
    wave(pupil)
    pupil.wait_until_saved()
    files = [download(pupil, way, tmp_path) for way in ("File", "Block-Text", "Python")]
    assert [file.suffix for file in files] == [".learnblock", ".bt", ".py"]
    assert files[1].read_text() == WAVE
    for file in files:
        before = pupil.page.url
        pupil.upload(file)
        expect(pupil.page).not_to_have_url(before)
        pupil.sees("blocktext", "function.expressJoy()")


def test_a_file_dropped_on_the_page_becomes_a_project(pupil):
    drag_file(pupil, "dragover", "wave.bt", WAVE)
    expect(pupil.page.get_by_text("Drop the file to open it")).to_be_visible()
    pupil.picture("over")
    drag_file(pupil, "drop", "wave.bt", WAVE)
    pupil.expect_project("wave")
    pupil.sees("blocktext", "function.expressJoy()")


@pytest.mark.parametrize(
    ("name", "text", "sentence"),
    [
        ("holiday.jpg", "no program", "LearnBlock can't open this type of file: holiday.jpg"),
        ("broken.learnblock", "{ no JSON", "This file is damaged or not a LearnBlock project"),
        ("long.bt", "#" * 1_000_001, "long.bt is too large"),
    ],
)
def test_an_invalid_file_is_refused_with_an_explanation(pupil, tmp_path, name, text, sentence):
    before = pupil.page.url
    file = tmp_path / name
    file.write_text(text)
    pupil.upload(file)
    pupil.expect_note(sentence)
    pupil.picture("refused")
    assert pupil.page.url == before


def wave(pupil):
    pupil.write("blocktext", WAVE)
    expect(pupil.blocks("lb_skill_expressJoy")).to_be_visible()


def turn_forever(pupil):
    pupil.write("blocktext", FOREVER)
    expect(pupil.blocks("lb_skill_turn_right")).to_be_visible()


def saved(server, name):
    (file,) = server.home.rglob(f"{name}.learnblock")
    return "\n".join(json.loads(file.read_text())["blocktext"])


def download(pupil, way, folder):
    with pupil.page.expect_download() as started:
        pupil.share(way)
    # The dialog stays open for another way.
    pupil.page.keyboard.press("Escape")
    file = folder / started.value.suggested_filename
    started.value.save_as(file)
    return file


def drag_file(pupil, what, name, text):
    files = pupil.page.evaluate_handle(
        """([name, text]) => {
            const files = new DataTransfer();
            files.items.add(new File([text], name));
            return files;
        }""",
        [name, text],
    )
    pupil.page.locator("[data-region=blocks]").dispatch_event(what, {"dataTransfer": files})


# Projects of the original LearnBlock.


def test_a_project_of_the_original_learnblock_opens_and_says_what_changed(pupil, tmp_path):
    file = tmp_path / "old.blockProject"
    file.write_bytes(project(main(forever(skill("mover_derecha"), skill("subscribe")))))
    pupil.upload(file)
    pupil.expect_project("old")
    expect(pupil.dialog()).to_contain_text("'mover_derecha' is now called 'move_right'")
    expect(pupil.dialog()).to_contain_text("'when message = function.received()'")
    pupil.picture("imported")
    pupil.dialog().get_by_role("button", name="OK").click()
    expect(pupil.dialog()).to_have_count(0)
    assert "function.move_right()" in pupil.text("blocktext")
