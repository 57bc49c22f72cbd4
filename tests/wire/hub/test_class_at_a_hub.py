"""A class as a service of a real JupyterHub, with its users as pupils and teacher."""

import os
import signal
import sys
from urllib.parse import urlencode

import pytest
from websockets.exceptions import ConnectionClosedError

import hubs
import small_lesson
from learnblock.lessons.own import MOST_OWN
from learnblock.lessons.reading import unpack
from learnblock.server.messages import LARGEST_LESSON
from waiting import wait_for

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform != "linux", reason="looks for processes in /proc"),
]

CLASS = "/services/class-7b/"
STEP = 2
PLACE = {"lesson": "1-01-first-drive", "step": STEP}


@pytest.fixture(scope="module")
def hub(tmp_path_factory):
    folder = tmp_path_factory.mktemp("hub")
    # Lessons of the teacher's own, one of them as large as a message holds, with a picture that
    # can't be packed smaller.
    home = folder / "homes" / "class"
    small_lesson.put_in(home)
    small_lesson.put_in(
        home, name="large", pictures={"large.png": os.urandom(LARGEST_LESSON - 9000)}
    )
    with hubs.running(folder, hubs.proxy_command()) as running:
        yield running


def enter(hub, name):
    """Log in, as a browser does that has opened the address of the class."""
    user = hub.visitor(name)
    user.login(CLASS)
    user.page = user.client.get(CLASS)
    return user


@pytest.fixture(scope="module")
def teacher(hub):
    return enter(hub, "teacher")


@pytest.fixture(scope="module")
def alice(hub):
    return enter(hub, "alice")


@pytest.fixture(scope="module")
def bob(hub):
    return enter(hub, "bob")


def page_of(user):
    return user.page.url.path


def hand_ins(page):
    """Return the pupil's hand-ins, once the page hears of some."""
    while not (handed_in := page.hear("OwnHandIns").get("hand_ins")):
        pass
    return handed_in


def seat_of(wall, name, **values):
    """Wait until the wall shows this of a pupil."""
    while True:
        for seat in wall.hear("Seats")["seats"]:
            if seat["name"] == name and values.items() <= seat.items():
                return


def test_the_login_leads_to_the_wall_or_to_ones_own_page(teacher, alice):
    assert page_of(teacher) == f"{CLASS}teacher"
    assert page_of(alice).startswith(f"{CLASS}p/")
    assert "LearnBlock" in alice.page.text


@pytest.mark.certain
def test_a_user_in_no_group_of_the_class_is_refused(hub):
    assert enter(hub, "carol").page.status_code == 403


@pytest.mark.certain
def test_a_pupil_gets_neither_the_wall_nor_the_page_of_another(alice, bob):
    assert bob.client.get(f"{CLASS}teacher").status_code == 403
    assert page_of(bob) != page_of(alice)
    assert bob.client.get(page_of(alice)).url.path == page_of(bob)
    for path in (f"{CLASS}wall", f"{page_of(alice)}ws"):
        with bob.socket(path) as refused, pytest.raises(ConnectionClosedError, match="4403"):
            refused.next()


@pytest.mark.certain
def test_a_login_that_this_browser_has_not_begun_is_refused(alice):
    answer = alice.client.get(f"{CLASS}oauth_callback?code=x&state=y")
    assert answer.status_code == 403


@pytest.mark.certain
def test_no_token_of_the_hub_reaches_a_browser(alice):
    cookies = [cookie.value for cookie in alice.client.cookies.jar if cookie.path == CLASS]
    (badge,) = filter(None, cookies)
    assert badge.startswith(page_of(alice).split("/")[-2])


def test_work_is_handed_out_handed_in_marked_and_handed_back(teacher, alice):
    pupil = page_of(alice).split("/")[-2]
    with teacher.socket(f"{CLASS}wall") as wall, alice.socket(f"{page_of(alice)}ws") as page:
        assert wall.hear("Wall")["word"] == ""
        wall.say("HandOut", project="First drive", **PLACE)
        page.hear("LessonShown", step=STEP)
        seat_of(wall, "alice", here=True, step=STEP)
        wall.say("SendHint", pupil=None, text="Look at the line")
        page.hear("InClass", hint="Look at the line", title="7b")
        page.say("HandIn")
        assert hand_ins(page)[0]["waits"]
        wall.say("MarkHandIn", pupil=pupil, note="Well driven", mark="9", **PLACE)
        wall.say("HandBack", pupils=[pupil], **PLACE)
        assert hand_ins(page)[0]["back"]["mark"] == "9"


def is_checked(marking):
    """Whether the checks have run on all hand-ins of the step."""
    marking.say("ReadHandIns", **PLACE)
    return all(line.get("checked") for line in marking.hear("HandInList")["lines"])


