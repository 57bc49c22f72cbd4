"""A class as pupils and the teacher use it: joining, working, the wall."""

import itertools
import json
import os
import subprocess
import sys
import zipfile
from io import BytesIO

import pytest
from websockets.exceptions import ConnectionClosed

from learnblock.project.files.folder import ProjectFolder

pytestmark = [pytest.mark.realtime, pytest.mark.slow]

DRIVE = "main:\n    function.drive_distance(100)\nend\n"
NAMES = (f"Ana {number}" for number in itertools.count())


@pytest.fixture
def ana(room):
    return room.pupil(next(NAMES))


@pytest.fixture
def leo(room):
    return room.pupil(next(NAMES))


def seat(wall, pupil, **values):
    """Wait until the wall shows a pupil with these values."""
    while True:
        for one in wall.hear("Seats")["seats"]:
            if one["id"] == pupil.id and all(
                one.get(key) == value for key, value in values.items()
            ):
                return one


def test_a_new_pupil_gets_pictures_and_comes_back_with_them(room):
    new = room.pupil("Mia")
    assert len(new.pictures) == 4
    again = room.join("mia", new.pictures)
    assert (again.status, again.json) == (200, {"address": new.address})
    assert again.cookie == new.cookie


def test_pupils_have_projects_of_their_own(ana, leo):
    with ana.page() as page:
        page.open("mine", DRIVE)
        page.say("CloseProject")
        page.pulse()
    with leo.page() as page:
        assert page.pulse()["projects"] == []
    assert [one.name for one in ProjectFolder(ana.folder / "projects").entries()] == ["mine"]


def test_a_pupil_finds_the_projects_again_on_another_device(room, ana):
    with ana.page() as page:
        page.open("mine", DRIVE)
    other = room.join(ana.name, ana.pictures)
    with ana.page(cookie=other.cookie) as page:
        assert [one["name"] for one in page.pulse()["projects"]] == ["mine"]


def test_a_pupil_goes_on_with_a_lesson_on_another_device(room, ana):
    lesson = {"lesson": "1-01-first-drive", "name": "First drive"}
    with ana.page() as page:
        page.say("Introduce", browser="a" * 32)
        page.say("StartLesson", **lesson)
        page.hear("LessonShown")
    other = room.join(ana.name, ana.pictures)
    with ana.page(cookie=other.cookie) as page:
        page.say("Introduce", browser="b" * 32)
        page.say("StartLesson", **lesson)
        assert page.hear("Opened")["name"] == "First drive"


def test_a_program_runs_on_simulated_robots_only(ana):
    with ana.page() as page:
        page.open("mine", DRIVE)
        assert page.run()["ended"] == "finished"
        names = {robot["name"] for robot in page.last.get("Welcome", {}).get("robots", [])}
        page.say("ChooseRobot", name="ev3")
        assert page.hear("Failed")["message"]["code"].startswith("unknown")
    assert not {name for name in names if not name.startswith("sim-")}


def test_the_wall_shows_what_a_pupil_does(room, ana):
    with room.wall() as wall, ana.page() as page:
        assert wall.hear("Wall")["word"] == room.word
        page.open("mine", DRIVE)
        # The robot may be seen only after its project.
        while not (shown := seat(wall, ana, here=True, project="mine")).get("pose"):
            pass
        assert shown["name"] == ana.name
        start = shown["pose"][0]
        page.run()
        # The last look at the robot may come after the end of the run.
        while (shown := seat(wall, ana, state="ended"))["pose"][0] < start + 90:
            pass
        assert shown.get("kept", 0) + len(shown.get("way", ()))
        assert wall.last["Plan"]["scene"]["world"]["floor"]


def test_the_wall_shows_mistakes_and_raised_hands(room, ana):
    with room.wall() as wall, ana.page() as page:
        page.open("mine", "main:\n    function.drive_distnce(100)\nend\n")
        # The project may be seen before its mistakes.
        while not (shown := seat(wall, ana, project="mine")).get("error"):
            pass
        assert shown["error"]["code"].startswith("check-")
        page.say("AskForHelp", on=True)
        seat(wall, ana, hand=True)
        wall.say("SendHint", text="Look at line 2.", pupil=ana.id)
        assert page.hear("InClass", hand=False)["hint"] == "Look at line 2."
        seat(wall, ana)


def test_a_pupil_who_has_gone_is_shown_as_gone(room, ana):
    with room.wall() as wall:
        with ana.page() as page:
            page.open("mine", DRIVE)
            seat(wall, ana, here=True, project="mine")
        # Defaults are left out.
        assert seat(wall, ana, here=None)["project"] == "mine"


def test_eyes_up_reaches_every_page(room, ana, leo):
    with room.wall() as wall, ana.page() as one, leo.page() as other:
        wall.say("EyesUp", on=True)
        for page in (one, other):
            page.hear("InClass", eyes_up=True)
        wall.say("EyesUp", on=False)
        for page in (one, other):
            page.hear("InClass", eyes_up=False)


def test_the_teacher_stops_all_robots(room, ana, leo):
    forever = "main:\n    forever:\n        function.sleep(1)\n    end\nend\n"
    with room.wall() as wall, ana.page() as one, leo.page() as other:
        for page in (one, other):
            page.open("mine", forever)
            page.say("Run")
            page.hear("RunState", state="running")
        wall.say("StopAll")
        for page in (one, other):
            assert page.hear("Ended")["ended"] == "stopped"


