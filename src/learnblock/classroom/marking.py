"""What the teacher sees of hand-ins, and does with them."""

import asyncio
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from typing import Any, get_args

from learnblock import language
from learnblock.classroom import hand_in_messages as ours
from learnblock.classroom.checking import Checking, RunningCheck, forget_runs
from learnblock.classroom.collecting import made_by
from learnblock.classroom.hand_ins import HandInFile, HandInShelf, State
from learnblock.classroom.roster import Roster, names_of
from learnblock.errors import FileError, LearnBlockError
from learnblock.lessons.drawing import LONGEST_DRAWING, drawing_of
from learnblock.lessons.lesson import LessonText
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.reading import named_lesson
from learnblock.lessons.texts import plain
from learnblock.lessons.trying import attempts
from learnblock.monitor.worlds import world_values
from learnblock.server.messages import GivenProgram

#: The teacher's last notes that are offered again.
_MOST_NOTES = 6
#: The hand-ins that the wall lists besides those in open steps.
_MOST_WAITING = 100
#: The pupils who miss the same before it counts as a common mistake.
_COMMON = 2


@dataclass(frozen=True)
class TaughtLesson:
    """What the list of hand-ins needs of a lesson.

    Args:
        opened: the lesson.
    """

    opened: OpenLesson

    @property
    def title(self) -> LessonText:
        """Its title."""
        return plain(self.opened.lesson.title)

    @cached_property
    def steps(self) -> Mapping[int, LessonText]:
        """The titles of the steps that can be handed in, by their numbers."""
        steps = enumerate(self.opened.lesson.step, 1)
        return {number: plain(step.title) for number, step in steps if step.check}


class Marking:
    """The hand-ins of a class, for the teacher.

    Args:
        roster: the class.
        shelf: its hand-ins.
        changed: called when something has changed.
    """

    def __init__(self, roster: Roster, shelf: HandInShelf, changed: Callable[[], object]) -> None:
        self.checking = Checking(roster, shelf, changed)
        self._roster = roster
        self._shelf = shelf
        self._lessons: dict[str, TaughtLesson | None] = {}

    def steps(self, lessons: Iterable[str]) -> ours.HandInSteps:
        """How many have handed in what.

        Args:
            lessons: the names of lessons whose steps are listed even without a hand-in.
        """
        files = (file for pupil in self._roster.pupils for file in self._files(pupil.id))
        states = Counter((file.work.lesson, file.work.step, file.state) for file in files)
        names = dict.fromkeys([*lessons, *sorted(lesson for lesson, _, _ in states)])
        known = [(name, lesson) for name in names if (lesson := self._lesson(name))]
        return ours.HandInSteps(
            steps=tuple(
                _step(name, lesson, number, states)
                for name, lesson in known
                for number in lesson.steps
            ),
            revision=self._shelf.revision,
            checking=_progress(self.checking.running),
            failure=self.checking.failure,
        )

    def waiting(self, places: Mapping[str, tuple[str, int]]) -> ours.WaitingHandIns:
        """What waits to be handed back, except for the work in the steps that are open.

        Args:
            places: the lesson and the step that each pupil has open, by the pupils' ids.
        """
        hand_ins = [
            (file.at, _waiting(pupil.id, lesson, file))
            for pupil in self._roster.pupils
            for place, file in self._shelf.of_pupil(pupil.id).items()
            if file.waits and place != places.get(pupil.id)
            # What the page with the hand-ins does not list can't be handed back.
            if (lesson := self._lesson(place[0])) and place[1] in lesson.steps
        ]
        hand_ins.sort(key=lambda hand_in: -hand_in[0])
        newest = tuple(hand_in for _, hand_in in hand_ins[:_MOST_WAITING])
        return ours.WaitingHandIns(newest, more=len(hand_ins) - len(newest))

    def listed(self, lesson: str, step: int) -> ours.HandInList:
        """The hand-ins of a step.

        Raises:
            LearnBlockError: there is no such lesson or step.
        """
        opened = named_lesson(lesson)
        taught = TaughtLesson(opened)
        names = names_of(self._roster.pupils)
        lines = tuple(
            _line(pupil.id, names[pupil.id], file)
            for pupil in self._roster.pupils
            if (file := self._shelf.of_pupil(pupil.id).get((lesson, step)))
        )
        return ours.HandInList(
            lesson=lesson,
            title=taught.title,
            step=step,
            step_title=plain(opened.step(step).title),
            starts=len(attempts(opened, step)),
            lines=lines,
            without=tuple(self._without(names, opened, step)),
            often=_often(lines),
            notes=self._notes(),
        )

    def file(self, pupil: str, lesson: str, step: int) -> HandInFile:
        """A pupil's hand-in, without the program.

        Raises:
            LearnBlockError: there is none.
        """
        file = self._shelf.of_pupil(pupil).get((lesson, step))
        if file is None:
            raise LearnBlockError("class-not-handed-in")
        return file

    def shown(self, pupil: str, lesson: str, step: int) -> ours.ShownHandIn:
        """A hand-in with its program.

        Raises:
            LearnBlockError: there is none.
        """
        file = self._shelf.known(pupil, lesson, step)
        variant = file.checked.variant if file.checked else 0
        blocktext = _blocktext(file.work.program)
        drawing = drawing_of(blocktext) if 0 < len(blocktext) <= LONGEST_DRAWING else None
        return ours.ShownHandIn(
            line=_line(pupil, names_of(self._roster.pupils)[pupil], file),
            lesson=lesson,
            step=step,
            program=file.work.program,
            checked=file.checked,
            back=file.back,
            world=_world(named_lesson(lesson), step, variant),
            blocktext=blocktext,
            blocks=drawing.workspace if drawing else None,
            lines=drawing.lines if drawing else {},
        )

    def collect(self, lesson: str, step: int) -> None:
        """Take the newest programs of those who have begun a step and not handed it in.

        Raises:
            LearnBlockError: there is no such lesson or step.
            OSError: it can't be saved.
        """
        opened = named_lesson(lesson)
        opened.step(step)
        for pupil in self._roster.pupils:
            if (lesson, step) in self._shelf.of_pupil(pupil.id):
                continue
            made = made_by(self._roster, pupil, opened, step)
            if made.work:
                self._shelf.add(pupil.id, made.work, collected=True)

    def hand_back(self, lesson: str, step: int, pupils: Iterable[str]) -> None:
        """Hand back notes and marks.

        Raises:
            LearnBlockError: one of the pupils has not handed in; nothing is handed back.
            OSError: it can't be saved.
        """
        wanted = tuple(dict.fromkeys(pupils))
        for pupil in wanted:
            self._shelf.known(pupil, lesson, step)
        for pupil in wanted:
            self._shelf.hand_back(pupil, lesson, step)

    async def forget(self, pupil: str) -> None:
        """Delete what a pupil has handed in, before the pupil is deleted.

        Raises:
            OSError: some of it can't be deleted.
        """
        await self.checking.close()
        await asyncio.to_thread(self._shelf.remove, pupil)

    def forget_runs(self) -> None:
        """Delete the finished runs of programs that are no longer handed in.

        Raises:
            OSError: some of them can't be deleted.
        """
        forget_runs(self._roster)

    def _files(self, pupil: str) -> Iterable[HandInFile]:
        return self._shelf.of_pupil(pupil).values()

    def _lesson(self, name: str) -> TaughtLesson | None:
        if name not in self._lessons:
            self._lessons[name] = None
            # Of a lesson that is gone there is nothing to list.
            with suppress(LearnBlockError, OSError):
                self._lessons[name] = TaughtLesson(named_lesson(name))
        return self._lessons[name]

    def _without(
        self, names: Mapping[str, str], opened: OpenLesson, step: int
    ) -> Iterator[ours.PupilWithout]:
        for pupil in self._roster.pupils:
            if (opened.name, step) not in self._shelf.of_pupil(pupil.id):
                has_begun = made_by(self._roster, pupil, opened, step).has_begun
                state: ours.Without = "not handed in" if has_begun else "not begun"
                yield ours.PupilWithout(pupil.id, names[pupil.id], state)

    def _notes(self) -> tuple[str, ...]:
        backs = (
            back
            for pupil in self._roster.pupils
            for file in self._files(pupil.id)
            for back in file.back
        )
        newest = sorted(backs, key=lambda back: -back.at)
        return tuple(dict.fromkeys(back.note for back in newest if back.note))[:_MOST_NOTES]


