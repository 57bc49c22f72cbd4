"""What pupils have handed in, with the teacher's notes and marks, in the folder of the class.

Each hand-in is a file, ``hand-ins/PUPIL/LESSON.STEP.json``, which is replaced as a whole. It is
beside the pupils' own folders, so no program of a pupil can write a mark.
"""

import re
import shutil
import threading
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Literal

import msgspec
from msgspec import Meta, Struct
from msgspec.structs import replace

from learnblock.errors import LearnBlockError
from learnblock.lessons.lesson import LessonText
from learnblock.project.files.lesson_folder import Number
from learnblock.project.files.project_file import LARGEST
from learnblock.server.messages import GivenProgram, GivenWork
from learnblock.storage.files import save

#: The folder of the hand-ins in that of the class.
FOLDER = "hand-ins"
#: The folder of the finished runs of checks; they have no names in them.
RUNS = "checks"
#: The path of a hand-in in the folder of the class.
PATH = re.compile(rf"{FOLDER}/[a-z0-9]{{10}}/\w[\w .-]{{0,78}}\w\.[0-9]{{1,2}}\.json")
#: The most hand-ins of a pupil.
MOST_HAND_INS = 300
#: The most times that a hand-in is kept as it was handed back; the oldest are left out.
_MOST_BACK = 20
#: A larger file is not ours: a program, in which JSON may write each character as six.
_LARGEST = 7 * LARGEST
_VERSION = 1

Note = Annotated[str, Meta(max_length=1000)]
#: Any scale: numbers, letters, words.
Mark = Annotated[str, Meta(max_length=20)]
Count = Annotated[int, Meta(ge=0, le=1000)]
#: What the teacher has to do: nothing has been checked, nothing has been said, it waits to be
#: handed back; or what the pupil does with what is back.
State = Literal["to check", "to mark", "marked", "handed back", "improving"]


class NotedLine(Struct, frozen=True):
    """The line of a program that a note is about.

    Args:
        number: of the line, from 1: in Block-Text, or in Python that can't be written so.
        text: the line as it was handed in, or its beginning; it is shown if the line is gone.
    """

    number: Annotated[int, Meta(ge=1, le=1_000_000)]
    text: Annotated[str, Meta(min_length=1, max_length=200)]


class CheckSummary(Struct, frozen=True, omit_defaults=True):
    """What a check of the step says of a hand-in.

    Args:
        say: what it asks for.
        met: in how many runs it was met.
        optional: whether the step is done without it.
        reason: why it was missed first; empty if it was not, or nothing more is known.
    """

    say: LessonText
    met: Count
    optional: bool = False
    reason: LessonText = ""


class HintSummary(Struct, frozen=True, omit_defaults=True):
    """A hint that fits a hand-in.

    Args:
        because: why it was chosen.
        says: its first level.
    """

    because: LessonText
    says: LessonText


class CheckedWork(Struct, frozen=True, omit_defaults=True):
    """What the lesson's checks say of a hand-in; the runs themselves are in the table.

    Args:
        runs: how many were made.
        done: in how many the step was done.
        checks: the checks of the step.
        hints: the hints that fit, best first.
        way: where the robot drove in the run that is shown: x and y in mm, alternating.
        robot: the robot of that run.
        variant: the variant of the world of that run.
        seconds: how long it took, in the robot's time.
        reason: why the program could not be run, or the error that ended the run.
    """

    runs: Count
    done: Count
    checks: tuple[CheckSummary, ...] = ()
    hints: tuple[HintSummary, ...] = ()
    way: tuple[float, ...] = ()
    robot: str = ""
    variant: int = 0
    seconds: float = 0.0
    reason: LessonText = ""

    @property
    def stars(self) -> int:
        """Three if the step was done in all runs, two in more than half, one in some."""
        if not self.done:
            return 0
        return 3 if self.done == self.runs else 2 if 2 * self.done > self.runs else 1

    @property
    def reached(self) -> tuple[CheckSummary, ...]:
        """The checks that were met in all runs."""
        return tuple(check for check in self.checks if check.met == self.runs)

    @property
    def missed(self) -> tuple[CheckSummary, ...]:
        """The checks that were not, those first without which the step is not done."""
        missed = (check for check in self.checks if check.met < self.runs)
        return tuple(sorted(missed, key=lambda check: check.optional))


