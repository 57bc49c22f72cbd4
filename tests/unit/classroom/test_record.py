"""A pupil over weeks, from progress and hand-ins."""

import asyncio
import time

import httpx
import pytest

from learnblock.classroom.app import create_app
from learnblock.classroom.badges import Badges, Visitors
from learnblock.classroom.hand_ins import HandInShelf
from learnblock.classroom.pupil_folder import PROJECTS
from learnblock.classroom.record import record_of
from learnblock.classroom.room import Room
from learnblock.classroom.roster import Roster
from learnblock.lessons.reading import find_lesson
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.lesson_folder import GOALS, QUIZ, Progress, StepProgress
from learnblock.project.files.project import Project
from learnblock.server.catalog import star_names
from learnblock.server.messages import GivenProgram, GivenWork

SQUARE = "1-03-square"


@pytest.fixture
def roster(tmp_path):
    roster = Roster(tmp_path, "7b")
    for name in ("Ana", "Ana"):
        roster.add(name)
    return roster


@pytest.fixture
def shelf(roster):
    return HandInShelf(roster.folder, lambda: 1000.0)


def project(roster, name, steps, *, lesson=SQUARE, step=1):
    """A project of the first pupil."""
    folder = ProjectFolder(roster.folder_of(roster.pupils[0]) / PROJECTS)
    folder.write(Project(name, "main:\n    pass\nend\n"))
    folder.lesson(name).keep_progress(Progress(lesson, step=step, steps=steps))


def record(roster, shelf, **options):
    return record_of(roster, shelf, roster.pupils[0], **{"teaches": True, **options})


def test_a_new_pupil_has_an_empty_record_and_namesakes_have_numbers(roster, shelf):
    empty = record(roster, shelf)
    assert (empty.name, empty.title, empty.lessons) == ("Ana 1", "7b", ())
    assert record(roster, shelf, teaches=False).name == "Ana"


def test_a_lesson_done_in_two_projects_is_one_with_each_star_once(roster, shelf):
    project(roster, "one", {"1": StepProgress((QUIZ,), hints=2, runs=3)})
    project(roster, "two", {"1": StepProgress((QUIZ, GOALS), hints=1, runs=1)}, step=3)
    [lesson] = record(roster, shelf).lessons
    assert (lesson.stars, lesson.hints, lesson.runs, lesson.step) == (1, 3, 4, 3)
    assert lesson.steps == len(find_lesson(SQUARE).lesson.step)


def test_lessons_are_in_the_order_in_which_they_were_worked_on(roster, shelf):
    before = time.time() - 60
    project(roster, "one", {})
    shelf.add(roster.pupils[0].id, GivenWork("1-01-first-drive", 2, GivenProgram("")))
    handed_in, driven = record(roster, shelf).lessons
    assert (handed_in.name, handed_in.at) == ("1-01-first-drive", 1000.0)
    assert (driven.name, before < driven.at < time.time() + 60) == (SQUARE, True)


def test_an_aim_is_reached_when_what_shows_it_is_earned(roster, shelf):
    steps = find_lesson(SQUARE).lesson.step
    earned = {
        str(number): StepProgress(tuple(star_names(step))) for number, step in enumerate(steps, 1)
    }
    project(roster, "half", {"1": earned["1"]})
    [half] = record(roster, shelf).lessons
    assert not any(aim.reached for aim in half.aims)
    project(roster, "all", earned)
    [whole] = record(roster, shelf).lessons
    assert whole.aims
    assert all(aim.reached for aim in whole.aims)
    assert whole.stars == whole.all_stars


def test_only_what_was_handed_back_is_in_the_record(roster, shelf):
    pupil = roster.pupils[0].id
    work = GivenWork(SQUARE, 4, GivenProgram("main:\nend\n"))
    shelf.add(pupil, work)
    shelf.say(pupil, SQUARE, 4, note="Count the corners.", mark="7")
    [kept] = record(roster, shelf).lessons[0].hand_ins
    assert (kept.marks, kept.note, kept.waits) == ((), "", True)
    shelf.hand_back(pupil, SQUARE, 4)
    [back] = record(roster, shelf).lessons[0].hand_ins
    assert (back.marks, back.note, back.waits, back.improved) == (
        ("7",),
        "Count the corners.",
        False,
        0,
    )


def test_an_improved_hand_in_has_both_marks(roster):
    times = iter(range(100))
    shelf = HandInShelf(roster.folder, lambda: float(next(times)))
    pupil = roster.pupils[0].id
    for mark in ("7", "9"):
        shelf.add(pupil, GivenWork(SQUARE, 4, GivenProgram(f"# {mark}\n")))
        shelf.say(pupil, SQUARE, 4, note="", mark=mark)
        shelf.hand_back(pupil, SQUARE, 4)
    [lesson] = record(roster, shelf).lessons
    assert (lesson.hand_ins[0].marks, lesson.hand_ins[0].improved) == (("7", "9"), 1)


@pytest.mark.parametrize("steps", [{"30": StepProgress((GOALS,))}, {"0": StepProgress((QUIZ,))}])
def test_stars_of_steps_that_a_lesson_lacks_are_not_counted(roster, shelf, steps):
    project(roster, "odd", steps, step=30)
    [lesson] = record(roster, shelf).lessons
    assert lesson.stars == 0


def test_a_lesson_that_is_gone_keeps_its_place(roster, shelf):
    project(roster, "old", {"1": StepProgress((QUIZ,), runs=4)}, lesson="no-such-lesson")
    shelf.add(roster.pupils[0].id, GivenWork("no-such-lesson", 2, GivenProgram("")))
    [lesson] = record(roster, shelf).lessons
    assert (lesson.title, lesson.runs, lesson.all_stars) == ("no-such-lesson", 4, 0)
    assert [hand_in.step for hand_in in lesson.hand_ins] == [2]


@pytest.fixture
def asked(roster):
    """Asks for the record of the first pupil with a badge; returns the answer."""
    badges = Badges(roster)
    app = create_app(Room(roster, "http://a"), Visitors(badges, "class"), hosts=["class"])
    path = f"/p/{roster.pupils[0].id}/record.json"

    async def ask(cookie, badge):
        headers = {"cookie": f"{cookie}={badge}"}
        transport = httpx.ASGITransport(app)
        async with httpx.AsyncClient(transport=transport, base_url="http://class") as browser:
            return await browser.get(path, headers=headers)

    return lambda cookie, badge: asyncio.run(ask(cookie, badge))


def test_pupils_see_their_own_record_and_the_teacher_every_record(roster, asked):
    own = asked("class", Badges(roster).of_pupil(roster.pupils[0]))
    assert (own.status_code, own.json()) == (200, {"name": "Ana", "title": "7b"})
    teachers = asked("class_teacher", Badges(roster).of_teacher())
    assert teachers.json() == {"name": "Ana 1", "title": "7b", "teaches": True}


def test_no_other_pupil_and_no_stranger_sees_a_record(roster, asked, tmp_path):
    stranger = Roster(tmp_path / "8a", "8a")
    badges = (
        ("class", Badges(roster).of_pupil(roster.pupils[1])),
        ("class", Badges(stranger).of_pupil(roster.pupils[0])),
        ("class_teacher", Badges(stranger).of_teacher()),
        ("class", ""),
    )
    assert [asked(*badge).status_code for badge in badges] == [403] * 4
