"""Lessons on the command line."""

import json

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.cli.console import ExitCode
from learnblock.lessons.reading import open_lesson, shipped
from lesson_files import START, files

SQUARE = """main:
    repeat 4:
        function.drive_distance(200)
        function.turn(90)
    end
end
"""
TEACHER = """
solutions = { 1 = "square.bt" }

[[wrong]]
step = 1
program = "short.bt"
check = "goals"
hint = "teacher-1"
"""
HINT = '\n[[step.hint]]\ncheck = "goals"\nsay = ["How long is a side?"]\n'


def call(*arguments):
    """Run a command in this process."""
    return CliRunner().invoke(main, ["lesson", *map(str, arguments)])


@pytest.fixture
def lesson(tmp_path):
    """Write a lesson with a solution and a wrong program; return its folder."""
    content = files(
        teacher__teacher_toml=TEACHER,
        teacher__solutions__square_bt=SQUARE,
        teacher__wrong__short_bt=SQUARE.replace("200", "100"),
    )
    content["lesson.toml"] += HINT.encode()
    for path, data in content.items():
        (tmp_path / "it" / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "it" / path).write_bytes(data)
    return tmp_path / "it"


def change(file, old, new):
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new))


def test_the_list_has_the_lessons_that_come_with_learnblock():
    result = call("list", "--json")
    assert [one["name"] for one in json.loads(result.stdout)] == [*shipped()]


def test_a_lesson_is_shown_without_what_only_the_teacher_has(lesson):
    shown = call("show", lesson).stdout
    assert shown.startswith("A square\nLevel 1 · 20 min · sim-ebo, sim-ev3\n- to use a loop\n")
    assert "Step 1 (Make): Drive a square" in shown
    assert "* Reach all goals." in shown
    assert "Solution" not in shown
    assert "drive_distance" not in shown


def test_a_lesson_is_shown_with_notes_solutions_and_the_hints_for_wrong_programs(lesson):
    (lesson / "teacher" / "notes.md").write_text("Bring a ruler.")
    shown = call("show", lesson, "--solutions").stdout
    assert "Notes\n\n    Bring a ruler.\n" in shown
    assert f"  Solution\n\n    {SQUARE.strip().replace(chr(10), chr(10) + '    ')}\n" in shown
    assert "Typical wrong program; it fails this check: Reach all goals." in shown
    assert "Hint\n\n    How long is a side?\n" in shown


def test_a_lesson_is_shown_to_tools(lesson):
    [step] = json.loads(call("show", lesson, "--json").stdout)["steps"]
    assert step["goals"] == ["Reach all goals.", "Use a loop."]
    assert "solution" not in step
    shown = json.loads(call("show", lesson, "--solutions", "--json").stdout)
    [step] = shown["steps"]
    assert step["solution"] == SQUARE
    assert step["wrong"][0]["hint"] == ["How long is a side?"]
    assert shown["notes"] == ""


