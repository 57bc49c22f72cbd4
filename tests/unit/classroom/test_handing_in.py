"""Work is handed in, checked as `learnblock grade` checks it, marked and handed back."""

import asyncio
import csv
import io
import zipfile

import pytest

import classes
import small_lesson
from learnblock.classroom.checking import Checking, runs_folder
from learnblock.classroom.hand_ins import HandInShelf
from learnblock.classroom.roster import Roster
from learnblock.lessons.grading.journal import NAME
from learnblock.server.messages import GivenProgram, GivenWork

pytestmark = [pytest.mark.realtime, pytest.mark.slow]
#: Each check tries it once on each of two robots, so it takes a moment.
LESSON, STEP = small_lesson.NAME, 2
PLACE = {"lesson": LESSON, "step": STEP}
MARK = {"note": "x", "mark": "", **PLACE}
WRONG_LINES = [
    2,
    {"number": 0, "text": "pass"},
    {"number": 1e99, "text": "pass"},
    {"number": 2, "text": ""},
    {"number": 2, "text": "x" * 201},
    {"number": 2},
]
QUERY = f"lesson={LESSON}&step={STEP}"


def joined(room, name):
    """A new pupil, who is handed the teacher's own lesson."""
    pupil = room.pupil(name)
    with room.wall() as wall:
        wall.say("HandOut", pupils=[pupil.id], lesson=LESSON, project="First drive")
        listed(wall)
    return pupil


def hand_in(page, text=None):
    """Hand in a step, with a program of the pupil's own."""
    return classes.hand_in(page, LESSON, STEP, text)


def listed(wall):
    wall.say("ReadHandIns", **PLACE)
    return wall.hear("HandInList")


def checked(wall):
    """Check, and wait until that has ended."""
    wall.say("CheckHandIns", **PLACE)
    while not wall.hear("HandInSteps").get("checking"):
        pass
    while wall.hear("HandInSteps").get("checking"):
        pass
    assert not wall.last["HandInSteps"].get("failure")


@pytest.fixture(scope="module")
def room(tmp_path_factory):
    home = tmp_path_factory.mktemp("teacher")
    small_lesson.put_in(home)
    with classes.opened(home) as room:
        yield room


@pytest.mark.timeout(300)
def test_what_is_handed_in_is_checked_marked_and_handed_back(room, tmp_path):
    ana, leo = joined(room, "Ana"), joined(room, "Leo")
    cookie = room.teacher()
    with room.wall() as wall, ana.page() as page, leo.page() as other:
        [own] = hand_in(page, small_lesson.SOLUTION)
        assert own["waits"]
        hand_in(other, "main:\n    pass\nend\n")
        room.pupil("Eva")
        lines = {line["name"]: line["state"] for line in listed(wall)["lines"]}
        assert lines == {"Ana": "to check", "Leo": "to check"}
        [absent] = wall.last["HandInList"]["without"]
        assert (absent["name"], absent["state"]) == ("Eva", "not begun")

        checked(wall)
        lines = {line["name"]: line for line in listed(wall)["lines"]}
        assert (lines["Ana"]["stars"], lines["Leo"].get("stars", 0)) == (3, 0)
        assert lines["Leo"]["missed"]
        table = room.ask(f"/results.csv?{QUERY}", cookie=cookie).body
        assert table == classes.graded(room, LESSON, STEP, tmp_path / "out")
        page_of_all = room.ask(f"/results.html?{QUERY}&language=es", cookie=cookie)
        assert "Leo" in page_of_all.body.decode()

        wall.say("ReadHandIn", pupil=leo.id, **PLACE)
        shown = wall.hear("ShownHandIn")
        assert shown["program"]["text"] == "main:\n    pass\nend\n"
        assert shown["world"]["floor"]
        assert shown["checked"]["hints"]

        line = {"number": 2, "text": "pass"}
        assert shown["lines"][shown["blocks"]["stacks"][0][0]["id"]] == line["number"]
        wall.say("MarkHandIn", pupil=leo.id, note="Drive first.", mark="=3", line=line, **PLACE)
        wall.hear("HandInList")
        marks = room.ask(f"/marks.csv?{QUERY}", cookie=cookie).body
        assert marks.startswith(b"\xef\xbb\xbf")
        rows = list(csv.DictReader(io.StringIO(marks.decode("utf-8-sig"))))
        assert [(row["pupil"], row["mark"], row["state"]) for row in rows] == [
            ("Ana", "", "to mark"),
            ("Leo", "'=3", "marked"),
            ("Eva", "", "not begun"),
        ]
        other.pulse()
        assert "back" not in other.last["OwnHandIns"]["hand_ins"][0]

        wall.say("HandBack", pupils=[leo.id], **PLACE)
        back = other.hear("OwnHandIns")["hand_ins"][0]["back"]
        assert (back["note"], back["mark"], back["line"]) == ("Drive first.", "=3", line)
        assert back["checked"]["checks"]
        page.pulse()
        assert "Drive first." not in str(page.last["OwnHandIns"])
        other.say("ImproveHandIn", **PLACE)
        assert other.hear("OwnHandIns")["hand_ins"][0]["improving"]
        [again] = hand_in(other, "main:\n    pass\n    pass\nend\n")
        assert again["waits"]
        assert again["back"]["mark"] == "=3"


