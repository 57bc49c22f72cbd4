"""Lessons are read from folders and files, and mistakes are named with file and line."""

import io
import py_compile
import sys
import zipfile

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock.errors import LessonError, UnknownNameError
from learnblock.lessons import archive, reading
from learnblock.lessons.packing import pack
from learnblock.lessons.reading import (
    find_lesson,
    for_pupils,
    open_lesson,
    read_files,
    shipped,
    unpack,
)
from lesson_files import MAIN, START, files

TEACHER = """
solutions = { 1 = "square.bt" }

[[wrong]]
step = 1
program = "short.bt"
check = "goals"
hint = "hint-too-small"
"""
TAUGHT = {
    "teacher__teacher_toml": TEACHER,
    "teacher__solutions__square_bt": START,
    "teacher__wrong__short_bt": START,
}
PNG = b"\x89PNG"


def mistake(main=MAIN, **more):
    with pytest.raises(LessonError) as error:
        read_files("it", files(main, **more))
    return str(error.value)


def of_zip(*entries, name="it.lblesson"):
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as made:
        for path, content in entries:
            made.writestr(path, content)
    return unpack(name, target.getvalue())


def refused(*entries):
    with pytest.raises(LessonError) as error:
        of_zip(*entries)
    return error.value.diagnostics[0].code


class TestReading:
    def test_a_lesson_is_the_same_from_a_folder_and_from_a_file(self, tmp_path):
        folder = tmp_path / "square"
        for path, content in files(**TAUGHT).items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_bytes(content)
        from_folder = open_lesson(folder)
        file = tmp_path / "square.lblesson"
        file.write_bytes(pack(from_folder))
        assert open_lesson(file) == from_folder
        assert from_folder.solution(1) == START
        assert from_folder.solution(2) is None

    def test_the_same_content_gives_the_same_bytes(self):
        content = files(**TAUGHT)
        turned = dict(reversed(content.items()))
        assert pack(read_files("a", content)) == pack(read_files("a", turned))

    def test_pupils_get_nothing_of_the_teachers(self):
        opened = for_pupils(read_files("it", files(**TAUGHT)))
        assert opened.teacher is None
        assert [path for path in opened.files if "teacher" in path] == []
        assert unpack("it.lblesson", pack(opened)) == opened

    def test_a_folder_may_be_zipped_with_its_own_name(self):
        opened = of_zip(*((f"square/{path}", content) for path, content in files().items()))
        assert opened.lesson.minutes == 20

    def test_what_file_managers_add_is_ignored(self):
        extra = [("__MACOSX/._lesson.toml", b"x"), (".DS_Store", b"x"), ("programs/.x", b"x")]
        assert "programs/.x" not in of_zip(*files().items(), *extra).files

    def test_what_python_adds_beside_the_checks_is_ignored(self, tmp_path):
        for path, content in files(checks_py="").items():
            (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / path).write_bytes(content)
        py_compile.compile(str(tmp_path / "checks.py"))
        assert (tmp_path / "__pycache__").is_dir()
        assert set(open_lesson(tmp_path).files) == {*files(checks_py="")}

    def test_a_step_goes_on_with_the_world_of_the_step_before(self):
        more = '[[step]]\ntitle = "Again"\nphase = "make"\ntext = "Go on."\n'
        opened = read_files("it", files(MAIN + more))
        assert (opened.world(2), opened.start(2), opened.robots(2)) == (
            "square",
            None,
            ("sim-ebo", "sim-ev3"),
        )

    def test_its_own_worlds_come_before_ours(self):
        own = '[[goal.reach]]\nname = "mine"\nx = 300\ny = 0\n[[start]]\nx = 0\ny = 0\n'
        opened = read_files("it", files(worlds__square_toml=own))
        world = opened.described_world(1)
        assert world is not None
        assert [goal.name for _, _, goal in world.goal.all()] == ["mine"]

    def test_lessons_that_come_with_learnblock_are_found_by_name(self):
        assert shipped()
        with pytest.raises(UnknownNameError, match="no lesson 'none'"):
            find_lesson("none")


