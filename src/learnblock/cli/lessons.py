"""The commands for lessons: list, show, check, try, pack and print."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from learnblock.cli.console import (
    EXISTING_FILE,
    ExitCode,
    json_option,
    print_json,
    say,
    text,
)
from learnblock.cli.language import language
from learnblock.cli.worksheet import worksheet_command

if TYPE_CHECKING:
    from collections.abc import Sequence

    from learnblock.i18n import Phrase
    from learnblock.lessons.checking import ProgramCheck
    from learnblock.lessons.hints import Hint
    from learnblock.lessons.texts import Title
    from learnblock.lessons.trying import JudgedRun

_LESSON = click.argument("lesson", metavar="LESSON")
_ROBOTS = click.option(
    "--robot", "robots", multiple=True, metavar="NAME", help="Only on this robot; may be repeated."
)
_VARIANTS = click.option(
    "--variants", type=click.IntRange(0, 1000), help="So many variants of the world."
)


@click.group("lesson")
def lesson_group() -> None:
    """List, show, check, try, pack or print lessons.

    LESSON is the name of a lesson that comes with LearnBlock, a folder, or a file (.lblesson).
    """


@lesson_group.command("list")
@json_option
def list_command(as_json: bool) -> None:  # noqa: FBT001 - a click flag
    """List the lessons that come with LearnBlock."""
    from learnblock.lessons.reading import shipped, shipped_lesson  # noqa: PLC0415 - `--help`
    from learnblock.lessons.texts import in_language  # noqa: PLC0415 - `--help` needs none of it

    rows = [
        {
            "name": opened.name,
            "title": in_language(opened.lesson.title, language()),
            "level": opened.lesson.level,
            "minutes": opened.lesson.minutes,
        }
        for opened in map(shipped_lesson, shipped())
    ]
    if as_json:
        print_json(rows)
        return
    for lesson in rows:
        click.echo(f"{lesson['name']:<28} {lesson['minutes']:>3} min  {lesson['title']}")


@lesson_group.command("show")
@_LESSON
@click.option(
    "--solutions", is_flag=True, help="Also the teacher's notes, solutions and wrong programs."
)
@json_option
def show_command(lesson: str, solutions: bool, as_json: bool) -> None:  # noqa: FBT001 - flags
    """Show a lesson: what it is about, and the instructions and goals of its steps.

    \b
    learnblock lesson show 1-03-square
    learnblock lesson show 1-03-square --solutions
    """  # noqa: D301 - click wants the character itself
    from learnblock.cli.lesson_text import as_object, lines_of  # noqa: PLC0415 - `--help`
    from learnblock.lessons.reading import find_lesson  # noqa: PLC0415
    from learnblock.lessons.teachers_part import teachers_part  # noqa: PLC0415

    opened = find_lesson(lesson)
    part = teachers_part(opened) if solutions else None
    if as_json:
        print_json(as_object(opened, part))
        return
    for line in lines_of(opened, part):
        click.echo(line)


@lesson_group.command("check")
@_LESSON
@_ROBOTS
@_VARIANTS
@json_option
def check_command(
    lesson: str,
    robots: tuple[str, ...],
    variants: int | None,
    as_json: bool,  # noqa: FBT001 - a click flag
) -> None:
    """Check a lesson: its files, its solutions and its wrong programs.

    Solutions have to meet all checks on each robot and in each variant; a typical wrong program
    has to fail the check that it should, and get its hint. The exit code is 1 if something is
    wrong.

    \b
    learnblock lesson check 1-03-square
    learnblock lesson check my-lesson --robot sim-ebo --variants 20
    """  # noqa: D301 - click wants the character itself
    from learnblock.lessons.checking import check_lesson  # noqa: PLC0415 - `--help`
    from learnblock.lessons.reading import find_lesson  # noqa: PLC0415

    results: list[ProgramCheck] = []
    for result in check_lesson(find_lesson(lesson), robots=robots or None, variants=variants):
        results.append(result)
        if not as_json:
            _print_result(result)
    wrong = sum(not result.is_right for result in results)
    programs = sum(result.kind != "none" for result in results)
    if as_json:
        print_json(results)
    elif wrong:
        say("lesson-cli-wrong", wrong=wrong, all=programs)
    else:
        say("lesson-cli-right", all=programs)
    sys.exit(ExitCode.MISTAKES if wrong else ExitCode.WELL)


@lesson_group.command("try")
@_LESSON
@click.argument("step", type=click.IntRange(1, 30))
@click.argument("program", type=EXISTING_FILE)
@_ROBOTS
@_VARIANTS
@click.option("--hints", is_flag=True, help="Give hints if it fails, from the first to the last.")
@json_option
def try_command(
    lesson: str,
    step: int,
    program: Path,
    *,
    robots: tuple[str, ...],
    variants: int | None,
    hints: bool,
    as_json: bool,
) -> None:
    """Try a program in a step of a lesson, and say which checks it meets.

    The exit code is 1 if it does not meet them in each variant and on each robot.

    \b
    learnblock lesson try 1-03-square 2 my-square.bt
    learnblock lesson try 1-03-square 2 my-square.bt --hints
    """  # noqa: D301 - click wants the character itself
    from learnblock import running  # noqa: PLC0415 - `--help` needs none of it
    from learnblock.lessons.checking import hints_for  # noqa: PLC0415
    from learnblock.lessons.judging import is_done  # noqa: PLC0415
    from learnblock.lessons.reading import find_lesson  # noqa: PLC0415
    from learnblock.lessons.trying import attempts, read_program, try_step  # noqa: PLC0415

    opened = find_lesson(lesson)
    plan = attempts(opened, step, robots=robots or None, variants=variants)
    source = running.read_text(program)
    runs: list[JudgedRun] = []
    for judged in try_step(opened, step, source, plan, filename=program.name):
        runs.append(judged)
        if not as_json:
            _print_judged(judged)
    runs.sort(key=lambda judged: plan.index(judged.attempt))
    failed = next((judged for judged in runs if not is_done(judged.verdicts)), None)
    advice: tuple[Hint, ...] = ()
    if hints and failed:
        tree = read_program(source, program.name).tree
        advice = hints_for(opened, step, tree, failed)
    if as_json:
        print_json([_as_object(judged, advice if judged is failed else ()) for judged in runs])
    else:
        _print_hints(advice)
    all_met = failed is None and len(runs) == len(plan)
    sys.exit(ExitCode.WELL if all_met else ExitCode.MISTAKES)


@lesson_group.command("pack")
@_LESSON
@click.option("--for-pupils", is_flag=True, help="Without what only the teacher gets.")
@click.option("--out", type=click.Path(path_type=Path, dir_okay=False), help="The file to write.")
def pack_command(lesson: str, out: Path | None, for_pupils: bool) -> None:  # noqa: FBT001 - a flag
    """Check the files of a lesson, and pack them into one (.lblesson)."""
    from learnblock.lessons import reading  # noqa: PLC0415 - `--help` needs none of it
    from learnblock.lessons.archive import SUFFIX  # noqa: PLC0415
    from learnblock.lessons.packing import pack  # noqa: PLC0415
    from learnblock.storage.files import save  # noqa: PLC0415

    opened = reading.find_lesson(lesson)
    if for_pupils:
        opened = reading.for_pupils(opened)
    file = out or Path(f"{opened.name}{'-pupils' * for_pupils}{SUFFIX}")
    save(file, pack(opened))
    say("lesson-cli-packed", file=str(file))


lesson_group.add_command(worksheet_command)

#: The phrase for each kind of result.
_ROWS = {
    "solution": "lesson-cli-solution",
    "wrong": "lesson-cli-wrong-program",
    "none": "lesson-cli-none",
}


def _print_result(result: "ProgramCheck") -> None:
    mark = "✓" if result.is_right else "✗"
    say(
        _ROWS[result.kind],
        mark=mark,
        step=result.step,
        file=result.file,
        right=result.right,
        all=result.attempts,
    )
    for problem in result.problems:
        click.echo(f"    {text(problem)}")


def _print_judged(judged: "JudgedRun") -> None:
    from learnblock.lessons.describing import title_of  # noqa: PLC0415 - `--help`

    say("lesson-cli-attempt", robot=judged.attempt.robot, variant=str(judged.attempt.variant))
    for verdict in judged.verdicts:
        mark = {"met": "✓", "failed": "✗", "open": "·"}[verdict.state]
        reason = f"  {text(verdict.explanation)}" if verdict.explanation else ""
        click.echo(f"    {mark} {title_of(verdict.check, language())}{reason}")
    if error := judged.result.report.error:
        click.echo(f"    {text(error['message'])}")  # type: ignore[arg-type] # see `Report`


def _print_hints(hints: "Sequence[Hint]") -> None:
    for hint in hints:
        say("lesson-cli-hint", rule=hint.rule)
        for level in hint.levels:
            click.echo(f"    {_words(level)}")


def _words(level: "Phrase | Title") -> str:
    from learnblock.i18n import Phrase  # noqa: PLC0415 - `--help` needs none of it
    from learnblock.lessons.texts import in_language  # noqa: PLC0415

    return text(level) if isinstance(level, Phrase) else in_language(level, language())


def _as_object(judged: "JudgedRun", hints: "Sequence[Hint]") -> dict[str, Any]:
    from learnblock.lessons.describing import title_of  # noqa: PLC0415 - `--help`

    verdicts = [
        {
            "check": title_of(verdict.check, "en"),
            "state": verdict.state,
            "at": verdict.at,
            "reason": verdict.reason,
            "miss": verdict.miss,
        }
        for verdict in judged.verdicts
    ]
    return {
        "robot": judged.attempt.robot,
        "variant": judged.attempt.variant,
        "verdicts": verdicts,
        "hints": [{"rule": hint.rule, "levels": [*map(_words, hint.levels)]} for hint in hints],
        "report": judged.result.report,
    }