def test_a_lesson_is_handed_out(room, ana):
    with room.wall() as wall, ana.page() as page:
        lesson = wall.hear("Offers")["lessons"][0]["name"]
        wall.say("HandOut", lesson=lesson, project="Mine")
        page.hear("LessonShown", name=lesson)
        shown = seat(wall, ana, step=1)
        assert shown["steps"] > 1


def test_the_teacher_looks_and_writes_only_if_the_pupil_agrees(room, ana):
    teacher = room.teacher()
    with ana.page() as page, ana.page(cookie=teacher) as looking:
        page.open("mine", DRIVE)
        page.pulse()
        looking.say("Open", name="mine")
        looking.hear("Document")
        looking.say("EditText", edit=1, notation="blocktext", text="main:\nend\n", shown=1)
        refused = looking.hear("Failed")
        assert refused["message"]["code"] == "class-only-look"
        looking.say("AskToWrite", on=True)
        page.hear("InClass", writing="asked")
        page.say("LetTeacherWrite", on=True)
        looking.hear("InClass", writing="yes")
        looking.say("Format")
        looking.pulse()
        page.say("LetTeacherWrite", on=False)
        looking.hear("InClass", writing="no")
        looking.say("Run")
        assert looking.hear("Failed")["message"]["code"] == "class-only-look"


def test_the_pupils_right_to_write_ends_when_the_teacher_leaves(room, ana):
    with ana.page() as page:
        page.open("mine", DRIVE)
        with ana.page(cookie=room.teacher()) as looking:
            looking.say("AskToWrite", on=True)
            page.hear("InClass", writing="asked")
            page.say("LetTeacherWrite", on=True)
            page.hear("InClass", writing="yes")
        page.hear("InClass", writing="no")


def test_new_pictures_close_the_pupils_pages(room, ana):
    with room.wall() as wall, ana.page() as page:
        wall.say("RenewPin", pupil=ana.id)
        pin = wall.hear("NewPin")
        assert (pin["name"], len(pin["pictures"])) == (ana.name, 4)
        with pytest.raises(ConnectionClosed) as closed:
            page.hear("nothing")
        assert closed.value.rcvd.code == 4403
    assert ana.ask("").status != 200
    assert room.join(ana.name, ana.pictures).status == 403
    assert room.join(ana.name, pin["pictures"]).status == 200


def test_a_deleted_pupil_leaves_nothing(room, ana):
    with room.wall() as wall:
        with ana.page() as page:
            page.open("mine", DRIVE)
            page.pulse()
            assert ana.folder.is_dir()
            wall.say("RemovePupils", pupils=[ana.id])
            wall.hear("Wall")
            while ana.id in wall.last["Wall"].get("pupils", []):
                wall.hear("Wall")
        assert not ana.folder.exists()
    assert room.join(ana.name, ana.pictures).status == 403


def test_the_teacher_downloads_everything_of_a_pupil(room, ana):
    with ana.page() as page:
        page.open("mine", DRIVE)
        page.say("CloseProject")
        page.pulse()
    packed = room.ask(f"/export.zip?pupil={ana.id}", cookie=room.teacher())
    with zipfile.ZipFile(BytesIO(packed.body)) as archive:
        top = f"{ana.name}-{ana.id}"
        assert f"{top}/projects/mine.learnblock" in archive.namelist()
        about = json.loads(archive.read(f"{top}/pupil.json"))
    assert (about["name"], about["id"]) == (ana.name, ana.id)
    assert all(name.startswith(top) for name in archive.namelist())


def test_the_projector_shows_how_to_join_or_a_world_without_the_name(room, ana):
    with room.wall("/projected") as projector, room.wall() as wall, ana.page() as page:
        assert projector.hear("Projected")["word"] == room.word
        page.open("mine", DRIVE)
        seat(wall, ana, project="mine")
        wall.say("ShowOnProjector", pupil=ana.id)
        while not (shown := projector.hear("Projected")).get("seat"):
            pass
        assert ana.name not in json.dumps(shown)
        assert ana.id not in json.dumps(shown)
        wall.say("ShowOnProjector", pupil=None)
        while projector.hear("Projected").get("seat"):
            pass


@pytest.mark.certain
def test_a_closed_class_lets_only_known_pupils_in(room, ana):
    with room.wall() as wall:
        wall.say("LetJoin", on=False)
        wall.hear("Wall", open=False)
        assert room.join("Zoe").json["message"]["code"] == "class-closed"
        assert room.join(ana.name, ana.pictures).status == 200
        wall.say("LetJoin", on=True)
        wall.hear("Wall", open=True)


@pytest.mark.exhaustive
def test_everything_is_there_when_the_class_opens_again(own_room):
    ana = own_room.pupil("Ana")
    with ana.page() as page:
        page.open("mine", DRIVE)
        page.pulse()
    assert own_room.close() == 0
    own_room.open()
    with ana.page() as page:
        assert [one["name"] for one in page.pulse()["projects"]] == ["mine"]


@pytest.mark.certain
def test_a_killed_class_goes_on_after_a_restart_and_nothing_saved_is_lost(own_room):
    ana = own_room.pupil("Ana")
    with ana.page() as page:
        page.open("mine")
        page.type(DRIVE)
        page.hear("Saved")
        own_room.kill()
    own_room.open()
    with ana.page() as page:
        page.say("Open", name="mine")
        assert page.hear("Document")["blocktext"] == DRIVE


@pytest.mark.exhaustive
def test_a_second_command_does_not_open_the_same_class(own_room):
    again = subprocess.run(
        [sys.executable, "-m", "learnblock", "class", "7b", "--no-browser"],
        env={**os.environ, "LEARNBLOCK_HOME": str(own_room.home)},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert again.returncode == 2
    assert "7b is open already" in again.stderr