class TestMistakes:
    @pytest.mark.parametrize(
        ("old", "new", "words"),
        [
            ('kind = "goals"', 'kind = "goal"', "lesson.toml:18:1: wrong-value"),
            ('kind = "goals"', 'kind = "goal"', "Did you mean 'goals'?"),
            ('kind = "goals"', 'goals = ["a"]', "The key 'kind' is missing"),
            ('world = "square"', 'world = "sqare"', "There is no world 'sqare'."),
            ('"sim-ev3"]', '"sim-ev4"]', "There is no robot 'sim-ev4'."),
            ("start.bt", "begin.bt", "The lesson has no file 'programs/begin.bt'."),
            ("start.bt", "../start.bt", "a file's name, such as start.bt"),
            ('construct = "loop"', 'construct = "lop"', "Did you mean 'loop'?"),
            ('construct = "loop"', 'skill = "flie"', "There is no skill 'flie'."),
            ("lesson = 1", "lesson = 2", "newer LearnBlock"),
            ("minutes = 20", "minutes = 0", "a whole number from 1 to 240"),
            ('kind = "goals"', 'kind = "goals"\ngoals = ["lap"]', "There is no goal 'lap'."),
            ('kind = "goals"', 'kind = "on_line"', "There is no line 'line'."),
            ('kind = "goals"', 'kind = "python"\nfunction = "f"', "There is no function 'f'."),
            ('kind = "goals"', 'kind = "goals"\nrobot = "x"', "There is no robot 'x'."),
            (
                'kind = "goals"',
                'kind = "never"\nwhat = { event = "goal", name = "x" }',
                "There is no goal 'x'.",
            ),
            (
                'kind = "goals"',
                'kind = "in_order"\nevents = [{ event = "calls", skill = "x" }, { event = "at" }]',
                "The key 'x' is missing from 'step[1].check[1].events[2]'.",
            ),
            ('text = "Drive."', 'text = "![way](way.png)"', "no file 'pictures/way.png'"),
            ('text = "Drive."', 'text = "```blocks\\nmain\\n```"', "is not Block-Text"),
            ('text = "Drive."', 'text = "a"\nblocks = "few"', "There is no block set 'few'."),
            (
                'text = "Drive."',
                'text = "a"\nblocks = ["function.fly"]',
                "There is no skill 'fly'.",
            ),
            ('text = "Drive."', 'text = { English = "a" }', "(a language, such as es)"),
        ],
    )
    def test_a_mistake_is_named(self, old, new, words):
        assert words in mistake(MAIN.replace(old, new))

    @pytest.mark.parametrize(
        ("evidence", "words"),
        [
            ("aim = 2\nsteps = [1]", "There is no aim '2'."),
            ("aim = 1\nsteps = [1, 9]", "There is no step '9'."),
        ],
    )
    def test_evidence_for_an_aim_or_from_a_step_that_is_not_there_is_named(self, evidence, words):
        assert words in mistake(MAIN.replace("[[step]]", f"[[evidence]]\n{evidence}\n\n[[step]]"))

    def test_a_hint_for_a_check_that_is_not_there_is_named(self):
        rule = '\n[[step.hint]]\ncheck = "turns"\nsay = ["Look."]\n'
        assert "There is no check 'turns'. Known names: goals, uses." in mistake(MAIN + rule)

    @pytest.mark.parametrize(
        ("old", "new", "words"),
        [
            ("1 =", "2 =", "There is no step '2'."),
            ('"square.bt"', '"round.bt"', "no file 'teacher/solutions/round.bt'"),
            ("step = 1", "step = 3", "There is no step '3'."),
            ('"goals"', '"turns"', "There is no check 'turns'."),
            ('"hint-too-small"', '"teacher-1"', "There is no hint 'teacher-1'."),
        ],
    )
    def test_a_mistake_in_the_teachers_file_is_named(self, old, new, words):
        more = {**TAUGHT, "teacher__teacher_toml": TEACHER.replace(old, new)}
        found = mistake(**more)
        assert found.startswith("it/teacher/teacher.toml:")
        assert words in found

    def test_a_program_that_cannot_be_parsed_is_named_with_its_line(self):
        found = mistake(programs__other_bt="main:\n    function.turn(\nend\n")
        assert found.startswith("it/programs/other.bt:2:")

    def test_pupils_may_start_with_an_empty_program(self):
        read_files("it", files(programs__other_bt="main:\nend\n"))

    def test_a_world_with_a_mistake_is_named(self):
        assert mistake(worlds__square_toml="[floor]\nsize = 3\n").startswith(
            "it/worlds/square.toml:2:1: wrong-value"
        )

    def test_python_with_a_mistake_is_named(self):
        assert mistake(checks_py="def f(:\n").startswith("it/checks.py:1:")

    @pytest.mark.parametrize(
        ("texts", "words"),
        [
            ("late = 1", "Each value of 'texts' must be text of 1 to 200 characters."),
            ('late = ""', "checks.es.toml:1:2: wrong-value"),
            ('"too late" = "a"', "a name, such as late"),
            ('late = "Tarde: {seconds"', "checks.es.toml:2:1: wrong-text The braces"),
            ('late = "Tarde: {time} s"', "other values in 'en'"),
            ("late = ", "checks.es.toml:2:8: invalid-toml"),
        ],
    )
    def test_a_mistake_in_the_texts_of_checks_is_named(self, texts, words):
        english = '[texts]\nlate = "Late: {seconds:.1f} s"\n'
        more = {"checks_py": "", "checks.en_toml": english, "checks.es_toml": f"[texts]\n{texts}\n"}
        assert words in mistake(**more)

    def test_texts_of_checks_are_for_languages_only(self):
        assert refused(*files(**{"checks.spanish_toml": ""}).items()) == "unknown-file"

    def test_a_lesson_needs_its_main_file(self):
        with pytest.raises(LessonError, match=r"it has no lesson\.toml"):
            read_files("it", {"programs/start.bt": b""})

    def test_text_has_to_be_utf_8(self):
        assert "Byte 0 of the file is not UTF-8" in mistake(programs__other_bt=b"\xff")


