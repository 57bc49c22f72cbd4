"""Messages about lessons: the lessons to choose from, and the one of the open project.

None of them contains the teacher's part or the right answers; see `lesson_editor`.
"""

from typing import Annotated, ClassVar, Literal

from msgspec import Meta, Struct, field

from learnblock.i18n import Phrase
from learnblock.language.workspace.blocks import Workspace
from learnblock.lessons.archive import MOST_FILES
from learnblock.lessons.lesson import LessonText, Phase
from learnblock.project.files.lesson_folder import BrowserId, LessonName, StepNumber
from learnblock.server.messages.base import (
    Computer,
    FromReader,
    Look,
    Name,
    Own,
    Pace,
    ShortText,
    ToPage,
    Write,
)
from learnblock.server.messages.running import VariantNumber

#: The limit of a lesson's file in bytes; in base 64 it fits into a message.
LARGEST_LESSON = 2_500_000

# From the page.


class Introduce(Look, frozen=True):
    """Identify the page's browser, to continue the lessons begun there.

    Args:
        browser: the id, which is not sent to other pages.
    """

    browser: BrowserId


class ListLessons(Look, frozen=True):
    """Ask for `Lessons`."""


class StartLesson(Own, frozen=True):
    """Open the browser's own project of a lesson; create one if there is none.

    Args:
        lesson: the name of the lesson.
        name: the name of a new project; a number is added if it is taken.
        robot: the user's robot, used if the lesson supports it.
        again: whether to begin a new project although there is one.
        step: the step to go to; 0 for where the project is.
    """

    lesson: LessonName
    name: Name
    robot: ShortText = ""
    again: bool = False
    step: Annotated[int, Meta(ge=0, le=30)] = 0


class ShowStep(Write, frozen=True):
    """Go to a step of the lesson, with its program, its world, its robots and its blocks."""

    step: StepNumber


class RestartStep(Own, frozen=True):
    """Begin with the step's first program again; the current one is saved as a version."""


class CheckStep(Write, FromReader, frozen=True):
    """Check the program on all variants of the step's world and on all its robots.

    `LessonChecked` follows, again and again.
    """

    pace: ClassVar = Pace(minute=6, burst=3)


class StopChecking(Write, FromReader, frozen=True):
    """Stop what `CheckStep` began."""


class ShowVariant(Write, FromReader, frozen=True):
    """Run the program on a robot in a variant of the step's world, to see what happens there."""

    robot: Name
    variant: VariantNumber


class TakeHint(Own, FromReader, frozen=True):
    """Ask for a hint, or for the next level of the last one; `LessonHints` follows."""


class AnswerQuiz(Own, FromReader, frozen=True):
    """Answer the question of the step; `QuizJudged` follows.

    Args:
        choices: the indices of the chosen answers.
    """

    choices: Annotated[tuple[Annotated[int, Meta(ge=0, le=7)], ...], Meta(max_length=8)]


class AnswerPuzzle(Own, FromReader, frozen=True):
    """Solve the puzzle of the step; `PuzzleJudged` follows.

    Args:
        order: the indices of the pieces that belong to the program, in their order.
    """

    order: Annotated[tuple[Annotated[int, Meta(ge=0, le=199)], ...], Meta(max_length=200)]


class ImportLesson(Computer, frozen=True):
    """Add a lesson's file to the user's lessons; `LessonImported` follows.

    Args:
        filename: ends in .lblesson, or in .zip.
        content: its bytes in base64.
    """

    filename: Name
    content: Annotated[bytes, Meta(max_length=LARGEST_LESSON)]


class ImportLessonFolder(Computer, frozen=True):
    """Add the folder of a lesson to the user's lessons; `LessonImported` follows.

    Args:
        name: the name of the folder.
        files: its files by their paths inside, in base64.
    """

    name: Name
    files: Annotated[
        dict[
            Annotated[str, Meta(max_length=200)], Annotated[bytes, Meta(max_length=LARGEST_LESSON)]
        ],
        Meta(max_length=MOST_FILES),
    ]


class DeleteLesson(Computer, frozen=True):
    """Delete one of the user's lessons; projects begun with it become ordinary projects."""

    lesson: LessonName


# From the server.


class LessonWords(Struct, frozen=True, omit_defaults=True):
    """What a pupil reads: the words of a lesson, or a phrase of ours.

    Args:
        text: the lesson's words; empty for the phrase.
        phrase: the phrase.
    """

    text: LessonText = ""
    phrase: Phrase | None = None


class LessonChoice(Struct, frozen=True, omit_defaults=True):
    """A lesson to choose.

    Args:
        name: its name.
        title: its title.
        level: 1 (first drive) to 4.
        minutes: how long it takes.
        aims: what pupils learn.
        robots: the kinds of robots that it supports, the default first.
        steps: the number of its steps.
        stars: how many stars there are to earn.
        picture: the file of its picture; empty if it has none.
        own: whether it is one of the user's lessons.
        earned: the stars earned so far.
        step: the step that the user has reached, from 1; 0 before the first.
        project: the project in which this browser has begun it; empty if there is none.
    """

    name: str
    title: LessonText
    level: int
    minutes: int
    aims: tuple[LessonText, ...]
    robots: tuple[str, ...]
    steps: int
    stars: int
    picture: str = ""
    own: bool = False
    earned: int = 0
    step: int = 0
    project: str = ""


class Lessons(ToPage, frozen=True):
    """The lessons to choose from, by level.

    Args:
        lessons: the lessons.
        problems: the errors in files of the user's folder.
    """

    lessons: tuple[LessonChoice, ...]
    problems: tuple[Phrase, ...] = ()


