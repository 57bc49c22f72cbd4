"""The lessons that come with LearnBlock; `learnblock lesson check` tries them on more robots."""

import ast
from collections.abc import Iterator, Mapping

import pytest

from learnblock.i18n import Phrase, translate
from learnblock.i18n.names import goal_phrase
from learnblock.lessons.check_texts import check_texts, own_texts
from learnblock.lessons.checking import hints_for
from learnblock.lessons.checks import Size, Uses
from learnblock.lessons.hints import gives_away
from learnblock.lessons.hints.guess import Hint
from learnblock.lessons.lesson import HintRule
from learnblock.lessons.opened import EXPERTS
from learnblock.lessons.reading import OpenLesson, shipped
from learnblock.lessons.texts import in_language
from learnblock.lessons.trying import Attempt, JudgedRun, attempts, read_program
from learnblock.running.batch import WarmProcess
from lesson_tries import read_once as opened
from lesson_tries import tried
from right_programs import known
from translated import complete_languages

LESSONS = shipped()
#: Those that are translated; one that was only begun shows English.
LANGUAGES = complete_languages()
#: Mutants and swaps that solve a task all the same: see `benchmarks/lessons.py`.
KNOWN = [*known("mutants"), *known("swaps")]
PHASES = ["predict", "run", "investigate", "modify", "make"]
LARGEST_PICTURE = 40_000

#: Each lesson has so many wrong programs, at least.
WRONG = 3

#: How a task may name a part that a program must have; other solutions must be as right.
BUILT_OF = {
    "function": {"en": ["function"], "es": ["función"]},
    "game_over": {"en": ["game over"], "es": ["fin del juego"]},
    "if": {"en": ["(*if*)"], "es": ["(*si*)"]},
    "list": {"en": ["list"], "es": ["lista"]},
    "loop": {"en": ["loop"], "es": ["bucle"]},
    "message_value": {"en": ["value"], "es": ["valor"]},
    "parameter": {"en": ["parameter", "(number)"], "es": ["parámetro", "(number)"]},
    "return": {"en": ["returns"], "es": ["devuelv"]},
    "size": {"en": ["at most six"], "es": ["como mucho, seis"]},
    "variable": {"en": ["variable"], "es": ["variable"]},
}

EVERY_WRONG = [
    (name, wrong)
    for name in LESSONS
    if (teacher := opened(name).teacher)
    for wrong in teacher.wrong
]
every_lesson = pytest.mark.parametrize("name", LESSONS)


def texts(value: object) -> Iterator[object]:
    """All texts for people in a part of a lesson."""
    for key in getattr(value, "__struct_fields__", ()):
        field = getattr(value, key)
        if key in {"title", "text", "say", "question", "because", "aims"} and field is not None:
            yield from field if isinstance(field, tuple) else (field,)
        for part in field if isinstance(field, tuple) else (field,):
            yield from texts(part)


def is_complete(text: object) -> bool:
    """Whether a text is there in every language; numbers are alike in all of them."""
    if isinstance(text, Mapping):
        return LANGUAGES <= text.keys()
    return not any(letter.isalpha() for letter in str(text))


def solved_steps(lesson: OpenLesson) -> Mapping[int, str]:
    """The sources of the solutions by the number of the step."""
    assert lesson.teacher
    return {int(step): lesson.solution(int(step)) or "" for step in lesson.teacher.solutions}


def tries(lesson: OpenLesson) -> Iterator[tuple[int, str, list[Attempt]]]:
    """Every solution with all its robots; the last one also in a variant."""
    steps = solved_steps(lesson)
    for step, source in steps.items():
        wanted = attempts(lesson, step, variants=0)
        if step == max(steps) and lesson.step(step).variants:
            wanted = (*wanted, Attempt(wanted[0].robot, 1))
        yield step, source, list(wanted)


def unmet(tried: JudgedRun) -> list[str]:
    return [
        f"{tried.attempt}: {verdict.check}: {verdict.state} {verdict.reason}"
        for verdict in tried.verdicts
        if verdict.state != "met"
    ]


def failed_checks(tried: JudgedRun) -> set[str]:
    """The names and kinds of the checks that fail."""
    checks = [one.check for one in tried.verdicts if one.state == "failed"]
    kinds = {str(check.__struct_config__.tag) for check in checks}
    return kinds | {check.name for check in checks if check.name}


@pytest.mark.parametrize(("level", "count"), [(1, 7), (2, 7), (3, 6), (4, 6)])
def test_there_are_six_lessons_of_a_level_and_a_game_for_beginners(level, count):
    assert [opened(name).lesson.level for name in LESSONS].count(level) == count


@every_lesson
def test_a_lesson_is_named_by_its_level_and_goes_through_all_phases_in_order(name):
    lesson = opened(name).lesson
    phases = [step.phase for step in lesson.step]
    assert name.startswith(f"{lesson.level}-")
    assert sorted(phases, key=PHASES.index) == phases
    assert set(phases) == set(PHASES)


