"""A lesson of the teacher's own, added at the wall of an open class."""

import io
import json
import zipfile
from urllib.parse import urlencode

import pytest

import small_lesson
from classes import opened
from learnblock.blocks.block_sets import EVERYTHING
from learnblock.classroom.roster import Roster
from learnblock.server.messages import LARGEST_LESSON

pytestmark = pytest.mark.realtime

#: A zip of a few kB with a file of many.
BOMB = io.BytesIO()
with zipfile.ZipFile(BOMB, "w", zipfile.ZIP_DEFLATED) as bomb:
    bomb.writestr("lesson.toml", b"\n" * 9_000_000)


def add(room, filename, content, **headers):
    headers.setdefault("cookie", room.teacher())
    return room.ask(f"/lessons?{urlencode({'filename': filename})}", content, **headers)


def own_files(room):
    folder = room.home / "lessons"
    return sorted(path.name for path in folder.iterdir()) if folder.is_dir() else []


def offers(wall):
    return {lesson["name"]: lesson for lesson in wall.hear("Offers")["lessons"]}


def test_a_lesson_that_is_added_is_offered_at_every_wall_and_handed_out(own_room):
    ana = own_room.pupil("Ana")
    with own_room.wall() as wall, own_room.wall() as other, ana.page() as page:
        assert "patrol" not in offers(wall) | offers(other)
        answer = add(own_room, "C:\\lessons\\patrol.lblesson", small_lesson.packed())
        assert (answer.status, answer.json) == (200, "patrol")
        for board in (wall, other):
            added = offers(board)["patrol"]
            assert (added["own"], added["title"]["es"]) == (True, "Primer viaje")
        wall.say("HandOut", lesson="patrol", project="Mine")
        page.hear("LessonShown", name="patrol")


def delete(room, name, **headers):
    headers.setdefault("cookie", room.teacher())
    return room.ask(f"/lessons?{urlencode({'name': name})}", method="DELETE", **headers)


def test_a_lesson_that_was_added_is_deleted_and_no_wall_offers_it_any_more(own_room):
    ana = own_room.pupil("Ana")
    add(own_room, "patrol.lblesson", small_lesson.packed())
    with own_room.wall() as wall, own_room.wall() as other, ana.page() as page:
        assert "patrol" in offers(wall) | offers(other)
        wall.say("HandOut", lesson="patrol", project="Mine")
        page.hear("LessonShown", name="patrol")
        answer = delete(own_room, "patrol")
        assert (answer.status, answer.json) == (200, "patrol")
        assert "patrol" not in offers(wall)
        assert "patrol" not in offers(other)
    assert own_files(own_room) == []
    assert delete(own_room, "patrol").json["code"] == "unknown-name"


def test_the_lesson_with_which_new_pupils_begin_is_not_deleted(tmp_path):
    small_lesson.put_in(tmp_path, name="patrol")
    Roster(tmp_path / "classes" / "7b", "7b").prepare("patrol", "Patrol", EVERYTHING)
    with opened(tmp_path) as room:
        assert delete(room, "patrol").json["code"] == "class-lesson-first"
        assert own_files(room) == ["patrol.lblesson"]


@pytest.mark.certain
def test_only_the_teacher_deletes_a_lesson_and_only_one_of_her_own(room):
    add(room, "mine.lblesson", small_lesson.packed())
    assert delete(room, "mine", cookie=room.pupil("Leo").cookie).status == 403
    assert delete(room, "mine", cookie="").status == 403
    assert delete(room, "mine", Origin="http://evil.example").status == 403
    assert delete(room, "1-03-square").status == 400
    assert delete(room, "../mine").status == 400
    assert own_files(room) == ["mine.lblesson"]
    assert delete(room, "mine").status == 200


@pytest.mark.certain
@pytest.mark.parametrize("who", ["pupil", "visitor", "another site"])
def test_only_the_teacher_adds_a_lesson(room, who):
    cookie = {
        "pupil": lambda: room.pupil(f"Ana {who}").cookie,
        "visitor": lambda: "",
        "another site": room.teacher,
    }[who]()
    origin = {"Origin": "http://evil.example"} if who == "another site" else {}
    answer = add(room, "evil.lblesson", small_lesson.packed(), cookie=cookie, **origin)
    assert answer.status == 403
    assert own_files(room) == []


@pytest.mark.certain
@pytest.mark.parametrize(
    ("filename", "content", "code"),
    [
        ("no.lblesson", b"no zip", "lesson-zip-damaged"),
        ("bomb.lblesson", BOMB.getvalue(), "file-zip-bomb"),
        ("large.lblesson", bytes(LARGEST_LESSON + 1), "class-lesson-too-large"),
        ("../../.lblesson", small_lesson.packed(), "server-lesson-name"),
        ("1-03-square.lblesson", small_lesson.packed(), "server-lesson-name"),
        ("", small_lesson.packed(), "server-lesson-name"),
    ],
)
def test_a_file_that_is_no_lesson_is_refused_with_a_sentence(room, filename, content, code):
    answer = add(room, filename, content)
    assert answer.status == 400
    assert code in json.dumps(answer.json)
    assert own_files(room) == []
