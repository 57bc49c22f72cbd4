"""Interprets a plain sentence by the meaning of its words."""

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from learnblock.runtime.log.nodes import Kind, Node
from learnblock.why import wording
from learnblock.why.history import EventHistory
from learnblock.why.questions import QuestionKind
from learnblock.why.vocabulary import EMOTIONS, Concept, concept, forms, words

#: Skills by what they use.
_DEVICES: tuple[tuple[Concept, str], ...] = (
    (Concept.LAMP, r"led|RGBled"),
    (Concept.SOUND, r"play_|rest|.*_action"),
    (Concept.SAY, r"say_Text|play_audio"),
    (Concept.SCREEN, r"show_|matrix_|clear_screen"),
    (Concept.CAMERA, r"look_|setAngleCamera|.*_camera"),
    (Concept.PEN, r"pen_|.*_pen"),
    (Concept.FACE, r"express"),
)
#: Words that mean nothing but a device.
_ONLY_DEVICES = (Concept.LAMP, Concept.SOUND, Concept.SCREEN, Concept.PEN)
#: The names of the devices that see something.
_SENSES: dict[Concept, tuple[str, ...]] = {
    Concept.WALL: ("obstacle-", "DistanceSensors"),
    Concept.TRACK: ("black-line", "red-line", "blue-line", "ground-line"),
    Concept.EDGE: ("GroundSensors",),
    Concept.TAG: ("Camera",),
    Concept.FACE: ("Camera",),
}
_MOTIONS = frozenset(
    {
        Concept.TURN,
        Concept.CURVE,
        Concept.LEFT,
        Concept.RIGHT,
        Concept.BACK,
        Concept.FORWARD,
        Concept.MOVE,
        Concept.STOP,
    }
)
#: Where the subject ends and the circumstances begin.
_CIRCUMSTANCES = re.compile(rf",|\b{forms('circumstances')}\b")
_WHY = re.compile(rf"^{forms('why')}\b")
#: What is left of a question without a subject.
_NO_SUBJECT = re.compile(rf"{forms('no_subject')}?")


@dataclass(frozen=True, slots=True)
class Meaning:
    """A kind of question and its subject."""

    ask: QuestionKind
    subject: str = ""
    #: Whether the question is about the first time.
    is_first: bool = False


def main_part(text: str) -> str:
    """A plain sentence without its circumstances: "before it turned", "when it sees the box"."""
    if _CIRCUMSTANCES.match(text):
        # The circumstances come first.
        _, _, rest = text.partition(",")
        return rest.strip() or text
    circumstances = _CIRCUMSTANCES.search(text)
    part = text[: circumstances.start()].strip() if circumstances else text
    return text if _NO_SUBJECT.fullmatch(_WHY.sub("", part).strip()) else part


