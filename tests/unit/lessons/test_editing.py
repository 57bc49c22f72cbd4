"""Lessons as a teacher edits them: from files to values, back to files, with mistakes by place."""

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

import small_lesson
from learnblock.lessons import drafting, editing
from learnblock.lessons.editing import EditedLesson, EditedStep, WrittenProgram
from learnblock.lessons.reading import find_lesson, for_pupils, read_files, shipped

TURN = "main:\n    function.turn(90)\nend\n"


@pytest.fixture(autouse=True)
def own_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    return tmp_path


def small():
    files = {path: text.encode() for path, text in small_lesson.FILES.items()}
    return read_files(small_lesson.NAME, files)


def drafted(**changed):
    """A lesson made of a program, with all its texts."""
    found = drafting.draft("Square", "square", [drafting.Drafted("robot", "sim-ebo", TURN)])
    step = {**found.content["step"][0], "title": {"en": "Drive"}, "text": {"en": "Drive around."}}
    content = {**found.content, "aims": [{"en": "Drive"}], "step": [{**step, **changed}]}
    return msgspec.structs.replace(found, content=content)


def problems(edited):
    """The places of the mistakes, and their codes."""
    found = editing.examine(edited, "new").problems
    return [(".".join(map(str, one.path)), one.message.code) for one in found]


def without_programs(opened):
    return [msgspec.structs.replace(step, program=None) for step in opened.lesson.step]


@pytest.mark.parametrize("name", shipped()[::6])
def test_a_lesson_that_is_edited_without_a_change_stays_the_same(name):
    opened = find_lesson(name)
    again = editing.assemble(editing.edited_lesson(opened), name, opened)
    assert without_programs(again) == without_programs(opened)
    assert len(again.teacher.wrong) == len(opened.teacher.wrong)
    numbers = range(1, len(opened.lesson.step) + 1)
    assert [again.solution(n) for n in numbers] == [opened.solution(n) for n in numbers]


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", shipped())
def test_a_copy_of_any_lesson_has_all_of_it_under_a_title_that_says_so(name):
    opened = find_lesson(name)
    copy = editing.copied(opened, "mine")
    assert (copy.name, copy.lesson.title["en"]) == ("mine", f"{opened.lesson.title['en']} (copy)")
    assert copy.lesson.title["es"].endswith(" (copia)")
    assert without_programs(copy) == without_programs(opened)
    assert copy.teacher.wrong == opened.teacher.wrong
    numbers = range(1, len(opened.lesson.step) + 1)
    assert [copy.solution(n) for n in numbers] == [opened.solution(n) for n in numbers]
    same = ("pictures/", "worlds/", "checks.py", "teacher/wrong/", "teacher/notes")
    for path, content in opened.files.items():
        if path.startswith(same):
            assert copy.files[path].strip() == content.strip(), path


def test_a_copy_of_a_lesson_with_one_title_for_all_languages_says_so_in_each():
    files = {path: text.encode() for path, text in small_lesson.FILES.items()}
    title = b'title = { en = "First drive", es = "Primer viaje" }'
    assert title in files["lesson.toml"]
    files["lesson.toml"] = files["lesson.toml"].replace(title, b'title = "%s"' % (b"R" * 200))
    copy = editing.copied(read_files("small", files), "mine")
    assert copy.lesson.title == {"en": "R" * 180 + " (copy)", "es": "R" * 180 + " (copia)"}


def test_a_lesson_made_of_a_program_begins_with_it_and_has_it_as_its_solution():
    opened = editing.assemble(drafted(), "new")
    assert (opened.program("step-1.bt"), opened.solution(1)) == (TURN, TURN)


def test_a_real_robot_is_replaced_by_its_simulated_twin():
    found = drafting.draft("Square", "square", [drafting.Drafted("robot", "ev3", TURN)])
    assert found.content["robots"] == ["sim-ev3"]


def test_other_robots_become_partners_with_their_programs():
    robots = [drafting.Drafted(name, "sim-ebo", TURN) for name in ("one", "two")]
    found = drafting.draft("Duet", "square", robots)
    assert found.content["step"][0]["partners"][0]["name"] == "two"
    assert found.programs == {"partner-1.bt": TURN}


def test_missing_texts_are_named_by_their_places():
    assert problems(drafted(title={}, text={"en": "Drive"})) == [
        ("step.0.title", "lesson-edit-no-text")
    ]


@pytest.mark.parametrize(
    ("changed", "place"),
    [
        ({"world": "nowhere"}, "step.0.world"),
        ({"blocks": "nothing"}, "step.0.blocks"),
        ({"check": [{"kind": "goals", "goals": ["the moon"]}]}, "step.0.check.0.goals.0"),
        ({"check": [{"kind": "drives", "at_least": -1}]}, "step.0.check.0.at_least"),
        ({"variants": 1000}, "step.0.variants"),
        ({"text": {"en": "```blocks\nwhile\n```"}}, "step.0.text"),
    ],
)
def test_a_mistake_is_named_by_its_place(changed, place):
    assert [found for found, _ in problems(drafted(**changed))] == [place]