class TestHostileFiles:
    @pytest.mark.parametrize(
        "path",
        [
            "../lesson.toml", "/lesson.toml", "programs/../../x.bt", "programs/a/b.bt", "C:\\x.bt",
            "x" * 300, "setup.py", "programs/x.exe", "programs/.bt",
            "lesson.toml/", "pictures/x.gif", "worlds/../x.toml", "programs/a\0.bt",
            "teacher/solutions/../../x.bt",
        ],
    )  # fmt: skip
    def test_a_file_that_no_lesson_has_is_refused_or_ignored(self, path):
        try:
            opened = of_zip(*files().items(), (path, b"x"))
        except LessonError as error:
            assert error.diagnostics[0].code in {"unknown-file", "two-files", "no-zip"}  # noqa: PT017
        else:
            assert {*opened.files} == {*files()}

    def test_too_many_files_are_refused(self):
        many = [(f"programs/p{number}.bt", START) for number in range(archive.MOST_FILES)]
        assert refused(*files().items(), *many) == "too-many-files"

    @pytest.mark.skipif(sys.platform == "win32", reason="links need rights on Windows")
    def test_a_link_in_a_folder_is_refused(self, tmp_path):
        (tmp_path / "lesson.toml").write_text(MAIN)
        (tmp_path / "programs").symlink_to("/etc")
        with pytest.raises(LessonError, match="is a link"):
            open_lesson(tmp_path)

    def test_what_is_no_zip_is_refused(self):
        with pytest.raises(LessonError, match="damaged or not a lesson"):
            unpack("it.lblesson", b"PK")

    def test_a_file_that_is_too_large_is_not_unpacked(self):
        with pytest.raises(LessonError, match="the limit is 16 MB"):
            unpack("it.lblesson", bytes(archive.LARGEST + 1))

    def test_another_kind_of_file_is_refused(self, tmp_path):
        file = tmp_path / "x.zip"
        file.write_bytes(b"")
        with pytest.raises(LessonError, match="no lesson here"):
            open_lesson(file)

    @settings(max_examples=150)
    @given(st.data())
    def test_a_changed_main_file_gives_our_own_error_or_a_lesson(self, data):
        lines = MAIN.splitlines()
        parts = st.sampled_from(
            [*lines, "[[step.check]]", "what = { event = 'at' }", "= 3", "x = 1e999", "[step]",
             "kind = 'never'", "events = []", "title = {}", "text = ''", "robots = [[]]",
             "step = 3", "at_least = -1", "within = nan", "blocks = ['a', 1]", "hint = [{}]",
             "[step.quiz]", "choices = [{ text = 'a' }, { text = 'b', right = 1 }]",
             "lesson = 99999999999999999999"]
        )  # fmt: skip
        for _ in range(data.draw(st.integers(1, 4))):
            at = data.draw(st.integers(0, len(lines)))
            lines[at : at + data.draw(st.integers(0, 2))] = [data.draw(parts)]
        try:
            reading.read_files("it", files("\n".join(lines)))
        except LessonError as error:
            assert str(error)  # noqa: PT017 - it can be told