@every_lesson
def test_a_lesson_has_every_text_in_each_language(name):
    assert [text for text in texts(opened(name).lesson) if not is_complete(text)] == []


@every_lesson
def test_the_checks_of_a_lesson_have_every_text_in_each_language(name):
    lesson = opened(name)
    own = own_texts(lesson)
    assert set(own) == (LANGUAGES if EXPERTS in lesson.files else set())
    every = check_texts(lesson)
    assert [
        (language, name)
        for language, texts in own.items()
        for name in every[language]
        if name not in texts
    ] == []


@every_lesson
def test_the_checks_of_a_lesson_say_no_text_in_a_language_themselves(name):
    lesson = opened(name)
    source = lesson.text(EXPERTS) if EXPERTS in lesson.files else ""
    own = LANGUAGES & {
        node.value for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Constant)
    }
    assert own == set()


@every_lesson
def test_the_titles_and_goals_of_a_lessons_worlds_have_words_in_spanish(name):
    lesson = opened(name)
    for number in range(1, len(lesson.lesson.step) + 1):
        world = lesson.described_world(number)
        if world is None or lesson.world(number) not in lesson.own_worlds:
            continue
        for english in (world.title, *(goal.name for _, _, goal in world.goal.all())):
            phrase = goal_phrase(english)
            assert isinstance(phrase, Phrase), english
            assert translate(phrase, "en") == english
            assert translate(phrase, "es") != english


@every_lesson
def test_a_lesson_has_a_small_picture_and_notes_in_both_languages(name):
    lesson = opened(name)
    assert 0 < len(lesson.files[f"pictures/{lesson.lesson.picture}"]) <= LARGEST_PICTURE
    assert {"teacher/notes.md", "teacher/notes.es.md"} <= lesson.files.keys()


@every_lesson
def test_every_step_with_checks_has_a_solution_and_hints_of_its_own(name):
    lesson = opened(name)
    checked = {number for number, step in enumerate(lesson.lesson.step, 1) if step.check}
    assert set(solved_steps(lesson)) == checked
    assert sum(len(step.hint) for step in lesson.lesson.step) >= 2


@every_lesson
@pytest.mark.parametrize("language", sorted(LANGUAGES))
def test_a_task_names_what_its_program_has_to_be_built_of(name, language):
    lesson = opened(name)
    for number, step in enumerate(lesson.lesson.step, 1):
        task = in_language(step.text, language).casefold()
        for check in step.check:
            if isinstance(check, Uses | Size):
                words = BUILT_OF[_part(check)][language]
                assert any(word in task for word in words), (number, check)


def _part(check):
    """The construct, or the skill, that a check of a program's text asks for."""
    return "size" if isinstance(check, Size) else check.construct or check.skill


@every_lesson
def test_no_hint_of_a_lesson_contains_a_statement_of_the_solution(name):
    lesson = opened(name)
    for number, source in solved_steps(lesson).items():
        solution = read_program(source).tree
        for rule in lesson.lesson.step[number - 1].hint:
            assert gives_away(as_hint(rule), solution) is None


@pytest.mark.parametrize("right", KNOWN, ids=lambda right: right["lesson"])
def test_a_difference_that_solves_a_task_is_one_of_a_lessons_solution(right):
    lesson = opened(right["lesson"])
    assert "step" not in right or lesson.solution(right["step"]) is not None
    assert right["what"]
    assert right["because"]


def as_hint(rule: HintRule) -> Hint:
    return Hint("teacher-1", rule.say, None, (), 0)  # type: ignore[arg-type] - only its words count


@pytest.fixture(scope="module")
def runs():
    """The process that makes all runs: it starts once."""
    kept = WarmProcess()
    yield kept
    kept.end()


@pytest.mark.sample(4)
@pytest.mark.slow
@pytest.mark.spread
@every_lesson
def test_every_solution_passes_on_every_robot_that_it_names(runs, name):
    lesson = opened(name)
    for step, source, wanted in tries(lesson):
        [done] = tried(lesson, step, [source], wanted, runs)
        assert len(done) == len(wanted)
        assert [line for one in done for line in unmet(one)] == []


@every_lesson
def test_a_lesson_has_at_least_three_wrong_programs(name):
    teacher = opened(name).teacher
    assert teacher
    assert len(teacher.wrong) >= WRONG


@pytest.mark.sample(8)
@pytest.mark.slow
@pytest.mark.spread
@pytest.mark.parametrize(
    ("name", "wrong"),
    EVERY_WRONG,
    ids=[f"{name}-{wrong.program.removesuffix('.bt')}" for name, wrong in EVERY_WRONG],
)
def test_a_wrong_program_fails_as_said_and_gets_its_hint_first(runs, name, wrong):
    lesson = opened(name)
    source = lesson.text(f"teacher/wrong/{wrong.program}")
    [[done]] = tried(lesson, wrong.step, [source], attempts(lesson, wrong.step)[:1], runs)
    assert wrong.check in failed_checks(done)
    program = read_program(source).tree
    assert hints_for(lesson, wrong.step, program, done)[0].rule == wrong.hint
