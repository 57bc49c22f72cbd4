"""What the class at a hub and a pupil's server tell each other about lessons."""

import base64
import io
import zipfile

import pytest

import small_lesson
from learnblock.lessons.reading import unpack
from learnblock.server.catalog import find_lesson
from learnblock.server.messages import LARGEST_LESSON
from pages import serving

pytestmark = pytest.mark.realtime


@pytest.fixture
def pupil(projects):
    """A pupil's own server, as in a class."""
    with serving(projects, static=projects.parent / "static", for_one=True) as running:
        yield running


@pytest.fixture
def seat(pupil):
    """A page of the class."""
    with pupil.visit(at="ws?seat") as page:
        yield page


def give(page, content, name="small"):
    page.say("GiveLesson", lesson=name, content=base64.b64encode(content).decode())


def begin(page, name="small"):
    page.say("StartLesson", lesson=name, name="First drive")
    return page.hear("LessonShown", name=name)


def zipped(**files):
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, text in files.items():
            archive.writestr(path.replace("__", "/"), text)
    return packed.getvalue()


def test_a_lesson_that_is_given_can_be_begun(seat):
    give(seat, small_lesson.packed())
    assert begin(seat)["steps"]


def test_nothing_that_only_the_teacher_has_is_kept(seat, own_home):
    give(seat, small_lesson.packed())
    begin(seat)
    (given,) = (own_home / "lessons").iterdir()
    assert unpack(given.name, given.read_bytes()).teacher is None


def test_a_lesson_that_is_given_again_is_the_newer_one(seat):
    give(seat, small_lesson.packed())
    give(seat, small_lesson.packed(**{"minutes = 10": "minutes = 12"}))
    begin(seat)
    assert find_lesson("small").lesson.minutes == 12


HOSTILE = {
    "no zip": (b"\0" * 100, "small"),
    "no lesson": (zipped(**{"lesson.toml": "level = 'x'"}), "small"),
    "a path that leads out": (zipped(**{"..__..__evil.py": "x"}), "small"),
    "a file that no lesson has": (
        zipped(**{"lesson.toml": small_lesson.LESSON, "a.sh": "x"}),
        "small",
    ),
    "a bomb": (zipped(**{"lesson.toml": "#" * 9_000_000}), "small"),
    "a name of ours": (small_lesson.packed(), "1-03-square"),
}


@pytest.mark.certain
@pytest.mark.parametrize("kind", HOSTILE)
def test_what_is_no_lesson_is_refused_and_leaves_no_file(seat, own_home, kind):
    content, name = HOSTILE[kind]
    give(seat, content, name)
    assert seat.hear("Failed")["refused"] == "GiveLesson"
    assert not [path for path in own_home.rglob("*") if path.is_file()]


@pytest.mark.certain
@pytest.mark.parametrize("name", ["../evil", "a/b", "/etc/passwd", "", "x" * 90])
def test_a_name_that_leads_out_is_refused(seat, name):
    give(seat, small_lesson.packed(), name)
    assert seat.hear("Failed")["message"]["code"] == "server-message-unknown"


@pytest.mark.certain
def test_a_lesson_larger_than_a_message_is_refused(seat):
    give(seat, b"\0" * (LARGEST_LESSON + 1))
    assert seat.hear("Failed")["message"]["code"] == "server-message-unknown"


def test_a_lesson_that_the_user_has_made_is_not_replaced(seat, own_home):
    small_lesson.put_in(own_home)
    (own,) = (own_home / "lessons").iterdir()
    given = small_lesson.packed(**{"minutes = 10": "minutes = 12"})
    give(seat, given)
    begin(seat)
    assert unpack(own.name, own.read_bytes()).lesson.minutes == 10


@pytest.mark.certain
@pytest.mark.parametrize("at", ["ws", "ws?seat"])
def test_no_page_outside_a_class_gives_a_lesson(server, at):
    with server.visit(at=at) as page:
        give(page, small_lesson.packed())
        assert page.hear("Failed")["message"]["code"] == "server-only-in-class"


@pytest.mark.certain
def test_a_page_of_the_pupil_that_the_class_does_not_pass_on_gives_none(pupil):
    with pupil.visit() as page:
        give(page, small_lesson.packed())
        assert page.hear("Failed")["message"]["code"] == "server-only-in-class"


def test_the_work_in_lessons_is_read(seat):
    give(seat, small_lesson.packed())
    begin(seat)
    seat.say("AnswerQuiz", choices=[0])
    seat.hear("QuizJudged")
    seat.say("ReadLessonWork")
    [work] = seat.hear("LessonWorkRead")["works"]
    assert (work["lesson"], work["stars"]) == ("small", {"1": ["quiz"]})
