"""Worlds as files, and projects that bring what they need."""

import pytest
from playwright.sync_api import expect

import homes
from learnblock.project.files.packing import encode_whole
from learnblock.project.files.project import Project
from shared_worlds import ROOM

WAVE = "main:\n    function.expressJoy()\nend\n"
DROP = """(text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], "room.toml"));
    return data;
}"""


@pytest.fixture
def pupil(own_server, sit_down):
    pupil = sit_down(own_server, reduced_motion="reduce")
    pupil.begin()
    return pupil


def world_menu(pupil, command):
    pupil.menu("World").click()
    pupil.page.get_by_role("menuitem", name=command).click()


def test_a_world_is_imported_renamed_downloaded_deleted_and_restored(pupil, own_server, tmp_path):
    file = tmp_path / "room.toml"
    file.write_text(ROOM)
    with pupil.page.expect_file_chooser() as chooser:
        world_menu(pupil, "Import world…")
    chooser.value.set_files(file)
    pupil.expect_chosen("World", "Room")
    pupil.menu("World").click()
    pupil.picture("menu")
    pupil.page.get_by_role("menuitem", name="Rename…").click()
    pupil.dialog().get_by_label("Name").fill("Ana's room")
    pupil.picture("rename")
    pupil.dialog().get_by_role("button", name="Rename").click()
    pupil.expect_chosen("World", "Ana's room")
    with pupil.page.expect_download() as started:
        world_menu(pupil, "Download world")
    assert started.value.suggested_filename == "room.toml"
    assert "Ana's room" in started.value.path().read_text()
    world_menu(pupil, "Delete")
    note = pupil.expect_note("Ana's room is in the trash.")
    pupil.expect_chosen("World", "Empty floor")
    pupil.picture("deleted")
    note.get_by_role("button", name="Restore").click()
    pupil.expect_chosen("World", "Ana's room")
    assert [path.stem for path in (own_server.home / "worlds").glob("*.toml")] == ["room"]


def test_a_dropped_world_is_imported(pupil):
    data = pupil.page.evaluate_handle(DROP, ROOM)
    pupil.page.dispatch_event("body", "drop", {"dataTransfer": data})
    pupil.expect_chosen("World", "Room")


def test_a_copy_of_a_world_has_the_name_that_the_user_gives_it(pupil):
    pupil.press("Edit world")
    field = pupil.dialog().get_by_label("Save as")
    expect(field).to_have_value("Empty floor 2")
    field.fill("Ana's room")
    pupil.dialog().get_by_role("button", name="Save and use").click()
    pupil.expect_note("Saved. Now using Ana's room.")
    pupil.picture("saved")
    expect(pupil.dialog()).to_have_count(0)
    pupil.expect_chosen("World", "Ana's room")
    pupil.press("Edit world")
    expect(pupil.dialog().get_by_label("Save as")).to_have_value("Ana's room")


def test_another_world_forgets_the_result_and_the_variables_of_the_last_run(pupil):
    pupil.write("blocktext", "x = 3\n" + WAVE)
    pupil.choose("Speed", "Fastest")
    pupil.press("Run")
    pupil.state("Ended")
    pupil.choose("World", "Line")
    pupil.state("Ready")
    expect(pupil.tab("Result")).to_contain_text("Run the program to see results.")
    expect(pupil.tab("Variables")).not_to_contain_text("3")
    pupil.picture("forgotten")


def test_a_project_from_elsewhere_brings_its_world_and_offers_its_code(
    pupil, tmp_path, monkeypatch, own_server
):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "author"))
    homes.furnish()
    project = Project("dance", homes.PROGRAM, world="mat", libraries={"moves": "1.0.0"})
    file = tmp_path / "dance.learnblock"
    file.write_bytes(encode_whole(project))
    pupil.upload(file)
    pupil.expect_project("dance")
    pupil.expect_chosen("World", "Mat")
    note = pupil.expect_note("This project brings code that is not installed here")
    pupil.picture("offered")
    assert not (own_server.home / "skills").exists()
    note.get_by_role("button", name="Review…").click()
    pupil.dialog().get_by_text("Custom block dances").click()
    expect(pupil.dialog()).to_contain_text("def waltz(robot):")
    pupil.picture("review")
    pupil.dialog().get_by_role("button", name="Install").click()
    pupil.expect_note("Installed.")
    expect(pupil.tab("Problems")).to_contain_text("No problems. The program is ready to run.")
    assert (own_server.home / "skills" / "dances.py").is_file()
    pupil.picture("installed")