class LessonStep(Struct, frozen=True, omit_defaults=True):
    """A step of a lesson, in its list.

    Args:
        title: its title.
        phase: its part in PRIMM.
        stars: how many stars there are to earn.
        earned: those earned so far.
    """

    title: LessonText
    phase: Phase
    stars: int = 0
    earned: int = 0


class LessonGoal(Struct, frozen=True, omit_defaults=True):
    """A check of a step.

    Args:
        say: what the pupil reads.
        state: ``open`` until it is decided.
        optional: whether the step is done without it.
        reason: why it failed: by how much, if that is known.
        place: what was missed, (x mm, y mm), if it has a place.
        nearest: how near to it the robot came.
        earned: whether its star was earned before.
        ask: the kind of question about the run that leads to why it failed; "" for none.
        subject: what that question is about.
    """

    say: LessonWords
    state: Literal["open", "met", "failed"] = "open"
    optional: bool = False
    reason: Phrase | None = None
    place: tuple[float, float] | None = None
    nearest: tuple[float, float] | None = None
    earned: bool = False
    ask: Literal["", "now", "goal", "bump"] = ""
    subject: str = ""


class LessonQuiz(Struct, frozen=True, omit_defaults=True):
    """A question with answers to choose from.

    Args:
        question: the question.
        choices: the answers.
        several: whether more than one is right.
        solved: whether it has been answered correctly.
    """

    question: LessonText
    choices: tuple[LessonText, ...]
    several: bool = False
    solved: bool = False


class LessonPuzzle(Struct, frozen=True, omit_defaults=True):
    """Pieces of a program, to be put in order.

    Args:
        pieces: lines of Block-Text, shuffled, with some that do not belong to the program.
        solved: whether they have been put in order.
    """

    pieces: tuple[str, ...]
    solved: bool = False


class LessonShown(ToPage, frozen=True):
    """The lesson of the open project; an empty name means that there is none.

    Args:
        name: the name of the lesson.
        title: its title.
        level: its level.
        steps: its steps.
        step: the current one, from 1.
        text: its instructions, in Markdown.
        drawings: the blocks of the texts and of the puzzle's pieces, by their Block-Text.
        goals: its checks.
        attempts: in how many worlds and on how many robots it can be checked; at most 1 without
            any besides the usual.
        everywhere: whether the program has passed in all of them.
        hints: how many levels of hints the pupil has taken in this step.
        quiz: its question.
        puzzle: its puzzle.
        restarts: whether it has a program to begin with.
    """

    name: str = ""
    title: LessonText = ""
    level: int = 1
    steps: tuple[LessonStep, ...] = ()
    step: int = 1
    text: LessonText = ""
    drawings: dict[str, Workspace] = field(default_factory=dict)
    goals: tuple[LessonGoal, ...] = ()
    attempts: int = 0
    everywhere: bool = False
    hints: int = 0
    quiz: LessonQuiz | None = None
    puzzle: LessonPuzzle | None = None
    restarts: bool = False


class LessonGoals(ToPage, frozen=True):
    """The checks of the current step, while a program runs and at its end.

    Args:
        goals: the checks.
        live: whether the program runs.
        done: whether the run has met all that are not optional.
        earned: the stars that it has just earned.
        steps: the steps, with the stars earned.
    """

    goals: tuple[LessonGoal, ...]
    live: bool = False
    done: bool = False
    earned: int = 0
    steps: tuple[LessonStep, ...] = ()


class LessonAttempt(Struct, frozen=True, omit_defaults=True):
    """The result of the program in one variant of the world, on one robot.

    Args:
        robot: the kind of robot.
        variant: the number of the variant; 0 is the world as it is drawn.
        passed: whether all checks that are not optional were met; None before it has run.
        reasons: why not.
    """

    robot: str
    variant: int = 0
    passed: bool | None = None
    reasons: tuple[Phrase, ...] = ()


class LessonChecked(ToPage, frozen=True):
    """The progress of the check on all variants and robots.

    Args:
        attempts: all of them.
        running: whether it is still running.
        everywhere: whether the program has passed in all.
        problem: why it could not be checked.
    """

    attempts: tuple[LessonAttempt, ...] = ()
    running: bool = False
    everywhere: bool = False
    problem: Phrase | None = None


class LessonHint(Struct, frozen=True, omit_defaults=True):
    """A hint, up to the level that the pupil has asked for.

    Args:
        levels: what it says, the most general last.
    """

    levels: tuple[LessonWords, ...]


class LessonHints(ToPage, frozen=True):
    """The hints of the last run.

    Args:
        hints: those that the pupil has asked for; the last one is the newest.
        more: whether there is another level, or another hint.
        count: how many levels the pupil has taken in this step.
    """

    hints: tuple[LessonHint, ...] = ()
    more: bool = True
    count: int = 0


class QuizJudged(ToPage, frozen=True):
    """Whether an answer is right.

    Args:
        right: whether exactly the right answers were chosen.
        because: why the chosen ones are right or wrong, by their indices.
    """

    right: bool
    because: dict[str, LessonText] = field(default_factory=dict)


class PuzzleJudged(ToPage, frozen=True):
    """Whether a puzzle is solved.

    Args:
        right: whether it is.
        good: how many pieces are right from the start.
    """

    right: bool
    good: int = 0


class LessonImported(ToPage, frozen=True):
    """A lesson has been added to the user's."""

    lesson: str
    title: LessonText