class SentenceReader:
    """Finds out what the words of one question mean.

    Args:
        text: a plain sentence, without times.
        history: of the run.
        correct: gives a word without its slip.
    """

    def __init__(self, text: str, history: EventHistory, correct: Callable[[str], str]) -> None:
        self._history = history
        self.tokens = [correct(word) for word in words(text)]
        meanings = [(word, concept(word)) for word in self.tokens]
        #: In the order of the words.
        self.concepts = [
            meaning for _, meaning in meanings if meaning and meaning is not Concept.FILLER
        ]
        self._known = frozenset(self.concepts)
        #: The unknown words.
        self.unknown = [word for word, meaning in meanings if meaning is None]
        self.is_negative = Concept.NOT in self._known

    def meaning(self) -> Meaning | None:
        """The question; None if the words do not contain it."""
        for find in (
            self._nothing,
            self._error,
            self._bump,
            self._fall,
            self._seen,
            self._emotion,
            self._device,
            self._line_lost,
            self._speed,
            self._avoid,
            self._long,
            self._end,
            self._stop,
            self._motion,
            self._goal,
        ):
            meaning = find()
            if meaning is not None:
                return Meaning(meaning.ask, meaning.subject, Concept.FIRST in self._known)
        return None

    def _has(self, *some: Concept) -> bool:
        return not self._known.isdisjoint(some)

    def _nothing(self) -> Meaning | None:
        if self._has(Concept.NOTHING) and not self._has(
            Concept.PRINT, Concept.SAY, Concept.SHOW, Concept.CRASH
        ):
            return Meaning(QuestionKind.NOTHING)
        return None

    def _error(self) -> Meaning | None:
        return (
            Meaning(QuestionKind.END) if self._has(Concept.ERROR) and not self.is_negative else None
        )

    def _bump(self) -> Meaning | None:
        if not self._has(Concept.CRASH):
            return None
        bumps = any("bump" in line for line in self._history.recorded.lines)
        has_failed = bool(self._history.recorded.ending.get("error"))
        # A program crashes as well.
        is_program = has_failed and (not bumps or self._has(Concept.PROGRAM))
        return Meaning(QuestionKind.END if is_program else QuestionKind.BUMP)

    def _fall(self) -> Meaning | None:
        return Meaning(QuestionKind.FALL) if self._has(Concept.FALL) else None

    def _seen(self) -> Meaning | None:
        """It did not see something: a statement that would have run if it had."""
        sense = next((word for word in self.concepts if word in _SENSES), None)
        if not self._has(Concept.SEE) or sense is None:
            return None
        nodes = self._history.nodes
        asking = [number for number, node in enumerate(nodes) if self._senses(node, sense)]
        whens = (number for number, node in enumerate(nodes) if node.kind is Kind.WHEN)
        if (
            when := next((number for number in whens if self._is_of(number, asking)), None)
        ) is not None:
            return Meaning(
                QuestionKind.NOT_WHEN if self.is_negative else QuestionKind.WHEN, nodes[when].name
            )
        inside = [node for node in nodes if node.control >= 0 and self._is_of(node.control, asking)]
        if not inside:
            return None
        line = str(self._history.program.written_line(inside[0].line))
        return Meaning(QuestionKind.NOT_LINE if self.is_negative else QuestionKind.LINE, line)

    @staticmethod
    def _senses(node: Node, sense: Concept) -> bool:
        block = wording.blocks().get(node.name) if node.base == "robot" else None
        return block is not None and any(need.startswith(_SENSES[sense]) for need in block.needs)

    def _is_of(self, control: int, asking: list[int]) -> bool:
        last = self._history.nodes[control].last
        calls = [number for number in asking if control < number <= last]
        return any(
            self._history.nodes[call].line == self._history.nodes[control].line for call in calls
        )

    def _emotion(self) -> Meaning | None:
        emotion = next((word for word in self.concepts if word in EMOTIONS), None)
        if emotion is None:
            return None
        skill = f"express{emotion.value.capitalize()}"
        if self.is_negative:
            return Meaning(QuestionKind.NOT_SKILL, skill)
        is_used = skill in self.skills() and not self._has(Concept.SHOW)
        return (
            Meaning(QuestionKind.SKILL, skill)
            if is_used
            else Meaning(QuestionKind.EMOTION, emotion.value)
        )

    def _device(self) -> Meaning | None:
        for device, pattern in self._devices():
            skill = next((name for name in self.skills() if re.match(pattern, name)), None)
            if skill is None and self.is_negative and device in _ONLY_DEVICES:
                # The program has none: the answer says so.
                skill = next((name for name in wording.blocks() if re.match(pattern, name)), None)
            if skill:
                return Meaning(
                    QuestionKind.NOT_SKILL if self.is_negative else QuestionKind.SKILL, skill
                )
        return None

    def _devices(self) -> list[tuple[Concept, str]]:
        """The devices that the words name; a face to drive to or look for does not count."""
        moves = self._has(*_MOTIONS, Concept.SEARCH, Concept.SEE, Concept.LEAVE, Concept.FOLLOW)
        return [
            (device, p)
            for device, p in _DEVICES
            if device in self._known and not (device is Concept.FACE and moves)
        ]

    def _line_lost(self) -> Meaning | None:
        is_lost = self._has(Concept.LEAVE) or (self.is_negative and self._has(Concept.FOLLOW))
        is_about_line = self._has(Concept.TRACK) or (self._has(Concept.FOLLOW) and is_lost)
        return Meaning(QuestionKind.LOST) if is_about_line and is_lost else None

    def _speed(self) -> Meaning | None:
        if self._has(Concept.SLOW):
            return Meaning(QuestionKind.SPEED, "fast" if self.is_negative else "slow")
        if self._has(Concept.FAST):
            return Meaning(QuestionKind.SPEED, "slow" if self.is_negative else "fast")
        return None

    def _avoid(self) -> Meaning | None:
        if not self._has(Concept.AVOID):
            return None
        name = self._direction()
        return Meaning(
            QuestionKind.NOT_MOVEMENT if self.is_negative else QuestionKind.MOVEMENT, name or ""
        )

    def _long(self) -> Meaning | None:
        name = self._movement()
        if not self._has(Concept.LONG) or name is None or self.is_negative:
            return None
        return Meaning(QuestionKind.LONG, name)

    def _end(self) -> Meaning | None:
        is_program = self._has(Concept.PROGRAM)
        is_end = self._has(Concept.END) or (is_program and self._has(Concept.STOP))
        if is_end and self.is_negative:
            return Meaning(QuestionKind.NOT_END)
        if is_program and self._has(Concept.KEEP):
            return Meaning(QuestionKind.NOT_END)
        return Meaning(QuestionKind.END) if is_end else None

    def _stop(self) -> Meaning | None:
        if not self._has(Concept.STOP) or self._has(Concept.TURN, Concept.BACK, Concept.FORWARD):
            return None
        return Meaning(
            QuestionKind.NOT_MOVEMENT if self.is_negative else QuestionKind.MOVEMENT, wording.STAND
        )

    def _motion(self) -> Meaning | None:
        name = self._movement()
        if name is None or self._has(*_ONLY_DEVICES):
            # It was the lamp that turned red.
            return None
        if name == wording.FORWARD and self.is_negative and not self._has(Concept.FORWARD):
            return self._not_moving()
        is_missing = self.is_negative or Concept.AGAIN in self._known
        return Meaning(QuestionKind.NOT_MOVEMENT if is_missing else QuestionKind.MOVEMENT, name)

    def _not_moving(self) -> Meaning:
        """It did not move: the robot stands still, or it does something else."""
        moves = any("pose" in line for line in self._history.recorded.lines[1:])
        is_driven = any(
            node.name in ("move_straight", "drive_distance") for node in self._history.nodes
        )
        if moves and is_driven and self._known <= {Concept.MOVE, Concept.NOT, Concept.KEEP}:
            return Meaning(QuestionKind.NOT_MOVEMENT, wording.FORWARD)
        return Meaning(QuestionKind.MOVEMENT, wording.STAND)

    def _movement(self) -> str | None:
        """The movement that the words name; None if they name none."""
        if (direction := self._direction()) is not None:
            return direction
        if self._has(Concept.BACK):
            return wording.BACK
        if self._has(Concept.FORWARD, Concept.MOVE, Concept.SEARCH) and self._has(*_MOTIONS):
            return wording.FORWARD
        return None

    def _direction(self) -> str | None:
        """A turn; None if the words name none."""
        sides = [word for word in self.concepts if word in (Concept.LEFT, Concept.RIGHT)]
        is_curve = self._has(Concept.CURVE)
        if not sides:
            return "" if self._has(Concept.TURN) or is_curve else None
        if not self._has(Concept.TURN, Concept.CURVE, Concept.MOVE) and self._has(Concept.WALL):
            # The word belongs to a sensor on that side.
            return None
        return f"{'curve' if is_curve else 'spin'}-{sides[0].value}"

    def _goal(self) -> Meaning | None:
        return Meaning(QuestionKind.GOAL) if self._has(Concept.GOAL) else None

    def skills(self) -> Iterable[str]:
        """The skills that the program uses, in the order of its lines."""
        nodes = self._history.nodes
        calls = (node.name for node in nodes if node.kind is Kind.CALL and node.base == "robot")
        return dict.fromkeys(calls)
