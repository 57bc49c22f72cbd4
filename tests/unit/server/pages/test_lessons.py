"""Lessons as a page follows them."""

import base64
import io
import json
import threading
import zipfile

import pytest

import small_lesson
from learnblock.extensions import custom_blocks
from learnblock.i18n import Phrase
from learnblock.language import parse
from learnblock.lessons import judging
from learnblock.lessons.hints import Hint, gives_away
from learnblock.lessons.reading import open_lesson
from learnblock.server.sessions import run_judge
from pages import TOKEN, phrase, serving

pytestmark = pytest.mark.realtime


@pytest.fixture(autouse=True)
def lesson(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    small_lesson.put_in(tmp_path / "home")


def start(page, *, again=False):
    page.say("StartLesson", lesson="small", name="First drive", again=again)
    page.hear("Opened")
    return page.hear("LessonShown")


def choice(page):
    page.say("ListLessons")
    return next(one for one in page.hear("Lessons")["lessons"] if one["name"] == "small")


def run(page, source):
    page.type(source)
    page.say("SetSpeed", factor=None)
    page.say("Run")
    return judged(page)


def judged(page):
    """The goals at the end of the run."""
    return _without(page, "LessonGoals", "live")


def checked(page):
    """The end of a check."""
    return _without(page, "LessonChecked", "running")


def _without(page, kind, key):
    while (message := page.hear(kind)).get(key):
        pass
    return message


def states(goals):
    return [goal.get("state", "open") for goal in goals["goals"]]


def test_a_lesson_is_listed_with_what_it_takes(page):
    found = choice(page)
    assert (found["level"], found["minutes"], found["stars"]) == (1, 10, 5)
    assert found["title"] == {"en": "First drive", "es": "Primer viaje"}
    assert "project" not in found


def test_a_lesson_begins_with_its_program_world_and_blocks(page):
    shown = start(page)
    assert page.last["Opened"]["world"] == "empty"
    assert page.last["Opened"]["robot"] == "sim-cozmo"
    assert shown["steps"][0]["stars"] == 1
    assert page.last["BlocksShown"]["set"]["name"] == "first-steps"
    assert page.last["Document"]["blocktext"] == small_lesson.START
    assert next(iter(shown["drawings"])).startswith("function.move_straight(40)")


def test_nothing_of_the_teachers_and_no_answer_is_sent_to_the_page(page):
    shown = [start(page)]
    for step in (2, 3):
        page.say("ShowStep", step=step)
        shown.append(page.hear("LessonShown"))
    told = json.dumps(list(page.last.values()) + shown)
    assert "sleep(4)" not in told
    assert small_lesson.SECRET not in told
    assert "positive" not in told
    assert '"right"' not in told
    assert "too short" not in told


def test_a_run_earns_the_stars_of_its_step_once(page):
    start(page)
    page.say("ShowStep", step=2)
    page.hear("LessonShown")
    failed = run(page, small_lesson.START)
    assert states(failed) == ["failed", "met", "met"]
    assert failed["earned"] == 1
    assert failed["goals"][0]["reason"]["code"]
    page.type(small_lesson.SOLUTION)
    page.say("Run")
    done = judged(page)
    assert states(done) == ["met", "met", "met"]
    assert done["done"]
    assert done["earned"] == 1
    page.say("Run")
    assert "earned" not in judged(page)


def test_a_run_that_ends_while_it_is_judged_is_judged_once_more(page, monkeypatch):
    start(page)
    page.say("ShowStep", step=2)
    page.hear("LessonShown")
    ended, slow = threading.Event(), []

    def judge_slowly(step, tree, evidence, *others):
        verdicts = judging.judge(step, tree, evidence, *others)
        if evidence is not None and not slow:
            slow.append(evidence)
            assert ended.wait(30)
        return verdicts

    monkeypatch.setattr(run_judge, "judge", judge_slowly)
    page.type(small_lesson.START)
    page.say("Run")
    page.hear("Ended")
    ended.set()
    assert states(judged(page)) == ["failed", "met", "met"]
    assert not slow[0].has_ended


PARTNER = """seconds = 20
partners = [{ name = "Nova", robot = "sim-ebo", program = "start.bt" }]
[[step.check]]
kind = "drives"
robot = "Nova"
at_least = 35
"""


def test_a_step_with_partners_is_judged_when_all_robots_are_done(page, tmp_path):
    small_lesson.put_in(tmp_path / "home", **{"seconds = 20\n": PARTNER})
    start(page)
    page.say("ShowStep", step=2)
    page.hear("LessonShown")
    page.type("main:\n    function.stop_bot()\nend\n")
    page.say("Run")
    assert states(judged(page)) == ["met", "failed", "met", "met"]


@pytest.mark.certain
def test_progress_is_kept_beside_the_project_and_found_again(page, server, projects):
    start(page)
    page.say("AnswerQuiz", choices=[0])
    assert page.hear("QuizJudged")["right"]
    page.say("ShowStep", step=2)
    page.hear("LessonShown")
    kept = json.loads((projects / ".history" / "First drive" / "lesson.json").read_bytes())
    assert kept["step"] == 2
    assert kept["steps"]["1"]["stars"] == ["quiz"]
    with server.visit() as other:
        found = choice(other)
        assert (found["earned"], found["step"], found["project"]) == (1, 2, "First drive")
        assert start(other)["step"] == 2
        assert start(other, again=True).get("step", 1) == 1
        assert other.last["Opened"]["name"] == "First drive 2"


#: The ids of two browsers.
ANA, BEN = "a" * 32, "b" * 32
ELSEWHERE = {"Via": "1.1 proxy"}


def begun(server, browser=None, **options):
    """A new page begins or goes on with the lesson; its project."""
    with server.visit(**options) as page:
        if browser:
            page.say("Introduce", browser=browser)
        start(page)
        return page.last["Opened"]["name"]


@pytest.mark.parametrize("where", [{}, {"additional_headers": ELSEWHERE}], ids=["here", "there"])
def test_each_browser_has_a_project_of_its_own(server, where):
    assert begun(server, ANA, **where) == "First drive"
    assert begun(server, BEN, **where) == "First drive 2"
    assert begun(server, ANA, **where) == "First drive"
    assert begun(server, BEN, **where) == "First drive 2"


def test_a_browser_sees_only_its_own_stars_and_no_id(server):
    with server.visit() as ana, server.visit() as ben:
        ana.say("Introduce", browser=ANA)
        ben.say("Introduce", browser=BEN)
        start(ana)
        ana.say("AnswerQuiz", choices=[0])
        ana.hear("QuizJudged")
        assert choice(ana)["earned"] == 1
        assert not choice(ben).keys() & {"earned", "step", "project"}
        assert ANA not in json.dumps(list(ben.last.values()))


def test_a_copy_belongs_to_the_browser_that_made_it(server):
    begun(server, ANA)
    with server.visit() as ben:
        ben.say("Introduce", browser=BEN)
        ben.say("CopyProject", project="First drive", name="First drive of Ben")
        ben.hear("Projects")
        assert choice(ben)["project"] == "First drive of Ben"
    assert begun(server, ANA) == "First drive"


def test_a_project_from_before_is_gone_on_with_on_the_servers_own_computer(server):
    old = begun(server)
    assert begun(server, ANA) == old
    assert begun(server, BEN, additional_headers=ELSEWHERE) == "First drive 2"


def test_pages_elsewhere_that_do_not_introduce_themselves_share_nothing(server):
    where = {"additional_headers": ELSEWHERE}
    assert [begun(server, **where), begun(server, **where)] == ["First drive", "First drive 2"]


def test_on_a_server_of_one_person_all_devices_go_on_with_the_same_project(projects):
    where = {"additional_headers": ELSEWHERE}
    with serving(projects, static=projects.parent / "static", for_one=True) as server:
        devices = (ANA, BEN, None)
        assert [begun(server, browser, **where) for browser in devices] == ["First drive"] * 3


@pytest.mark.parametrize("browser", ["", "A" * 32, "a" * 31, "../" + "a" * 29, 7, None])
def test_an_id_that_no_browser_makes_is_refused(page, browser):
    page.say("Introduce", browser=browser)
    assert page.hear("Failed")["message"]["code"] == "server-message-unknown"


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"\xff",
        b"[]",
        b"{}",
        b'{"lesson":"../x"}',
        b'{"lesson":"small","step":99}',
        b'{"lesson":"small","browser":"../x"}',
        b"[" * 99999,
    ],
)
def test_a_project_with_a_damaged_progress_opens_without_a_lesson(page, projects, content):
    folder = projects / ".history" / "program"
    folder.mkdir(parents=True)
    (folder / "lesson.json").write_bytes(content)
    page.open("program")
    page.say("TakeHint")
    assert page.hear("Failed")["message"]["code"] == "server-lesson-none"


