"""Messages between page and server about the user's own worlds."""

import base64

import pytest

from learnblock.extensions import worlds
from learnblock.extensions.worlds import PackedWorld
from learnblock.robots.simulated import own_worlds
from pages import english
from shared_worlds import MAT, OTHER_ROOM, ROOM, png

pytestmark = pytest.mark.realtime

RUNS = "main:\n    function.move_straight(50)\nend\n"


@pytest.fixture(autouse=True)
def own_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))


@pytest.fixture
def open_page(page):
    page.open("p", RUNS)
    page.pulse()
    return page


def imported(page, filename, content):
    page.say("ImportWorld", filename=filename, content=base64.b64encode(content).decode())
    return page.hear("Settings")["world"]


def own(page):
    return {one["name"]: one["title"] for one in page.hear("Worlds")["worlds"] if one["own"]}


def test_an_imported_world_is_listed_and_chosen(open_page):
    assert imported(open_page, "room.toml", ROOM.encode()) == "room"
    assert open_page.last["Worlds"]["worlds"]
    assert open_page.last["Scene"]["name"] == "room"


def test_the_gallery_is_told_when_ones_own_world_was_changed(open_page):
    imported(open_page, "room.toml", ROOM.encode())
    (room,) = (one for one in open_page.last["Worlds"]["worlds"] if one["own"])
    assert room["changed"] == (own_worlds() / "room.toml").stat().st_mtime


def test_a_world_that_is_read_for_a_picture_answers_that_request(open_page):
    open_page.say("ReadWorld", name="line", request=7)
    answer = open_page.hear("WorldToEdit")
    assert (answer["name"], answer["request"]) == ("line", 7)


def test_a_world_comes_back_from_its_exported_file(open_page):
    packed = PackedWorld("mat", MAT, png(20, 10))
    worlds.install(packed)
    open_page.say("ExportWorld", name="mat")
    exported = open_page.hear("WorldExported")
    assert exported["filename"] == "mat.zip"
    worlds.delete("mat")
    (own_worlds() / "mat.png").unlink()
    assert imported(open_page, "mat.zip", base64.b64decode(exported["content"])) == "mat"
    assert worlds.find("mat") == packed


def test_a_second_world_of_the_same_name_is_told_apart_in_the_list(open_page):
    worlds.install(PackedWorld("room", ROOM))
    open_page.say(
        "ImportWorld", filename="room.toml", content=base64.b64encode(OTHER_ROOM.encode()).decode()
    )
    assert own(open_page) == {"room": "Room", "room-2": "Room 2"}


@pytest.mark.parametrize(
    ("filename", "content", "words"),
    [
        ("room.txt", b"", "Choose a .toml or .zip file"),
        ("room.zip", b"no zip", "This .zip file is damaged"),
        ("room.toml", b"wall = 3", "wall"),
    ],
)
def test_a_file_that_is_no_world_is_refused(open_page, filename, content, words):
    content = base64.b64encode(content).decode()
    open_page.say("ImportWorld", filename=filename, content=content)
    assert words in english(open_page.hear("Failed")["message"])


def test_a_renamed_world_has_its_new_title_in_the_list(open_page):
    worlds.install(PackedWorld("room", ROOM))
    open_page.say("RenameWorld", name="room", title="Ana's room")
    assert own(open_page) == {"room": "Ana's room"}


@pytest.mark.certain
def test_a_deleted_world_is_left_by_every_project_and_can_be_restored(server, open_page):
    assert imported(open_page, "room.toml", ROOM.encode()) == "room"
    with server.visit() as other:
        other.open("other", RUNS)
        other.say("ChooseWorld", name="room")
        other.hear("Settings", world="room")
        open_page.say("DeleteWorld", name="room")
        assert open_page.hear("Settings")["world"] == "empty"
        assert open_page.hear("WorldDeleted") == {
            "kind": "WorldDeleted",
            "name": "room",
            "title": "Room",
        }
        other.hear("Settings", world="empty")
    open_page.say("RestoreWorld", name="room")
    assert open_page.hear("Settings")["world"] == "room"


@pytest.mark.parametrize("kind", ["RenameWorld", "DeleteWorld"])
def test_a_built_in_world_can_be_neither_renamed_nor_deleted(open_page, kind):
    open_page.say(kind, name="line", **({"title": "x"} if kind == "RenameWorld" else {}))
    assert "line" in english(open_page.hear("Failed")["message"])


def test_a_world_in_which_a_program_runs_is_not_deleted(open_page):
    imported(open_page, "room.toml", ROOM.encode())
    open_page.type("main:\n    function.sleep(600)\nend\n")
    open_page.say("Run")
    open_page.hear("RunState", state="running")
    open_page.say("DeleteWorld", name="room")
    open_page.hear("Failed")
    assert worlds.own_names() == ("room",)
    open_page.say("Stop")
    open_page.hear("Ended")


def test_the_result_of_a_run_is_forgotten_in_another_world(server, open_page):
    open_page.say("SetSpeed", factor=None)
    open_page.run()
    open_page.say("ChooseWorld", name="line")
    assert open_page.hear("RunState")["state"] == "idle"
    with server.visit() as other:
        other.say("Open", name="p")
        assert other.hear("RunState")["state"] == "idle"
        other.pulse()
        assert other.heard["Ended"] == 0
        assert other.heard["Variables"] == 0


def test_the_result_of_a_run_stays_when_its_world_is_reset(server, open_page):
    open_page.say("SetSpeed", factor=None)
    open_page.run()
    open_page.say("ResetWorld")
    open_page.hear("Scene")
    with server.visit() as other:
        other.say("Open", name="p")
        assert other.hear("Ended")["ended"]


def test_a_checked_world_is_told_with_the_goals_that_cannot_be_reached(open_page):
    wall = {"points": [[0, -1000], [0, 1000]]}
    goal = {"reach": [{"name": "finish", "x": 600, "y": 0}]}
    start = [{"x": -600, "y": 0}]
    open_page.say("CheckWorld", world={"wall": [wall], "goal": goal, "start": start})
    checked = open_page.hear("WorldChecked")
    assert checked["problems"] == []
    (told,) = checked["unreachable"]
    assert (told["sort"], told["index"]) == ("reach", 0)
    assert english(told["reason"]) == "The goal 'finish' cannot be reached: a wall is in the way."


def test_a_world_with_mistakes_is_not_searched_for_ways(open_page):
    open_page.say("CheckWorld", world={"floor": {"size": [1, 1]}})
    checked = open_page.hear("WorldChecked")
    assert checked["problems"]
    assert not checked.get("unreachable")


def test_a_world_is_made_from_a_template(open_page):
    made = []
    for _ in range(2):
        open_page.say("MakeWorld", template="track", size=4, seed=12)
        made.append(open_page.hear("WorldMade")["world"])
    assert made[0] == made[1]
    assert made[0]["line"][0]["closed"]
    open_page.say("CheckWorld", world=made[0])
    checked = open_page.hear("WorldChecked")
    assert not checked["problems"]
    assert not checked.get("unreachable")