def _progress(running: RunningCheck | None) -> ours.CheckProgress | None:
    if running is None:
        return None
    news = running.news
    return ours.CheckProgress(running.lesson, running.step, news.done, news.total)


def _step(
    name: str, lesson: TaughtLesson, number: int, states: Mapping[tuple[str, int, State], int]
) -> ours.HandInStep:
    counts = {state: states.get((name, number, state), 0) for state in get_args(State)}
    return ours.HandInStep(
        lesson=name,
        title=lesson.title,
        step=number,
        step_title=lesson.steps[number],
        count=sum(counts.values()),
        to_check=counts["to check"],
        to_mark=counts["to mark"],
        marked=counts["marked"],
    )


def _waiting(pupil: str, lesson: TaughtLesson, file: HandInFile) -> ours.WaitingHandIn:
    work = file.work
    return ours.WaitingHandIn(pupil, work.lesson, lesson.title, work.step, work.tries)


def _line(pupil: str, name: str, file: HandInFile) -> ours.HandInLine:
    checked = file.checked
    last = file.back[-1] if file.back and not file.waits else None
    return ours.HandInLine(
        pupil=pupil,
        name=name,
        state=file.state,
        at=file.at,
        collected=file.collected,
        tries=file.work.tries,
        checked=checked is not None,
        stars=checked.stars if checked else 0,
        missed=_missed(file),
        note=last.note if last else file.note,
        mark=last.mark if last else file.mark,
        line=last.line if last else file.line,
    )


def _missed(file: HandInFile) -> LessonText:
    """What was missed first, in words: why, or else what."""
    checked = file.checked
    if checked is None:
        return ""
    if not checked.missed:
        return checked.reason if not checked.done else ""
    return checked.missed[0].reason or checked.missed[0].say


def _often(lines: Iterable[ours.HandInLine]) -> ours.CommonMistake | None:
    missed = [line.missed for line in lines if line.missed]
    counts = [ours.CommonMistake(text, missed.count(text)) for text in missed]
    most = max(counts, key=lambda mistake: mistake.count, default=None)
    return most if most and most.count >= _COMMON else None


def _world(opened: OpenLesson, step: int, variant: int) -> dict[str, Any] | None:
    try:
        world = opened.described_variant(step, variant)
        return None if world is None else world_values(world)
    except (LearnBlockError, OSError):
        return None


def _blocktext(program: GivenProgram) -> str:
    if not program.is_python:
        return program.text
    with suppress(FileError, RecursionError):
        return language.format(language.from_python(program.text, ""))
    return ""
