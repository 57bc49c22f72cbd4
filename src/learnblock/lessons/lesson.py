"""The content of a lesson's file, ``lesson.toml``, and of the teacher's, ``teacher/teacher.toml``.

A lesson is a folder, or the same files zipped as ``NAME.lblesson``:

    lesson.toml
    programs/*.bt       the programs that steps start with, and the blocks in their texts
    worlds/*.toml       its own worlds, with their floor pictures
    pictures/*          PNG, JPEG or SVG
    checks.py           Python predicates, for experts; their texts are in checks.LANGUAGE.toml
    teacher/            what pupils never get: teacher.toml, notes.md, notes.es.md,
                        solutions/*.bt, wrong/*.bt
"""

from typing import Annotated, Literal

from msgspec import Meta, Struct

from learnblock.lessons.checks import Check, Name
from learnblock.lessons.key_presses import KeyPress
from learnblock.lessons.texts import Markdown, Title

#: The version of the format that is written; files of older versions are read.
VERSION = 1

FileName = Annotated[
    str, Meta(pattern=r"^[\w-]{1,60}\.\w{1,8}$", description="a file's name, such as start.bt")
]
RobotName = Annotated[str, Meta(min_length=1, max_length=60)]
#: The parts of a lesson in the order of PRIMM (Sentance, Waite and Kallia, 2019).
#: A text in every language alike, or by language.
LessonText = str | dict[str, str]
Phase = Literal["predict", "run", "investigate", "modify", "make"]
Level = Literal[1, 2, 3, 4]

#: What a rule for hints looks at, in addition to the failing check.
Sign = Literal[
    "never_asks",
    "never_runs",
    "loop_without_wait",
    "wrong_sign",
    "value_too_small",
    "value_too_large",
    "no_loop",
    "too_early",
    "too_late",
    "collision",
    "error",
    "empty",
]