@pytest.mark.timeout(240)
def test_a_hand_in_is_checked_and_its_run_is_seen_by_teacher_and_pupil(teacher, alice):
    pupil = page_of(alice).split("/")[-2]
    with teacher.socket(f"{CLASS}marking") as marking:
        marking.say("CheckHandIns", **PLACE)
        # Like the page, read the list again at each notice of a change.
        while not is_checked(marking):
            marking.hear("HandInSteps")
    place = urlencode(PLACE)
    watched = (
        (teacher, f"{CLASS}p/hand-ins/ws?pupil={pupil}&{place}"),
        (alice, f"{CLASS}p/hand-in-{pupil}/ws?{place}"),
    )
    for user, path in watched:
        with user.socket(path) as page:
            run = page.hear("HandInRun")
            page.hear("LessonShown", step=STEP)
            page.type(run["program"]["text"])
            page.say("SetSpeed", factor=None)
            page.say("ShowVariant", robot=run["robot"], variant=run.get("variant", 0))
            page.hear("Ended")


def test_a_program_in_an_open_page_is_collected(hub, teacher, bob):
    with teacher.socket(f"{CLASS}wall") as wall, bob.socket(f"{page_of(bob)}ws") as page:
        wall.say("HandOut", project="First drive", **PLACE)
        page.hear("LessonShown", step=STEP)
        seat_of(wall, "bob", step=STEP)
        wall.say("CollectHandIns", **PLACE)
        assert hand_ins(page)[0]["waits"]
    folder = hub.home("class") / "classes" / "7b" / "hand-ins"
    assert [*folder.rglob("*.json")]


@pytest.mark.parametrize("own", ["small", "large"])
def test_a_lesson_of_the_teachers_own_reaches_a_pupil(hub, teacher, alice, own):
    with teacher.socket(f"{CLASS}wall") as wall, alice.socket(f"{page_of(alice)}ws") as page:
        wall.say("HandOut", project="Mine", lesson=own)
        page.hear("LessonShown", name=own)
        page.say("AnswerQuiz", choices=[0])
        page.hear("QuizJudged", right=True)
    given = next(hub.home("alice").rglob(f"{own}.lblesson"))
    assert unpack(given.name, given.read_bytes()).teacher is None


def add_lesson(user, name):
    """Add a lesson of the teacher's own as the wall does; return the answer."""
    content = small_lesson.packed()
    return user.client.post(f"{CLASS}lessons?filename={name}.lblesson", content=content)


def test_a_lesson_that_the_teacher_adds_at_the_wall_is_handed_out(hub, teacher, alice, bob):
    with teacher.socket(f"{CLASS}wall") as wall, alice.socket(f"{page_of(alice)}ws") as page:
        assert add_lesson(teacher, "added").json() == "added"
        while "added" not in [lesson["name"] for lesson in wall.hear("Offers")["lessons"]]:
            pass
        wall.say("HandOut", project="Added", lesson="added")
        page.hear("LessonShown", name="added")
    for pupil in (alice, bob):
        assert add_lesson(pupil, "evil").status_code == 403
    assert not [*hub.home("class").rglob("evil*")]


def test_the_wall_shows_whose_server_refuses_a_lesson(hub, teacher, alice, bob):
    with (
        teacher.socket(f"{CLASS}wall") as wall,
        alice.socket(f"{page_of(alice)}ws") as other,
        bob.socket(f"{page_of(bob)}ws") as page,
    ):
        wall.say("HandOut", project="Mine", lesson="small")
        page.hear("LessonShown", name="small")
        lessons = next(hub.home("bob").rglob("small.lblesson")).parent
        full = [lessons / f"old-{number}.lblesson" for number in range(MOST_OWN)]
        for file in full:
            file.touch()
        wall.say("HandOut", project="Large", lesson="large")
        other.hear("LessonShown", name="large")
        seat_of(wall, "bob", lacks_lesson=True)
        for file in full:
            file.unlink()
        wall.say("HandOut", project="Large", lesson="large")
        page.hear("LessonShown", name="large")
        seat_of(wall, "bob", lesson_name="large")


@pytest.mark.certain
def test_a_pupil_gives_no_lesson(alice):
    with alice.socket(f"{page_of(alice)}ws") as page:
        page.say("GiveLesson", lesson="small", content="")
        assert page.hear("Failed")["message"]["code"] == "class-not-yours"


def test_a_record_has_the_lessons_with_their_names_and_aims(teacher, alice):
    def lesson():
        record = teacher.client.get(f"{page_of(alice)}record.json").json()
        lessons = (known for known in record.get("lessons", ()) if known["name"] == "small")
        return next(lessons, None)

    # A page that is opened tells what was done before.
    with alice.socket(f"{page_of(alice)}ws") as page:
        page.say("StartLesson", lesson="small", name="Mine")
        page.hear("LessonShown", name="small")
        wait_for(lambda: lesson() and lesson().get("stars") == 1, "the star", hubs.STARTING)
    assert lesson()["title"]["es"] == "Primer viaje"
    assert lesson()["aims"][0]["say"] == "Drive and stop"


def test_the_class_goes_on_when_the_hub_has_started_it_again(hub, alice):
    before = hub.service("class")
    os.kill(before, signal.SIGKILL)
    wait_for(lambda: hub.service("class") not in {None, before}, "another one", hubs.STARTING)
    wait_for(lambda: alice.client.get(page_of(alice)).is_success, "its answer", hubs.STARTING)
    with alice.socket(f"{page_of(alice)}ws") as page:
        assert hand_ins(page)[0]["back"]["mark"] == "9"