def test_a_program_waits_in_its_step(page):
    start(page)
    page.say("ShowStep", step=2)
    page.hear("LessonShown")
    page.type(small_lesson.SOLUTION)
    page.say("RestartStep")
    assert page.hear("Document")["blocktext"] == small_lesson.START


def test_a_quiz_and_a_puzzle_are_judged_by_the_server(page):
    start(page)
    page.say("AnswerQuiz", choices=[1])
    judged = page.hear("QuizJudged")
    assert not judged.get("right")
    assert judged["because"] == {"1": "A negative speed would do that."}
    page.say("AnswerQuiz", choices=[7])
    assert page.hear("Failed")["refused"] == "AnswerQuiz"
    page.say("ShowStep", step=3)
    pieces = page.hear("LessonShown")["puzzle"]["pieces"]
    right = ["function.expressJoy()", "function.sleep(1)", "function.stop_bot()"]
    page.say("AnswerPuzzle", order=[pieces.index(one) for one in reversed(right)])
    assert not page.hear("PuzzleJudged").get("right")
    page.say("AnswerPuzzle", order=[pieces.index(one) for one in right])
    assert page.hear("PuzzleJudged")["right"]
    assert choice(page)["earned"] == 1


def test_hints_come_one_level_after_the_other_and_are_counted(page):
    pytest.importorskip("learnblock.lessons.hints")
    start(page)
    page.say("ShowStep", step=2)
    page.hear("LessonShown")
    run(page, small_lesson.START)
    page.say("TakeHint")
    first = page.hear("LessonHints")
    page.say("TakeHint")
    second = page.hear("LessonHints")
    assert len(first["hints"][0]["levels"]) == 1
    assert second["count"] == 2


