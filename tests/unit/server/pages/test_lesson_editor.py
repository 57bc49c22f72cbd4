"""Lessons that a teacher makes or changes on a page."""

import base64
import io
import zipfile

import pytest

import small_lesson
from learnblock.lessons.reading import open_lesson
from page_files import content_of

TEXTS = {"title": {"en": "Drive"}, "text": {"en": "Drive **around**."}}
#: A page that comes through a proxy may be on any computer.
ELSEWHERE = {"Via": "1.1 proxy"}
SOLUTION = "main:\n    function.drive_distance(200)\nend\n"


@pytest.fixture(autouse=True)
def own_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    return tmp_path / "home"


def made(page):
    """A lesson of the open project, with all its texts."""
    page.say("MakeLesson")
    edited = page.hear("LessonToEdit")["edited"]
    content = edited["content"]
    check = [{"kind": "drives", "at_least": 100}]
    step = {**content["step"][0], **TEXTS, "world": "empty", "check": check}
    return {**edited, "content": {**content, "aims": [{"en": "Drive"}], "step": [step]}}


def saved(page, edited):
    page.say("SaveLesson", edited=edited)
    return page.hear("LessonSaved")["lesson"]


def exported(page, lesson, *, for_pupils):
    page.say("ExportLesson", lesson=lesson, for_pupils=for_pupils)
    content = base64.b64decode(page.hear("LessonExported")["content"])
    return zipfile.ZipFile(io.BytesIO(content)).namelist()


def tried(page):
    while (message := page.hear("LessonTried")).get("running"):
        pass
    return message


def test_a_project_becomes_a_lesson_that_can_be_started(page, own_home):
    page.open("square", SOLUTION)
    name = saved(page, made(page))
    opened = open_lesson(own_home / "lessons" / f"{name}.lblesson")
    assert (opened.program("step-1.bt"), opened.solution(1)) == (SOLUTION, SOLUTION)
    page.say("StartLesson", lesson=name, name="Square")
    assert page.hear("LessonShown", name=name)["goals"][0]["say"]["phrase"]


def test_a_title_gives_a_free_name_that_stays_in_the_folder(page, own_home):
    page.open()
    edited = made(page)
    edited["content"]["title"] = {"en": "../../My square!"}
    assert [saved(page, edited), saved(page, edited)] == ["my-square", "my-square-2"]
    assert len(list((own_home / "lessons").iterdir())) == 2


@pytest.mark.parametrize("title", ["x", "…", "con", "ñ", "漢字", "a" * 200])
def test_every_title_gives_a_name(page, title):
    page.open()
    edited = made(page)
    edited["content"]["title"] = {"en": title}
    assert len(saved(page, edited)) >= 2


def test_a_lesson_with_mistakes_is_refused_with_their_places(page, own_home):
    page.open()
    page.say("MakeLesson")
    page.say("SaveLesson", edited=page.hear("LessonToEdit")["edited"])
    refused = page.hear("LessonExamined")
    assert refused["refused"]
    assert [one["path"] for one in refused["problems"]] == [
        ["aims"], ["step", 0, "title"], ["step", 0, "text"],
    ]  # fmt: skip
    assert not (own_home / "lessons").exists()


def test_what_is_edited_is_shown_in_words_and_blocks(page):
    page.open()
    edited = made(page)
    edited["content"]["step"][0]["text"] = {"en": "```blocks\nfunction.turn(90)\n```\n"}
    page.say("ExamineLesson", edited=edited)
    examined = page.hear("LessonExamined")
    assert examined["steps"][0]["checks"][0]["code"] == "lesson-check-drives"
    assert list(examined["drawings"]) == ["function.turn(90)"]
    assert "problems" not in examined


def test_pupils_get_no_solution(page):
    page.open("square", SOLUTION)
    name = saved(page, made(page))
    assert exported(page, name, for_pupils=True) == ["lesson.toml", "programs/step-1.bt"]
    assert "teacher/solutions/step-1.bt" in exported(page, name, for_pupils=False)


def test_a_saved_lesson_is_changed(page, own_home):
    small_lesson.put_in(own_home)
    page.say("ChangeLesson", lesson="small")
    edited = page.hear("LessonToEdit")["edited"]
    assert edited["steps"][1]["solution"]["text"] == small_lesson.SOLUTION
    edited["content"]["minutes"] = 99
    assert saved(page, edited) == "small"
    opened = open_lesson(own_home / "lessons/small.lblesson")
    assert (opened.lesson.minutes, opened.lesson.picture) == (99, "start.svg")


def test_the_checks_are_tried_on_the_solution(page):
    page.open("square", SOLUTION)
    page.say("TryLesson", edited=made(page))
    found = tried(page)
    assert (found["done"], found["count"]) == (1, 1)
    assert found["programs"] == [{"sort": "solution", "step": 1, "right": 1, "attempts": 1}]


def test_a_solution_that_misses_a_check_is_told_why(page):
    page.open("square", SOLUTION)
    edited = made(page)
    edited["content"]["step"][0]["check"] = [{"kind": "drives", "at_least": 900}]
    page.say("TryLesson", edited=edited)
    assert tried(page)["programs"][0]["problems"][0]["code"] == "lesson-cli-not-met"