class HandedBack(Struct, frozen=True, omit_defaults=True):
    """What the teacher has handed back.

    Args:
        at: when, in seconds since 1970.
        note: the teacher's note.
        mark: the teacher's mark; empty without one.
        checked: what the checks said; None if they were not asked.
        line: what the note is about; None if it is about the whole program.
    """

    at: float
    note: Note = ""
    mark: Mark = ""
    checked: CheckedWork | None = None
    line: NotedLine | None = None


class HandInFile(Struct, frozen=True, omit_defaults=True):
    """A pupil's hand-in in a step of a lesson.

    Args:
        work: the program.
        version: of the format.
        at: when it was handed in, in seconds since 1970.
        collected: whether the teacher has collected it.
        times: how often it was handed in.
        waits: whether it is to be handed back.
        checked: what the checks say of it; None if they were not asked.
        note: the teacher's note, not handed back yet.
        mark: the teacher's mark, not handed back yet.
        back: what was handed back, the newest last.
        improving: whether the pupil improves what was handed back.
        line: what the note is about; None if it is about the whole program.
    """

    work: GivenWork
    version: Annotated[int, Meta(ge=1, le=_VERSION)] = _VERSION
    at: float = 0.0
    collected: bool = False
    times: Number = 1
    waits: bool = True
    checked: CheckedWork | None = None
    note: Note = ""
    mark: Mark = ""
    back: Annotated[tuple[HandedBack, ...], Meta(max_length=_MOST_BACK)] = ()
    improving: bool = False
    line: NotedLine | None = None

    @property
    def is_new(self) -> bool:
        """Whether it was handed in after what was handed back last."""
        return not self.back or self.at > self.back[-1].at

    @property
    def state(self) -> State:
        """What is to be done with it."""
        if not self.waits:
            return "improving" if self.improving else "handed back"
        if self.note or self.mark:
            return "marked"
        return "to check" if self.checked is None else "to mark"


_decode = msgspec.json.Decoder(HandInFile).decode