def test_the_teacher_collects_from_who_has_begun(room):
    bo = joined(room, "Bo")
    with room.wall() as wall, bo.page() as page:
        page.say("StartLesson", lesson=LESSON, name="First drive", step=STEP)
        while page.hear("LessonShown").get("step") != STEP:
            pass
        page.say("CloseProject")
        page.pulse()
        wall.say("CollectHandIns", **PLACE)
        lines = {line["name"]: line for line in wall.hear("HandInList")["lines"]}
        assert lines["Bo"]["collected"]
        while not page.hear("OwnHandIns").get("hand_ins"):
            pass


def test_a_step_without_checks_can_not_be_handed_in(room):
    with joined(room, "Kim").page() as page:
        page.say("StartLesson", lesson=LESSON, name="First drive")
        page.hear("LessonShown")
        page.say("HandIn")
        assert page.hear("Failed")["message"]["code"] == "server-lesson-no-checks"


def test_only_the_teacher_gets_tables_and_says_what_is_handed_back(room):
    ida = joined(room, "Ida")
    for path in ("results.csv", "results.html", "marks.csv"):
        assert room.ask(f"/{path}?{QUERY}").status == 403
        assert room.ask(f"/{path}?{QUERY}", cookie=ida.cookie).status == 403
        assert room.ask(f"/{path}?lesson=..%2Fx&step=1", cookie=room.teacher()).status == 400
    with ida.page() as page:
        hand_in(page)
        for kind in ("MarkHandIn", "HandBack", "ReadHandIn", "ReadHandIns", "CheckHandIns"):
            page.say(kind, pupil=ida.id, pupils=[ida.id], note="", mark="10", **PLACE)
            assert page.hear("Failed")["message"]
        page.pulse()
        assert "back" not in page.last["OwnHandIns"]["hand_ins"][0]


def test_an_export_has_a_pupils_hand_ins_and_a_deleted_pupil_leaves_none(room):
    uma = joined(room, "Uma")
    with uma.page() as page, room.wall() as wall:
        hand_in(page)
        packed = room.ask(f"/export.zip?pupil={uma.id}", cookie=room.teacher())
        name = f"Uma-{uma.id}/hand-ins/{LESSON}.{STEP}.json"
        with zipfile.ZipFile(io.BytesIO(packed.body)) as archive:
            assert name in archive.namelist()
        wall.say("RemovePupils", pupils=[uma.id])
        while uma.id in wall.hear("Wall").get("pupils", ()):
            pass
    assert not [*room.folder.glob(f"**/{uma.id}*")]