@pytest.mark.parametrize("which", ["program", "solution"])
def test_a_program_with_a_mistake_is_named_with_its_line(which):
    wrong = EditedStep(**{which: WrittenProgram("main:\n    while\nend\n")})
    found = editing.examine(msgspec.structs.replace(drafted(), steps=(wrong,)), "new").problems
    assert found[0].path == ("step", 0, which)
    assert str(found[0].message).startswith("Line 2: ")


def test_steps_that_move_take_their_wrong_programs_with_them():
    opened = find_lesson("1-03-square")
    edited = editing.edited_lesson(opened)
    first, *others = edited.steps
    content = {**edited.content, "step": [*edited.content["step"][1:], edited.content["step"][0]]}
    moved = msgspec.structs.replace(edited, content=content, steps=(*others, first))
    before = [wrong.step for wrong in opened.teacher.wrong]
    after = [wrong.step for wrong in editing.assemble(moved, "moved", opened).teacher.wrong]
    last = len(edited.steps)
    assert after == [last if step == 1 else step - 1 for step in before]


def test_what_shows_an_aim_moves_with_its_steps():
    opened = find_lesson("1-03-square")
    edited = editing.edited_lesson(opened)
    first, *others = edited.steps
    content = {**edited.content, "step": [*edited.content["step"][1:], edited.content["step"][0]]}
    moved = msgspec.structs.replace(edited, content=content, steps=(*others, first))
    [evidence] = editing.assemble(moved, "moved", opened).lesson.evidence
    assert evidence.steps == tuple(step - 1 for step in opened.lesson.evidence[0].steps)


def test_a_world_of_the_users_comes_with_the_lesson(own_home):
    (own_home / "worlds").mkdir()
    (own_home / "worlds/mine.toml").write_text("[floor]\nsize = [1000, 1000]\n")
    opened = editing.assemble(drafted(world="mine", check=[{"kind": "ends"}]), "new")
    assert "worlds/mine.toml" in opened.files


def test_pictures_and_checks_in_python_are_kept():
    opened = small()
    again = editing.assemble(editing.edited_lesson(opened), "small", opened)
    assert again.files["pictures/start.svg"] == opened.files["pictures/start.svg"]
    assert again.program("puzzle.bt") == small_lesson.PUZZLE


def test_pupils_get_neither_notes_nor_solutions():
    edited = msgspec.structs.replace(drafted(), notes={"en": "Secret", "es": "Secreto"})
    opened = editing.assemble(edited, "new")
    assert {"teacher/notes.md", "teacher/notes.es.md"} <= set(opened.files)
    assert not any("teacher" in path for path in for_pupils(opened).files)


def test_no_program_replaces_that_of_a_puzzle():
    puzzle = "main:\n    pass\nend\n"
    edited = drafted(puzzle={"program": "step-1.bt"})
    edited = msgspec.structs.replace(edited, programs={"step-1.bt": puzzle})
    opened = editing.assemble(edited, "new")
    assert opened.program("step-1.bt") == puzzle
    assert opened.program(opened.lesson.step[0].program) == TURN


def test_programs_that_no_step_names_are_left_out():
    edited = msgspec.structs.replace(drafted(), programs={"old.bt": TURN})
    assert "programs/old.bt" not in editing.assemble(edited, "new").files


@pytest.mark.parametrize(
    "changed",
    [
        {"content": {"title": "x" * 300_000}},
        {"programs": {f"{n}.bt": "x" * 60_000 for n in range(5)}},
        {"steps": (EditedStep(program=WrittenProgram("x" * 60_000)),) * 5},
    ],
    ids=["content", "programs", "steps"],
)
def test_what_is_too_long_is_refused_unread(changed):
    (problem,) = editing.examine(msgspec.structs.replace(drafted(), **changed), "new").problems
    assert problem.message.code in ("file-too-many-bytes", "lesson-edit-too-long")


ANY = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(max_size=20),
    lambda inside: (
        st.lists(inside, max_size=4) | st.dictionaries(st.text(max_size=10), inside, max_size=4)
    ),
    max_leaves=20,
)
KEYS = st.sampled_from(["title", "aims", "robots", "step", "level", "lesson"])


@given(st.dictionaries(KEYS, ANY, max_size=6))
def test_any_content_is_examined_and_its_mistakes_have_places(content):
    assert editing.examine(EditedLesson(content), "new").problems


STEP_KEYS = ["title", "text", "phase", "check", "hint", "quiz", "world", "blocks", "partners"]


@given(st.sampled_from([*STEP_KEYS, "puzzle", "program", "variants"]), ANY)
def test_any_value_of_a_step_is_taken_or_has_its_mistakes_named(key, value):
    edited = drafted(**{key: value})
    if not editing.examine(edited, "new").problems:
        editing.assemble(edited, "new")