def test_a_lesson_of_ours_is_shown_in_the_language_of_the_reader(monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_LANGUAGE", "es")
    shown = call("show", "1-03-square", "--solutions").stdout
    assert "Paso 2 (Ejecuta): " in shown
    assert "Solución" in shown


def test_a_pupils_copy_says_that_it_has_no_solutions(lesson, tmp_path):
    call("pack", lesson, "--for-pupils", "--out", tmp_path / "it.lblesson")
    shown = call("show", tmp_path / "it.lblesson", "--solutions").stdout
    assert "This copy of the lesson has no notes and no solutions." in shown


def test_a_lesson_that_is_right_passes_its_check(lesson):
    result = call("check", lesson)
    assert "the solution square.bt passes in 4 of 4 attempts" in result.stdout
    assert "the wrong program short.bt fails its check in 2 of 2 attempts" in result.stdout
    assert result.exit_code == ExitCode.WELL


def test_a_solution_that_fails_is_named_with_robot_variant_and_reason(lesson):
    change(lesson / "teacher/solutions/square.bt", "200", "100")
    result = call("check", lesson, "--robot", "sim-ev3", "--variants", 0)
    row = "sim-ev3, variant 0: Reach all goals. The first corner: 100 mm short."
    assert row in result.stdout
    assert result.exit_code == ExitCode.MISTAKES


def test_a_wrong_program_that_passes_is_named(lesson):
    change(lesson / "teacher/wrong/short.bt", "100", "200")
    result = call("check", lesson, "--robot", "sim-ebo", "--variants", 0)
    assert "It does not fail the check 'goals'." in result.stdout
    assert result.exit_code == ExitCode.MISTAKES


def test_a_wrong_program_that_gets_another_hint_is_named(lesson):
    change(lesson / "teacher/teacher.toml", "teacher-1", "hint-no-loop")
    result = call("check", lesson, "--robot", "sim-ebo", "--variants", 0, "--json")
    problems = [one["problems"] for one in json.loads(result.stdout)]
    assert problems[0] == []
    assert problems[1][0].startswith(
        "It should get the hint hint-no-loop first, but gets: teacher-1"
    )


def test_a_lesson_with_a_mistake_is_not_run(lesson):
    change(lesson / "lesson.toml", '"square"', '"sqare"')
    result = call("check", lesson)
    assert "it/lesson.toml:13:1: unknown-name There is no world 'sqare'." in result.stderr
    assert result.exit_code == ExitCode.MISTAKES


def test_trying_says_which_checks_a_program_meets(lesson, tmp_path):
    program = tmp_path / "mine.bt"
    program.write_text(SQUARE.replace("200", "100"))
    result = call("try", lesson, 1, program, "--robot", "sim-ebo", "--variants", 0)
    assert "✗ Reach all goals.  The first corner: " in result.stdout
    assert "✓ Use a loop." in result.stdout
    assert result.exit_code == ExitCode.MISTAKES
    program.write_text(SQUARE)
    assert call("try", lesson, 1, program, "--variants", 0).exit_code == ExitCode.WELL


def test_hints_are_given_for_a_program_that_fails_if_they_are_wanted(lesson, tmp_path):
    program = tmp_path / "mine.bt"
    program.write_text(SQUARE.replace("200", "100"))
    wish = ("try", lesson, 1, program, "--robot", "sim-ebo", "--variants", 1)
    assert "How long is a side?" not in call(*wish).stdout
    assert "Hint (teacher-1):\n    How long is a side?\n" in call(*wish, "--hints").stdout
    first, second = json.loads(call(*wish, "--hints", "--json").stdout)
    assert first["hints"][0] == {"rule": "teacher-1", "levels": ["How long is a side?"]}
    assert second["hints"] == []
    program.write_text(SQUARE)
    assert "Hint" not in call(*wish, "--hints").stdout


def test_trying_a_program_that_cannot_be_read_shows_its_mistake(lesson, tmp_path):
    program = tmp_path / "mine.bt"
    program.write_text("main:\n    function.turn(\nend\n")
    result = call("try", lesson, 1, program)
    assert "mine.bt:2:" in result.stderr
    assert result.exit_code == ExitCode.MISTAKES


def test_there_is_no_other_step(lesson, tmp_path):
    program = tmp_path / "mine.bt"
    program.write_text(START)
    result = call("try", lesson, 2, program)
    assert "There is no step '2'. Known names: 1." in result.stderr
    assert result.exit_code == ExitCode.USAGE


@pytest.mark.parametrize("for_pupils", [False, True])
def test_a_lesson_is_packed_with_or_without_what_is_the_teachers(lesson, tmp_path, for_pupils):
    file = tmp_path / "packed.lblesson"
    result = call("pack", lesson, "--out", file, *["--for-pupils"] * for_pupils)
    assert result.exit_code == ExitCode.WELL
    assert (open_lesson(file).teacher is None) == for_pupils