def test_what_is_handed_in_is_there_after_a_kill(tmp_path):
    small_lesson.put_in(tmp_path)
    with classes.opened(tmp_path) as room:
        ana = joined(room, "Ana")
        with ana.page() as page, room.wall() as wall:
            hand_in(page)
            wall.say("MarkHandIn", pupil=ana.id, note="Well done", mark="10", **PLACE)
            wall.hear("HandInList")
            room.kill()
        file = HandInShelf(room.folder).read(ana.id, LESSON, STEP)
        assert (file.note, file.mark) == ("Well done", "10")
        room.open()
        with room.wall() as wall:
            assert [line["mark"] for line in listed(wall)["lines"]] == ["10"]


def test_a_class_goes_on_after_what_no_wall_sends(room):
    with room.wall() as wall:
        for values in (
            {"kind": "ReadHandIns", "lesson": "../x", "step": 1},
            {"kind": "ReadHandIns", "lesson": "nothing", "step": 1},
            {"kind": "ReadHandIns", "lesson": LESSON, "step": 30},
            {"kind": "ReadHandIn", "pupil": "a" * 10, **PLACE},
            {"kind": "CheckHandIns", "lesson": LESSON, "step": 1},
            {"kind": "CheckHandIns", "lesson": LESSON, "step": 1e99},
            {"kind": "HandBack", "pupils": ["a" * 10] * 61, **PLACE},
            {"kind": "MarkHandIn", "pupil": 1, "note": "x" * 2000, "mark": "", **PLACE},
            *(
                {"kind": "MarkHandIn", "pupil": "a" * 10, "line": line, **MARK}
                for line in WRONG_LINES
            ),
            {"kind": "CollectHandIns", "lesson": "\u0000", "step": 2},
            {"kind": "WorkGiven", "work": {}},
        ):
            wall.say(**values)
            assert wall.hear("Refused")["message"]
        assert listed(wall)["title"]


def checked_in(roster, shelf, *, kill=False):
    """A check without a page; what went wrong."""

    async def check():
        changed = asyncio.Event()
        checking = Checking(roster, shelf, changed.set)
        checking.start(LESSON, STEP)
        while kill and not (checking.running and checking.running.news.total):
            await changed.wait()
            changed.clear()
            assert checking.running, checking.failure
        if kill:
            checking._process.kill()
        await checking.wait()
        return checking.failure

    return asyncio.run(check())


@pytest.fixture
def kept(tmp_path, own_home):
    """A class that is not open, whose pupil has handed in."""
    small_lesson.put_in(own_home)
    roster, shelf = Roster(tmp_path, "7b"), HandInShelf(tmp_path)
    ana, _ = roster.add("Ana")
    shelf.add(ana.id, GivenWork(LESSON, STEP, GivenProgram("main:\n    pass\nend\n")))
    return roster, shelf


def test_a_check_that_can_not_be_made_says_why(kept, tmp_path):
    (tmp_path / "checks").write_text("no folder")
    assert checked_in(*kept)


@pytest.mark.timeout(300)
def test_a_check_that_was_killed_says_so_and_goes_on_with_what_was_finished(kept):
    roster, shelf = kept
    assert checked_in(roster, shelf, kill=True).code == "class-check-died"
    journal = runs_folder(roster.folder, LESSON, STEP) / NAME
    finished = journal.read_bytes()
    assert finished
    assert checked_in(roster, shelf) is None
    assert journal.read_bytes().startswith(finished)
    [file] = shelf.of_pupil(roster.pupils[0].id).values()
    assert file.state == "to mark"


def test_a_lesson_is_handed_out_to_some_pupils_from_a_step(room):
    quick, other = room.pupil("Quinn"), room.pupil("Ola")
    with room.wall() as wall, quick.page() as page, other.page() as beside:
        beside.pulse()
        lesson = {"lesson": "1-03-square", "project": "Square"}
        wall.say("HandOut", pupils=[quick.id], step=2, **lesson)
        while page.hear("LessonShown").get("step") != 2:
            pass
        beside.pulse()
        assert "LessonShown" not in beside.last
        # A pupil who has the lesson already goes to the step, too.
        wall.say("HandOut", pupils=[quick.id], step=3, **lesson)
        while page.hear("LessonShown").get("step") != 3:
            pass
        wall.say("HandOut", pupils=["a" * 10], **lesson)
        assert wall.hear("Refused")
