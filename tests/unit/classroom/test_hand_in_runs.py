"""Beside a hand-in, the teacher sees its run, which runs apart from the pupil's work."""

import pytest
from websockets.exceptions import ConnectionClosed

import small_lesson
from classes import opened
from learnblock.classroom.hand_in_runs import FOLDER
from learnblock.classroom.hand_ins import CheckedWork, HandInShelf
from learnblock.server.messages import GivenProgram, GivenWork

pytestmark = [pytest.mark.realtime, pytest.mark.slow]
LESSON, STEP = small_lesson.NAME, 2
TAGS = {"home": 7}
SHORT = (
    "main:\n    function.move_straight(40)\n    function.sleep(1)\n    function.stop_bot()\nend\n"
)
FORGED = [
    "", "pupil={ana}", "pupil={ana}&lesson=small&step=2&room=x", "pupil={ana}&lesson=small&step=x",
    "pupil={ana}&lesson=small&step=1", "pupil={ana}&lesson=..%2F..%2Fclass&step=2",
    "pupil=aaaaaaaaaa&lesson=small&step=2", "pupil=&lesson=small&step=2",
]  # fmt: skip


@pytest.fixture(scope="module")
def room(tmp_path_factory):
    home = tmp_path_factory.mktemp("teacher")
    small_lesson.put_in(home)
    with opened(home) as room:
        yield room


@pytest.fixture(scope="module")
def ana(room):
    """A pupil who has handed in a program that stops too early."""
    ana, shelf = room.pupil("Ana"), HandInShelf(room.folder)
    work = GivenWork(LESSON, STEP, GivenProgram(SHORT, tags=TAGS))
    shelf.add(ana.id, work)
    shelf.keep_checked(ana.id, work, CheckedWork(2, 0, robot="sim-thymio", variant=1))
    # The class reads the list of a pupil's hand-ins once.
    with room.wall() as wall:
        wall.say("ReadHandIns", lesson=LESSON, step=STEP)
        wall.hear("HandInList")
    return ana


def address(query):
    return f"/p/hand-ins/ws?{query}"


def own_address(pupil):
    return f"/p/hand-in-{pupil.id}/ws?lesson={LESSON}&step={STEP}"


def of(pupil):
    return address(f"pupil={pupil.id}&lesson={LESSON}&step={STEP}")


@pytest.mark.timeout(120)
def test_the_run_is_that_of_the_check_and_can_be_asked_why(room, ana):
    with room.socket(of(ana), room.teacher()) as page:
        run = page.hear("HandInRun")
        assert (run["robot"], run["variant"]) == ("sim-thymio", 1)
        assert run["program"]["text"] == SHORT
        while page.hear("LessonShown").get("step") != STEP:
            pass
        while page.last["Tags"]["names"] != TAGS:
            page.hear("Tags")
        page.type(run["program"]["text"])
        page.say("SetSpeed", factor=None)
        page.say("ShowVariant", robot=run["robot"], variant=run["variant"])
        while page.hear("LessonGoals")["goals"][0].get("state") != "failed":
            pass
        page.say("AskWhy", question={"ask": "now", "subject": "", "time": 0.5})
        assert page.hear("WhyAnswer")["sentences"]
        page.say("HandIn")
        assert page.hear("Failed")["message"]["code"] == "class-only-look"
    assert not [*room.folder.glob(f"pupils/{ana.id}/projects/*.learnblock")]


@pytest.mark.parametrize("query", FORGED)
def test_what_was_not_handed_in_does_not_run(room, ana, query):
    path = address(query.format(ana=ana.id))
    with room.socket(path, room.teacher()) as page, pytest.raises(ConnectionClosed) as closed:
        page.hear("Welcome")
    assert closed.value.rcvd.code == 4403


def refused(room, path, cookie):
    with room.socket(path, cookie) as page, pytest.raises(ConnectionClosed) as closed:
        page.hear("HandInRun")
    return closed.value.rcvd.code == 4403


def test_a_pupil_sees_the_runs_of_no_others(room, ana):
    leo, own = room.pupil("Leo"), own_address(ana)
    assert refused(room, of(ana), ana.cookie)
    assert room.ask("/p/hand-ins/", cookie=ana.cookie).status == 403
    for cookie in (leo.cookie, room.teacher(), ""):
        assert refused(room, own, cookie)
        assert room.ask(f"/p/hand-in-{ana.id}/", cookie=cookie).status == 403
    for more in (f"&pupil={leo.id}", f"&pupil={ana.id}", "&is_teacher=1"):
        assert refused(room, own + more, ana.cookie)


@pytest.mark.timeout(120)
def test_pupils_see_their_own_run_and_no_check_before_it_is_handed_back(room, ana):
    assert room.ask(f"/p/hand-in-{ana.id}/", cookie=ana.cookie).status == 200
    with room.socket(own_address(ana), ana.cookie) as page:
        run = page.hear("HandInRun")
        # The check was made with another robot, in a variant.
        assert (run["robot"], run.get("variant", 0)) == ("sim-cozmo", 0)
        while page.hear("LessonShown").get("step") != STEP:
            pass
        page.type(run["program"]["text"])
        page.say("ShowVariant", robot=run["robot"], variant=0)
        while page.hear("LessonGoals")["goals"][0].get("state") != "failed":
            pass
        page.say("HandIn")
        assert page.hear("Failed")["message"]["code"] == "class-only-look"
        with room.wall() as wall:
            [seat] = [seat for seat in wall.hear("Seats")["seats"] if seat["id"] == ana.id]
            assert not seat.get("here")
    assert not [*room.folder.glob(f"pupils/{ana.id}/projects/*.learnblock")]


def test_what_ran_is_deleted_with_a_pupil_and_with_the_class(tmp_path):
    small_lesson.put_in(tmp_path)
    with opened(tmp_path) as room:
        leo, folder = room.pupil("Leo"), room.folder / FOLDER / "hand-ins"
        HandInShelf(room.folder).add(leo.id, GivenWork(LESSON, STEP, GivenProgram(SHORT)))
        with room.socket(of(leo), room.teacher()) as page, room.wall() as wall:
            page.hear("LessonShown")
            assert folder.exists()
            wall.say("RemovePupils", pupils=[leo.id])
            while leo.id in wall.hear("Wall").get("pupils", []):
                pass
        assert not folder.exists()
        kim = room.pupil("Kim")
        HandInShelf(room.folder).add(kim.id, GivenWork(LESSON, STEP, GivenProgram(SHORT)))
        with room.socket(of(kim), room.teacher()) as page:
            page.hear("LessonShown")
            assert folder.exists()
    assert not folder.parent.exists()