def test_a_pupil_is_never_told_why_a_hint_was_chosen_nor_what_solves_the_step(page):
    start(page)
    page.say("ShowStep", step=2)
    page.hear("LessonShown")
    run(page, small_lesson.START)
    told = []
    page.say("TakeHint")
    while (heard := page.hear("LessonHints")).get("more", True):
        told.append(heard)
        page.say("TakeHint")
    told.append(heard)
    hints = heard["hints"]
    assert len(hints) > 1
    assert {key for one in hints for key in one} == {"levels"}
    sent = json.dumps(told)
    assert "hint-value-too-small-how" in sent
    assert "because" not in sent
    levels = tuple(level_of(level) for one in hints for level in one["levels"])
    given = Hint("all of them", levels, Phrase("hint-teacher-because"))
    assert gives_away(given, parse(small_lesson.SOLUTION)) is None


def level_of(words):
    """A level of a hint, as the page received it."""
    return phrase(words["phrase"]) if "phrase" in words else words["text"]


def test_a_program_is_checked_on_all_variants_and_robots(page):
    start(page)
    page.say("ShowStep", step=2)
    assert page.hear("LessonShown")["attempts"] == 4
    page.type(small_lesson.SOLUTION)
    page.say("CheckStep")
    waiting = page.hear("LessonChecked", running=True)
    assert [one.get("passed") for one in waiting["attempts"]] == [None] * 4
    done = checked(page)
    assert done["everywhere"]
    assert choice(page)["earned"] == 2


GO = """from learnblock.perception.tag_names import tag_id


def go(robot):
    robot.drive_distance(10 * tag_id("door"))
"""


def test_a_check_uses_the_projects_own_numbers_of_tags(page, projects):
    custom_blocks.save("goes", GO)
    text = ["main:", "    function.go()", "    function.stop_bot()", "end", ""]
    file = {"learnblock": 2, "blocktext": text, "tags": {"door": 12}}
    progress = projects / ".history" / "tagged" / "lesson.json"
    progress.parent.mkdir(parents=True)
    (projects / "tagged.learnblock").write_text(json.dumps(file))
    progress.write_text('{"lesson":"small","step":2}')
    page.say("Open", name="tagged")
    page.hear("Document")
    page.say("CheckStep")
    done = checked(page)
    assert done.get("everywhere"), done


def test_a_check_can_be_stopped(page):
    start(page)
    page.say("ShowStep", step=2)
    page.hear("LessonShown")
    page.say("CheckStep")
    page.hear("LessonChecked", running=True)
    page.say("StopChecking")
    stopped = checked(page)
    assert not stopped.get("everywhere")


