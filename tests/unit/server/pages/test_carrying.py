"""A project on its way from one user's folder to another's, as its pages see it."""

import json

import pytest

import homes
from learnblock.extensions import custom_blocks, worlds
from learnblock.extensions.worlds import PackedWorld
from learnblock.perception import tag_names
from learnblock.storage.home import home
from pages import serving
from shared_worlds import ROOM, png

TELL = """from learnblock.perception.tag_names import tag_id


def tell(robot):
    print(tag_id("door"))
"""


@pytest.fixture(autouse=True)
def at_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))


@pytest.fixture
def elsewhere(tmp_path, monkeypatch):
    """A server of another user, as a function."""

    def serve():
        monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "elsewhere"))
        return serving(tmp_path / "other projects", static=tmp_path / "static")

    return serve


@pytest.fixture
def made(page):
    """A project that needs everything that a user can have of their own."""
    homes.furnish()
    page.open("dance", homes.PROGRAM)
    page.say("ChooseWorld", name="mat")
    page.hear("Settings", world="mat")
    page.say("Export", format="learnblock")
    return page.hear("File")["text"]


def test_a_downloaded_project_opens_elsewhere_in_its_world(made, elsewhere):
    with elsewhere() as server, server.visit() as page:
        page.say("Import", filename="dance.learnblock", text=made)
        listed = page.hear("Worlds")["worlds"]
        [mat] = [each for each in listed if each["name"] == "mat"]
        assert (mat["title"], mat["own"]) == ("Mat", True)
        assert page.hear("Opened")["world"] == "mat"
        assert page.hear("Scene")["name"] == "mat"
        assert worlds.find("mat").picture == png(20, 10)
        assert tag_names.tag_names() == {"door": 12}


def test_code_is_installed_only_when_the_user_asks(made, elsewhere):
    with elsewhere() as server, server.visit() as page:
        page.say("Import", filename="dance.learnblock", text=made)
        offered = page.hear("CodeOffered")
        assert [one["name"] for one in offered["blocks"]] == ["dances", "turns"]
        assert offered["blocks"][0]["source"] == homes.WALTZ
        assert [one["name"] for one in offered["libraries"]] == ["moves"]
        assert not (home() / "skills").exists()
        assert not (home() / "libraries").exists()
        page.say("InstallOffered")
        assert page.hear("CodeOffered") == {"kind": "CodeOffered"}
        page.hear("Libraries")
        assert custom_blocks.find("dances").source == homes.WALTZ
        page.pulse()
        assert page.last["Document"].get("problems", []) == []


def test_the_file_in_the_projects_folder_carries_everything_too(made, page, projects, elsewhere):
    del made
    page.type(homes.PROGRAM + "\n")
    page.hear("Saved")
    data = (projects / "dance.learnblock").read_bytes()
    with elsewhere() as server, server.visit() as other:
        folder = projects.parent / "other projects"
        folder.mkdir()
        (folder / "dance.learnblock").write_bytes(data)
        other.say("Open", name="dance")
        assert other.hear("Opened")["world"] == "mat"
        assert other.hear("CodeOffered")["blocks"]


def test_a_project_saved_elsewhere_still_carries_what_was_not_installed(made, elsewhere):
    with elsewhere() as server, server.visit() as page:
        page.say("Import", filename="dance.learnblock", text=made)
        page.hear("CodeOffered")
        page.say("Export", format="learnblock")
        carried = json.loads(page.hear("File")["text"])["carried"]
        assert carried["offered"]["blocks"]["dances"]["source"][0] == "def waltz(robot):"


def test_the_saved_copy_is_that_of_the_changed_world(page, projects):
    worlds.install(PackedWorld("room", ROOM))
    page.open("p")
    page.say("ChooseWorld", name="room")
    page.hear("Settings", world="room")
    page.say("ReadWorld", name="room")
    world = {**page.hear("WorldToEdit")["world"], "ambient_light": 7.0}
    page.say("SaveWorld", name="room", world=world, replace=True)
    page.hear("Worlds")
    page.hear("Settings")
    page.hear("Saved")
    page.say("Export", format="learnblock")
    carried = json.loads(page.hear("File")["text"])["carried"]
    assert "ambient_light = 7.0" in carried["world"]["file"]
    assert projects.exists()


def test_a_run_uses_the_projects_own_numbers_of_tags(page):
    tag_names.save_names({"door": 7})
    custom_blocks.save("tells", TELL)
    text = ["main:", "    function.tell()", "end", ""]
    file = {"learnblock": 2, "blocktext": text, "tags": {"door": 12}}
    page.say("Import", filename="p.learnblock", text=json.dumps(file))
    assert page.hear("Failed")["message"]["code"] == "project-tag-differs"
    page.run()
    assert page.last["Printed"]["text"].startswith("12")


def test_a_name_that_the_user_gives_another_number_has_it_in_every_project(page):
    tag_names.save_names({"door": 7})
    file = {"learnblock": 2, "blocktext": ['print("door")', ""], "tags": {"door": 12}}
    page.say("Import", filename="p.learnblock", text=json.dumps(file))
    page.hear("Failed")
    page.say("SaveTags", names={"door": 8})
    page.hear("Tags", names={"door": 8})
    page.say("Export", format="learnblock")
    exported = json.loads(page.hear("File")["text"])
    assert "tags" not in exported
    assert exported["carried"]["tags"] == {"door": 8}


def test_old_files_open_unchanged(page, projects):
    page.say("Import", filename="p.learnblock", text='{"learnblock": 1, "blocktext": ["x = 1"]}')
    assert page.hear("Opened")["name"] == "p"
    assert page.hear("Document")["blocktext"].startswith("x = 1")
    page.pulse()
    assert page.heard["CodeOffered"] == page.heard["Noted"] == page.heard["Failed"] == 0


def test_a_copy_of_a_project_carries_the_same(made, page, projects):
    del made
    page.say("SaveAs", name="copy")
    page.hear("Opened", name="copy")
    page.hear("Saved")
    file = json.loads((projects / "copy.learnblock").read_text())
    assert file["carried"]["world"]["name"] == "mat"