def test_a_trial_is_stopped(page):
    page.open("square", SOLUTION)
    edited = made(page)
    edited["content"]["step"][0]["variants"] = 50
    page.say("TryLesson", edited=edited)
    assert page.hear("LessonTried")["running"]
    page.say("StopTrying")
    assert tried(page).get("done", 0) < 51


def test_a_page_on_another_computer_gets_nothing_of_the_teachers(server, own_home):
    small_lesson.put_in(own_home)
    with server.visit(additional_headers=ELSEWHERE) as page:
        assert "teaches" not in page.hear("Welcome")
        assert "teacher/notes.md" not in exported(page, "small", for_pupils=True)


def test_the_teacher_reads_notes_and_solutions_of_a_lesson_of_ours(page):
    page.say("ReadLessonNotes", lesson="1-03-square")
    notes = page.hear("LessonNotes")
    assert notes["title"]["en"] == "A square with a loop"
    assert "Common mistakes" in notes["notes"]["en"]
    assert "solution" not in notes["steps"][0]
    assert "function.drive_distance(300)" in notes["steps"][3]["solution"]
    wrong = notes["steps"][3]["wrong"][0]
    assert wrong["check"]["text"]["en"].startswith("All four corners")
    assert wrong["hint"][0]["text"]["es"]


def test_the_teacher_reads_notes_of_a_lesson_of_their_own(page, own_home):
    small_lesson.put_in(own_home)
    page.say("ReadLessonNotes", lesson="small")
    assert page.hear("LessonNotes")["notes"] == {"en": small_lesson.SECRET}
    page.say("ReadLessonNotes", lesson="none")
    assert page.hear("Failed")["refused"] == "ReadLessonNotes"


def test_the_teacher_gets_a_lesson_on_paper_in_the_language_of_the_page(page):
    page.say("MakeWorksheet", lesson="1-03-square", language="es")
    made = page.hear("WorksheetMade")
    assert made["filename"] == "1-03-square.html"
    content = content_of(base64.b64decode(made["content"]).decode())
    assert (content["kind"], content["language"]) == ("worksheet", "es")


def test_a_lesson_of_ours_is_copied_and_changed(page, own_home):
    page.say("CopyLesson", lesson="1-03-square")
    edited = page.hear("LessonToEdit")["edited"]
    assert edited["lesson"] == "1-03-square-2"
    assert edited["content"]["title"]["en"] == "A square with a loop (copy)"
    edited["content"]["minutes"] = 99
    assert saved(page, edited) == "1-03-square-2"
    opened = open_lesson(own_home / "lessons" / "1-03-square-2.lblesson")
    assert opened.lesson.minutes == 99
    assert opened.teacher.wrong
    assert "worlds/big-square.toml" in opened.files
    page.say("StartLesson", lesson="1-03-square-2", name="Square")
    assert page.hear("LessonShown", name="1-03-square-2")["drawings"]


EDITED = {"content": {"title": "Mine now"}, "lesson": "small"}
#: What only the teacher may do.
REFUSED = [
    ("ImportLesson", {"filename": "small.lblesson", "content": "UEsDBA=="}),
    ("ImportLessonFolder", {"name": "small", "files": {"lesson.toml": "bGVzc29uID0gMQ=="}}),
    ("DeleteLesson", {"lesson": "small"}),
    ("MakeLesson", {}),
    ("ChangeLesson", {"lesson": "small"}),
    ("ExamineLesson", {"edited": EDITED}),
    ("SaveLesson", {"edited": EDITED}),
    ("SaveLesson", {"edited": {"content": {"title": "New"}}}),
    ("TryLesson", {"edited": EDITED}),
    ("ExportLesson", {"lesson": "small", "for_pupils": False}),
    ("ReadLessonNotes", {"lesson": "1-03-square"}),
    ("ReadLessonNotes", {"lesson": "small"}),
    ("MakeWorksheet", {"lesson": "small"}),
    ("CopyLesson", {"lesson": "1-03-square"}),
]


@pytest.mark.parametrize(("kind", "values"), REFUSED, ids=[kind for kind, _ in REFUSED])
def test_a_page_on_another_computer_can_do_nothing_to_lessons(server, own_home, kind, values):
    small_lesson.put_in(own_home)
    with server.visit(additional_headers=ELSEWHERE) as page:
        page.open()
        page.say(kind, **values)
        failed = page.hear("Failed")
        assert (failed["refused"], failed["message"]["code"]) == (kind, "server-lesson-only-here")
    [file] = (own_home / "lessons").iterdir()
    assert file.read_bytes() == small_lesson.packed()


def test_a_page_on_the_servers_own_computer_is_the_teachers(page):
    assert page.hear("Welcome")["teaches"]


@pytest.mark.parametrize("lesson", ["../small", "a/b", ".hidden", "x" * 200])
def test_no_name_leaves_the_folder(page, lesson):
    page.say("SaveLesson", edited={"content": {}, "lesson": lesson})
    assert page.hear("Failed")["message"]["code"] == "server-message-unknown"