def test_the_program_is_run_where_it_failed(page):
    start(page)
    page.say("ShowStep", step=2)
    page.hear("LessonShown")
    page.say("ShowVariant", robot="sim-thymio", variant=1)
    assert page.hear("Settings")["robot"] == "sim-thymio"
    page.hear("RunState", state="starting")
    page.say("Stop")
    page.hear("Ended")
    page.say("ShowVariant", robot="sim-ebo", variant=1)
    assert page.hear("Failed")["message"]["code"] == "server-lesson-other-robot"


def test_a_lesson_from_a_file_is_added_and_deleted(page):
    content = base64.b64encode(small_lesson.packed()).decode()
    page.say("ImportLesson", filename="mine.lblesson", content=content)
    assert page.hear("LessonImported")["lesson"] == "mine"
    assert {"mine", "small"} <= {one["name"] for one in page.hear("Lessons")["lessons"]}
    page.say("DeleteLesson", lesson="mine")
    assert "mine" not in {one["name"] for one in page.hear("Lessons")["lessons"]}


def in_base64(files):
    return {path: base64.b64encode(text.encode()).decode() for path, text in files.items()}


def test_a_folder_with_a_lesson_is_added_without_what_file_managers_leave(page, tmp_path):
    left = {".DS_Store": "x", "pictures/Thumbs.db": "x", "../evil.bt": "x"}
    files = {**small_lesson.FILES, **left}
    page.say("ImportLessonFolder", name="my lesson", files=in_base64(files))
    assert page.hear("LessonImported")["lesson"] == "my lesson"
    opened = open_lesson(tmp_path / "home" / "lessons" / "my lesson.lblesson")
    assert {path: data.decode() for path, data in opened.files.items()} == small_lesson.FILES


def test_a_zipped_folder_with_a_lesson_is_added(page):
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for path, text in small_lesson.FILES.items():
            archive.writestr(f"my-lesson/{path}", text)
    content = base64.b64encode(buffer.getvalue()).decode()
    page.say("ImportLesson", filename="my-lesson.zip", content=content)
    assert page.hear("LessonImported")["lesson"] == "my-lesson"


@pytest.mark.parametrize(
    ("name", "files"),
    [
        ("mine", {}),
        ("mine", {"programs/start.bt": "main:\nend\n"}),
        ("mine", {**small_lesson.FILES, "/evil.bt": "x"}),
        ("mine", {**small_lesson.FILES, "programs\\start.bt": "x"}),
        ("mine", {**small_lesson.FILES, "lesson.toml\0": "x"}),
        ("mine", {**small_lesson.FILES, "notes.docx": "x"}),
        ("../mine", small_lesson.FILES),
        ("1-03-square", small_lesson.FILES),
        ("mine", {f"pictures/{number}.svg": "" for number in range(301)}),
    ],
)
def test_a_folder_that_is_no_lesson_is_refused(page, tmp_path, name, files):
    page.say("ImportLessonFolder", name=name, files=in_base64(files))
    page.hear("Failed")
    assert [one.name for one in (tmp_path / "home" / "lessons").iterdir()] == ["small.lblesson"]


@pytest.mark.parametrize("content", [b"", b"PK", b"x" * 10_000])
def test_a_file_that_is_no_lesson_is_refused(page, content, tmp_path):
    page.say("ImportLesson", filename="bad.lblesson", content=base64.b64encode(content).decode())
    assert page.hear("Failed")["refused"] == "ImportLesson"
    assert [one.name for one in (tmp_path / "home" / "lessons").iterdir()] == ["small.lblesson"]


def test_a_picture_of_a_lesson_can_do_nothing(server):
    cookie = {"cookie": f"learnblock_token_{server.port}={TOKEN}"}
    picture = server.get("/lessons/small/pictures/start.svg", **cookie)
    assert picture.status == 200
    assert picture.getheader("content-type") == "image/svg+xml"
    assert "default-src 'none'" in picture.getheader("content-security-policy")
    for path in (
        "small/pictures/..%2Flesson.toml",
        "small/pictures/lesson.toml",
        "no/pictures/a.png",
    ):
        assert server.get(f"/lessons/{path}", **cookie).status == 404
    assert server.get("/lessons/small/pictures/start.svg").status != 200


def test_a_copy_of_the_project_keeps_the_progress(page):
    start(page)
    page.say("ShowStep", step=2)
    page.hear("LessonShown")
    page.say("SaveAs", name="copy")
    page.hear("Opened")
    assert page.hear("LessonShown")["step"] == 2
