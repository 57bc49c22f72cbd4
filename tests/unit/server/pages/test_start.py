"""What the start page asks of the server."""

import base64

import pytest

from learnblock.i18n import Phrase
from learnblock.project.files.picture import LARGEST_PICTURE
from pages import TOKEN

JPEG = bytes.fromhex("ffd8ffc0000b0801000100010101 00")
OTHER = "main:\n    function.sleep(2)\nend\n"


def english(phrase):
    return str(Phrase(phrase["code"], **phrase.get("values", {})))


def names(page):
    return [one["name"] for one in page.pulse()["projects"]]


def try_example(page, example="first-square", robot=""):
    page.say("OpenExample", name="Drive a square", example=example, robot=robot)
    return page.hear("Opened")


def test_an_example_is_one_project_until_it_is_changed(page):
    assert try_example(page)["name"] == "Drive a square"
    page.hear("Document")
    assert try_example(page)["name"] == "Drive a square"
    page.hear("Document")
    page.type(OTHER)
    page.hear("Saved")
    assert try_example(page)["name"] == "Drive a square 2"
    page.say("Open", name="Drive a square")
    page.hear("Opened")
    assert try_example(page)["name"] == "Drive a square 2"
    assert sorted(names(page)) == ["Drive a square", "Drive a square 2"]


def test_the_users_robot_is_taken_for_an_example_that_it_can_run(page):
    assert try_example(page)["robot"] == "sim-ev3"
    assert try_example(page, robot="sim-thymio")["robot"] == "sim-thymio"
    # Thymio has no camera to see the tag with.
    assert try_example(page, "first-tag", "sim-thymio")["robot"] == "sim-ebo"
    # The programs of a team are for their own robots.
    assert try_example(page, "sumo", "sim-thymio")["robot"] == "sim-ebo"


def test_an_empty_program_is_for_the_users_robot(page):
    page.say("New", name="mine", robot="sim-thymio")
    assert page.hear("Opened")["robot"] == "sim-thymio"
    page.say("New", name="wrong", robot="sim-nothing")
    assert page.hear("Failed")["refused"] == "New"
    assert names(page) == ["mine"]


def test_a_page_that_has_closed_its_project_has_saved_it_and_has_none(page, projects):
    page.open("one")
    page.type(OTHER)
    page.say("CloseProject")
    page.hear("Saved")
    page.say("Stop")
    assert page.hear("Failed")["message"]["code"] == "server-no-project"
    assert "sleep(2)" in (projects / "one.learnblock").read_text("utf-8")


def test_a_closed_project_is_renamed_copied_exported_and_deleted(page, projects):
    page.open("one", OTHER)
    page.say("CloseProject")
    page.say("RenameProject", project="one", name="two")
    page.say("CopyProject", project="two", name="copy")
    page.say("Export", format="bt", project="copy")
    assert page.hear("File")["text"] == OTHER
    assert sorted(names(page)) == ["copy", "two"]
    page.say("Delete", name="two")
    assert names(page) == ["copy"]
    assert [file.stem for file in projects.glob("*.learnblock")] == ["copy"]


def test_a_project_that_another_page_shows_is_not_renamed_from_the_start_page(server, page):
    page.open("one")
    with server.visit() as other:
        other.say("RenameProject", project="one", name="two")
        refused = other.hear("Failed")
    assert english(refused["message"]).startswith("The project 'one' is open.")
    assert names(page) == ["one"]


def test_a_picture_is_kept_with_the_project_and_served_with_the_token_only(server, page):
    page.open("one")
    page.say("KeepPicture", project="one", content=base64.b64encode(JPEG).decode())
    [entry] = page.hear("Projects")["projects"]
    assert entry["picture"] > 0
    path = "/projects/one/picture.jpg"
    response = server.get(path, Cookie=f"learnblock_token={TOKEN}")
    assert (response.body, response.headers["Content-Type"]) == (JPEG, "image/jpeg")
    assert server.get(path).status == 403
    page.say("SaveAs", name="copy")
    page.hear("Opened", name="copy")
    copied = server.get("/projects/copy/picture.jpg", Cookie=f"learnblock_token={TOKEN}")
    assert copied.body == JPEG


@pytest.mark.parametrize("path", ["nothing", "..", "%2e%2e", "a%2fb", ".history"])
def test_no_other_file_is_served_as_a_picture(server, path):
    response = server.get(f"/projects/{path}/picture.jpg", Cookie=f"learnblock_token={TOKEN}")
    assert response.status == 404


def test_a_picture_of_a_project_that_is_no_longer_open_is_not_kept(page):
    page.open("one")
    page.say("CloseProject")
    page.say("KeepPicture", project="one", content=base64.b64encode(JPEG).decode())
    page.say("ListProjects")
    [entry] = page.hear("Projects")["projects"]
    assert entry["picture"] == 0


def test_a_picture_that_is_too_large_or_none_is_refused(page):
    page.open("one")
    for content in (JPEG.ljust(LARGEST_PICTURE + 1, b"\0"), b"<svg/>"):
        page.say("KeepPicture", project="one", content=base64.b64encode(content).decode())
        assert page.hear("Failed")
    assert page.pulse()["projects"][0]["picture"] == 0