class HandInShelf:
    """The hand-ins of a class; several threads may use it.

    Args:
        folder: of the class.
        now: the time in seconds since 1970.
    """

    def __init__(self, folder: Path, now: Callable[[], float] = time.time) -> None:
        self.folder = folder / FOLDER
        self._now = now
        self._lock = threading.Lock()
        #: By pupil, lesson and step, without the programs.
        self._listed: dict[str, dict[tuple[str, int], HandInFile]] = {}
        self._gone: set[str] = set()
        #: Counts the changes, so that who shows the hand-ins knows when to read them again.
        self.revision = 0

    def folder_of(self, pupil: str) -> Path:
        """The folder with what a pupil has handed in."""
        return self.folder / pupil

    def path_of(self, pupil: str, lesson: str, step: int) -> Path:
        """The file of a hand-in."""
        return self.folder_of(pupil) / f"{lesson}.{step}.json"

    def read(self, pupil: str, lesson: str, step: int) -> HandInFile | None:
        """A pupil's hand-in; None if there is none, or a damaged file."""
        return _read(self.path_of(pupil, lesson, step))

    def of_pupil(self, pupil: str) -> Mapping[tuple[str, int], HandInFile]:
        """All hand-ins of a pupil by lesson and step, without their programs."""
        listed = self._listed.get(pupil)
        if listed is None:
            files = map(_read, sorted(self.folder_of(pupil).glob("*.json")))
            listed = {_place(file): _without_program(file) for file in files if file}
            self._listed[pupil] = listed
        return MappingProxyType(listed)

    def add(self, pupil: str, work: GivenWork, *, collected: bool = False) -> HandInFile:
        """Hand in a program; what was not handed back yet is replaced.

        Raises:
            LearnBlockError: the pupil has left the class, or has handed in too much.
            OSError: it can't be saved.
            ValueError: the program is too large.
        """
        with self._lock:
            if pupil in self._gone:
                raise LearnBlockError("class-no-pupil")
            listed = self.of_pupil(pupil)
            if len(listed) >= MOST_HAND_INS and (work.lesson, work.step) not in listed:
                raise LearnBlockError("class-too-many-hand-ins", most=MOST_HAND_INS)
            before = self.read(pupil, work.lesson, work.step)
            file = HandInFile(work, at=self._now(), collected=collected)
            if before:
                same = before.work.program == work.program
                file = replace(
                    file,
                    times=before.times + 1,
                    back=before.back,
                    checked=before.checked if same else None,
                    note=before.note if before.waits else "",
                    mark=before.mark if before.waits else "",
                    line=before.line if before.waits else None,
                )
            return self._keep(pupil, file)

    def improve(self, pupil: str, lesson: str, step: int) -> None:
        """Record that a pupil improves what was handed back.

        Raises:
            LearnBlockError: nothing was handed in.
            OSError: it can't be saved.
        """
        with self._lock:
            file = self.known(pupil, lesson, step)
            if not file.waits:
                self._keep(pupil, replace(file, improving=True))

    def say(
        self,
        pupil: str,
        lesson: str,
        step: int,
        *,
        note: str,
        mark: str,
        line: NotedLine | None = None,
    ) -> None:
        """Set the note and the mark that are handed back next, and what the note is about.

        What is said already stays as it is, handed back or not: a page repeats it when a field is
        left.

        Raises:
            LearnBlockError: nothing was handed in.
            OSError: it can't be saved.
        """
        with self._lock:
            file = self.known(pupil, lesson, step)
            if (note, mark, line) != (file.note, file.mark, file.line):
                self._keep(pupil, replace(file, note=note, mark=mark, line=line, waits=True))

    def hand_back(self, pupil: str, lesson: str, step: int) -> None:
        """Hand back note and mark; nothing happens if they are back already.

        Raises:
            LearnBlockError: nothing was handed in.
            OSError: it can't be saved.
        """
        with self._lock:
            file = self.known(pupil, lesson, step)
            if file.waits:
                back = HandedBack(
                    self._now(),
                    file.note,
                    file.mark,
                    file.checked,
                    file.line if file.note else None,
                )
                backs = (*file.back, back)[-_MOST_BACK:]
                self._keep(pupil, replace(file, waits=False, improving=False, back=backs))

    def keep_checked(self, pupil: str, work: GivenWork, checked: CheckedWork) -> None:
        """Keep what the checks say, unless another program has been handed in meanwhile.

        Raises:
            OSError: it can't be saved.
        """
        with self._lock:
            file = self.read(pupil, work.lesson, work.step)
            if file and file.work.program == work.program:
                self._keep(pupil, replace(file, checked=checked))

    def remove(self, pupil: str) -> None:
        """Delete all that a pupil has handed in.

        Raises:
            OSError: some of it can't be deleted.
        """
        with self._lock:
            if (files := self.folder_of(pupil)).exists():
                shutil.rmtree(files)
            self._gone.add(pupil)
            self._listed.pop(pupil, None)
            self.revision += 1

    def known(self, pupil: str, lesson: str, step: int) -> HandInFile:
        """A pupil's hand-in.

        Raises:
            LearnBlockError: there is none.
        """
        file = self.read(pupil, lesson, step)
        if file is None:
            raise LearnBlockError("class-not-handed-in")
        return file

    def _keep(self, pupil: str, file: HandInFile) -> HandInFile:
        path = self.path_of(pupil, file.work.lesson, file.work.step)
        data = msgspec.json.encode(file)
        # What could not be read again is refused now.
        _decode(data)
        listed = dict(self.of_pupil(pupil))
        save(path, data, private=True)
        self._listed[pupil] = {**listed, _place(file): _without_program(file)}
        self.revision += 1
        return file


def _place(file: HandInFile) -> tuple[str, int]:
    return file.work.lesson, file.work.step


def _without_program(file: HandInFile) -> HandInFile:
    return replace(file, work=replace(file.work, program=GivenProgram("")))


def _read(path: Path) -> HandInFile | None:
    try:
        with path.open("rb") as file:
            data = file.read(_LARGEST + 1)
        return _decode(data) if len(data) <= _LARGEST else None
    except (OSError, msgspec.MsgspecError, UnicodeError, RecursionError):
        # Another program may have put any file there.
        return None