class Table(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """What all tables of a lesson's file have."""


class HintRule(Table, frozen=True, kw_only=True):
    """A hint of the teacher's, with up to three levels: where to look, which part, how in general.

    Args:
        check: the check that fails, by its name or kind; without it any.
        sign: what else has to be seen in the program or in the run.
        about: a skill, construct or name that the sign is about.
        say: the levels, the most general last.
    """

    check: Name | None = None
    sign: Sign | None = None
    about: Name | None = None
    say: Annotated[tuple[Title, ...], Meta(min_length=1, max_length=3)]


class Choice(Table, frozen=True, kw_only=True):
    """An answer of a quiz."""

    text: Title
    right: bool = False
    because: Title | None = None


class Quiz(Table, frozen=True, kw_only=True):
    """A question with answers to choose from; one or more are right."""

    question: Title
    choices: Annotated[tuple[Choice, ...], Meta(min_length=2, max_length=8)]

    def __post_init__(self) -> None:
        if not any(choice.right for choice in self.choices):
            raise ValueError("lesson-quiz-without-answer")


class Puzzle(Table, frozen=True, kw_only=True):
    """A Parsons puzzle: the statements of a program, to be put in order.

    Args:
        program: the file of the program in the right order; pupils get its statements shuffled.
        also: programs in Block-Text of the same statements in other orders that are as right.
        distractors: statements in Block-Text that do not belong to it.
    """

    program: FileName
    also: Annotated[
        tuple[Annotated[str, Meta(min_length=1, max_length=2000)], ...], Meta(max_length=10)
    ] = ()
    distractors: Annotated[
        tuple[Annotated[str, Meta(min_length=1, max_length=200)], ...], Meta(max_length=10)
    ] = ()


class Partner(Table, frozen=True, kw_only=True):
    """Another robot in the world of a step, with a program of the lesson's.

    Args:
        name: its name, such as ``keeper``; the pupil's robot has its own.
        robot: a simulated robot.
        program: the file of its program.
    """

    name: Annotated[
        str, Meta(pattern=r"^\w[\w -]{0,38}\w?$", description="letters, digits, spaces, - and _")
    ]
    robot: RobotName
    program: FileName


class Step(Table, frozen=True, kw_only=True):
    """A step of a lesson.

    Args:
        title: its title.
        phase: its part in PRIMM.
        text: the instructions, in Markdown. A code block ``blocks`` has Block-Text that is drawn as
            blocks; pictures are those of the lesson.
        program: the file of the program that it starts with; without it, the pupil goes on with
            the program of the step before.
        world: the world, one of ours or of the lesson's.
        robots: the robots that it is meant for, the usual one first; without them the lesson's.
        blocks: the blocks shown: the name of a block set, or names of blocks; without them
            those of the step before.
        variants: how many variants of the world the checks are made in, besides the world as it is.
        partners: other robots in its world.
        keys: the keys that are pressed when the checks run without a player.
        seconds: the most seconds of a run, of the robot's time.
        check: the checks.
        hint: the teacher's hints, in the order in which they are tried.
        quiz: a question.
        puzzle: a puzzle.
    """

    title: Title
    phase: Phase
    text: Markdown
    program: FileName | None = None
    world: Name | None = None
    robots: Annotated[tuple[RobotName, ...], Meta(max_length=12)] = ()
    blocks: Name | Annotated[tuple[Name, ...], Meta(max_length=200)] | None = None
    variants: Annotated[int, Meta(ge=0, le=100)] = 0
    partners: Annotated[tuple[Partner, ...], Meta(max_length=9)] = ()
    keys: Annotated[tuple[KeyPress, ...], Meta(max_length=100)] = ()
    seconds: Annotated[float, Meta(ge=1, le=600)] = 60.0
    check: Annotated[tuple[Check, ...], Meta(max_length=12)] = ()
    hint: Annotated[tuple[HintRule, ...], Meta(max_length=30)] = ()
    quiz: Quiz | None = None
    puzzle: Puzzle | None = None


class AimEvidence(Table, frozen=True, kw_only=True):
    """What shows that a pupil has reached an aim of the lesson.

    Args:
        aim: its number in ``aims``, from 1.
        steps: the numbers of the steps whose checks, questions and puzzles show it.
        standards: what it is called in tables of standards, such as ``CSTA 1B-AP-10``.
    """

    aim: Annotated[int, Meta(ge=1, le=8)]
    steps: Annotated[
        tuple[Annotated[int, Meta(ge=1, le=30)], ...], Meta(min_length=1, max_length=30)
    ]
    standards: Annotated[
        tuple[Annotated[str, Meta(min_length=1, max_length=40)], ...], Meta(max_length=8)
    ] = ()


class Lesson(Table, frozen=True, kw_only=True):
    """A lesson.

    Args:
        lesson: the version of the format.
        title: its title.
        level: 1 (first drive) to 4 (several robots, noise, states).
        minutes: how long it takes.
        aims: what pupils learn.
        evidence: what shows that they have; without it, all steps show each aim.
        picture: the file of its picture.
        robots: the robots that it is meant for, the usual one first.
        step: its steps.
    """

    lesson: Annotated[int, Meta(ge=1, le=VERSION)]
    title: Title
    level: Level
    minutes: Annotated[int, Meta(ge=1, le=240)]
    aims: Annotated[tuple[Title, ...], Meta(min_length=1, max_length=8)]
    evidence: Annotated[tuple[AimEvidence, ...], Meta(max_length=8)] = ()
    picture: FileName | None = None
    robots: Annotated[tuple[RobotName, ...], Meta(min_length=1, max_length=12)]
    step: Annotated[tuple[Step, ...], Meta(min_length=1, max_length=30)]


class Wrong(Table, frozen=True, kw_only=True):
    """A typical wrong program, and the hint that it should get.

    Args:
        step: the number of the step, from 1.
        program: its file in ``teacher/wrong``.
        check: the check that fails, by name or kind.
        hint: the code of the rule, such as ``hint-wrong-sign``, or ``teacher`` with the number of
            the lesson's own rule: ``teacher-2``.
    """

    step: Annotated[int, Meta(ge=1, le=30)]
    program: FileName
    check: Name
    hint: Name


class Teacher(Table, frozen=True, kw_only=True):
    """What only the teacher has: by the number of a step, the file of its solution.

    Args:
        solutions: the files in ``teacher/solutions``.
        wrong: typical wrong programs.
    """

    solutions: dict[
        Annotated[str, Meta(pattern="^[0-9]{1,2}$", description="the number of a step")], FileName
    ] = {}
    wrong: Annotated[tuple[Wrong, ...], Meta(max_length=100)] = ()
