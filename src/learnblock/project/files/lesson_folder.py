"""How far a project has come in its lesson, in files beside its history.

``lesson.json`` has the lesson's name, the step, and for each step its stars, hints and answers;
``lesson-step-N.program`` is the program that the user left in step N. Nothing of it is in the
project's own file, so a project that is handed on has no marks in it.
"""

import dataclasses
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

import msgspec
from msgspec import Meta, Struct, field
from msgspec.structs import replace

from learnblock.errors import ProjectError
from learnblock.project.files.carried import NOTHING
from learnblock.project.files.project import Project
from learnblock.project.files.project_file import LARGEST as LARGEST_PROGRAM
from learnblock.project.files.project_file import decode, encode
from learnblock.storage.files import save

#: The version of ``lesson.json``, and its limit in bytes.
VERSION = 1
LARGEST = 30_000
#: The largest number of hints and of tries that is counted.
MOST = 100_000
#: The names of stars: all checks in one run, all variants and robots, the question, the puzzle.
GOALS, EVERYWHERE, QUIZ, PUZZLE = "goals", "everywhere", "quiz", "puzzle"

#: The name of a lesson: of its folder or file.
LessonName = Annotated[str, Meta(pattern=r"^[\w][\w .-]{0,78}\w$")]
#: A random id that a browser keeps: 128 bits in hexadecimal.
BrowserId = Annotated[str, Meta(pattern="^[0-9a-f]{32}$")]
StepNumber = Annotated[int, Meta(ge=1, le=30)]
Star = Annotated[str, Meta(pattern="^(goals|everywhere|quiz|puzzle|check-[0-9]{1,2})$")]
Number = Annotated[int, Meta(ge=0, le=MOST)]


class StepProgress(Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """What has been done in a step.

    Args:
        stars: those earned, by name; ``check-3`` is that of the fourth check, an optional one.
        hints: how many levels of hints were taken.
        quiz: the choices answered last.
        tries: how often the quiz and the puzzle were answered.
        runs: how often the program was run.
    """

    stars: Annotated[tuple[Star, ...], Meta(max_length=20)] = ()
    hints: Number = 0
    quiz: Annotated[tuple[Annotated[int, Meta(ge=0, le=7)], ...], Meta(max_length=8)] = ()
    tries: Number = 0
    runs: Number = 0


class Progress(Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """How far a project has come in a lesson.

    Args:
        lesson: the name of the lesson.
        version: the version of this format.
        step: the current step, from 1.
        browser: the id of the browser in which it was begun; empty for one of before there were
            ids, and of the server's own computer.
        steps: what has been done, by the number of the step.
    """

    lesson: LessonName
    version: Annotated[int, Meta(ge=1, le=VERSION)] = VERSION
    step: StepNumber = 1
    browser: BrowserId | Literal[""] = ""
    steps: Annotated[
        dict[Annotated[str, Meta(pattern="^[0-9]{1,2}$")], StepProgress], Meta(max_length=30)
    ] = field(default_factory=dict)

    def of(self, step: int) -> StepProgress:
        """What has been done in a step."""
        return self.steps.get(str(step), StepProgress())

    def with_step(self, step: int, progress: StepProgress) -> "Progress":
        """The progress after something has been done in a step."""
        return replace(self, steps={**self.steps, str(step): progress})


_read = msgspec.json.Decoder(Progress).decode


@dataclass(frozen=True)
class LessonFolder:
    """The files of a project's lesson.

    Args:
        name: the name of the project.
        folder: the folder of its history, which may not exist yet.
        read_only: whether nothing may be written.
    """

    name: str
    folder: Path
    read_only: bool = False

    def progress(self) -> Progress | None:
        """How far the project has come; None if it has no lesson, or a damaged file."""
        try:
            with self._progress.open("rb") as file:
                data = file.read(LARGEST + 1)
            return _read(data) if len(data) <= LARGEST else None
        except (OSError, msgspec.MsgspecError, RecursionError):
            # Another program may have put any file there.
            return None

    def keep_progress(self, progress: Progress) -> None:
        """Save how far the project has come.

        Raises:
            OSError: it can't be saved.
        """
        if not self.read_only:
            save(self._progress, msgspec.json.encode(progress))

    def program(self, step: int) -> Project | None:
        """The program that the user left in a step; None if there is none, or a damaged one."""
        try:
            with self._program(step).open("rb") as file:
                return decode(file.read(LARGEST_PROGRAM + 1), self.name)
        except (OSError, ProjectError):
            return None

    def keep_program(self, step: int, project: Project) -> None:
        """Save the program that the user leaves in a step.

        Raises:
            OSError: it can't be saved.
        """
        if not self.read_only:
            save(self._program(step), encode(dataclasses.replace(project, carried=NOTHING)))

    def copy_to(self, other: "LessonFolder", browser: str) -> None:
        """Give a copy of the project the same progress, if there is any.

        Args:
            other: the folder of the copy.
            browser: the id of the browser in which it was copied.

        Raises:
            OSError: it can't be saved.
        """
        progress = self.progress()
        if progress is None:
            return
        other.keep_progress(replace(progress, browser=browser))
        for step in range(1, 31):
            if program := self.program(step):
                other.keep_program(step, program)

    @property
    def _progress(self) -> Path:
        return self.folder / "lesson.json"

    def _program(self, step: int) -> Path:
        return self.folder / f"lesson-step-{step}.program"
