"""What can be asked about a run."""

from collections.abc import Container, Iterable, Iterator
from dataclasses import dataclass, field, replace
from enum import StrEnum

from learnblock.i18n import Phrase, Value
from learnblock.i18n.names import goal_phrase
from learnblock.runtime.log.nodes import Kind, Node
from learnblock.why.history import CalledSkill, EventHistory
from learnblock.why.slices import movements
from learnblock.why.steering import movement_of, written_values
from learnblock.why.wording import (
    MOVEMENTS,
    STAND,
    blocks,
    movement,
    movement_phrase,
    skill_phrase,
    thing_phrase,
)

#: Skills without a visible or audible effect.
_UNSEEN = frozenset({"run", "activate", "deactivate", "Robot", "wait_until", "when", "when_start"})
#: A line that ran longer ago than this many seconds could have run again.
_LONG_AGO = 1.0


class QuestionKind(StrEnum):
    """The kinds of questions."""

    #: Why did the robot move this way? The subject is a movement.
    MOVEMENT = "movement"
    NOT_MOVEMENT = "not-movement"
    #: Why was a skill used? The subject is its name.
    SKILL = "skill"
    NOT_SKILL = "not-skill"
    #: Why did a line print? The subject is its number, or a part of its text.
    PRINT = "print"
    NOT_PRINT = "not-print"
    #: Why was a text printed? The subject is the text as it was printed.
    PRINTED = "printed"
    #: Why was a `when` active?
    WHEN = "when"
    NOT_WHEN = "not-when"
    LINE = "line"
    NOT_LINE = "not-line"
    #: Why does a variable have its value?
    VALUE = "value"
    #: Why was a goal not reached?
    GOAL = "goal"
    #: Why was a goal reached?
    REACHED = "reached"
    #: Why did the robot show an emotion? The subject is its name, such as ``joy``.
    EMOTION = "emotion"
    #: Why did the program end?
    END = "end"
    #: Why did it not?
    NOT_END = "not-end"
    #: Why did nothing happen?
    NOTHING = "nothing"
    #: Why did the robot continue a movement for so long? The subject is the movement.
    LONG = "long"
    #: Why is the robot so slow or fast? The subject is ``slow`` or ``fast``.
    SPEED = "speed"
    #: Why did the robot leave the line?
    LOST = "lost"
    #: Why did the robot fall?
    FALL = "fall"
    #: Why did the robot bump into something?
    BUMP = "bump"
    #: Why is the score what it is? The subject is the score.
    SCORE = "score"
    #: Why did the lives change?
    LIVES = "lives"
    #: Why did the game end? The subject is ``won`` or ``lost``.
    GAME = "game"
    #: What was going on?
    NOW = "now"


_CODES = {
    QuestionKind.MOVEMENT: "why-ask-movement",
    QuestionKind.NOT_MOVEMENT: "why-ask-not-movement",
    QuestionKind.SKILL: "why-ask-skill",
    QuestionKind.NOT_SKILL: "why-ask-not-skill",
    QuestionKind.PRINT: "why-ask-print",
    QuestionKind.NOT_PRINT: "why-ask-not-print",
    QuestionKind.PRINTED: "why-ask-printed",
    QuestionKind.WHEN: "why-ask-when",
    QuestionKind.NOT_WHEN: "why-ask-not-when",
    QuestionKind.LINE: "why-ask-line",
    QuestionKind.NOT_LINE: "why-ask-not-line",
    QuestionKind.VALUE: "why-ask-value",
    QuestionKind.GOAL: "why-ask-goal",
    QuestionKind.REACHED: "why-ask-reached",
    QuestionKind.EMOTION: "why-ask-emotion",
    QuestionKind.END: "why-ask-end",
    QuestionKind.NOT_END: "why-ask-not-end",
    QuestionKind.NOTHING: "why-ask-nothing",
    QuestionKind.LONG: "why-ask-long",
    QuestionKind.SPEED: "why-ask-speed",
    QuestionKind.LOST: "why-ask-lost",
    QuestionKind.FALL: "why-ask-fall",
    QuestionKind.BUMP: "why-ask-bump",
    QuestionKind.SCORE: "why-ask-score",
    QuestionKind.LIVES: "why-ask-lives",
    QuestionKind.GAME: "why-ask-game",
    QuestionKind.NOW: "why-ask-now",
}


#: Those that need no subject.
_CODES_OF_ANY = {
    QuestionKind.PRINT: "why-ask-print-any",
    QuestionKind.NOT_PRINT: "why-ask-not-print-any",
    QuestionKind.GOAL: "why-ask-goal-any",
    QuestionKind.REACHED: "why-ask-reached-any",
    QuestionKind.BUMP: "why-ask-bump-any",
}
#: Those with a subject that may be a text instead of a line.
_CODES_OF_TEXT = {
    QuestionKind.PRINT: "why-ask-print-text",
    QuestionKind.NOT_PRINT: "why-ask-not-print-text",
}


@dataclass(frozen=True, slots=True)
class Question:
    """A question about a run.

    Args:
        ask: its kind.
        subject: what it is about: a movement, a skill, a name, a line's number, a text.
        time: the moment, in s, or the end of the time in question; None for the whole run.
        since: the start of the time in question, in s; None for a moment or the whole run.
    """

    ask: QuestionKind
    subject: str = ""
    time: float | None = None
    since: float | None = None
    #: The skill with the values of its call; "" for a skill without them, and for others.
    skill: Value = field(default="", compare=False)

    @property
    def phrase(self) -> Phrase:
        """The question in words."""
        return Phrase(self._code(), subject=self._subject(), time=self._when())

    def _when(self) -> Value:
        if self.since is not None and self.time is not None:
            return Phrase("why-between", since=round(self.since, 2), time=round(self.time, 2))
        if self.since is not None:
            return Phrase("why-since", time=round(self.since, 2))
        return "" if self.time is None else Phrase("why-at", time=round(self.time, 2))

    def _code(self) -> str:
        if not self.subject:
            return _CODES_OF_ANY.get(self.ask, _CODES[self.ask])
        if not self.subject.isdigit():
            return _CODES_OF_TEXT.get(self.ask, _CODES[self.ask])
        return _CODES[self.ask]

    def _subject(self) -> Value:
        if (
            self.ask in (QuestionKind.MOVEMENT, QuestionKind.NOT_MOVEMENT, QuestionKind.LONG)
            and self.subject in MOVEMENTS
        ):
            return movement_phrase(self.subject)
        if self.ask in (QuestionKind.SKILL, QuestionKind.NOT_SKILL):
            return self.skill or skill_phrase(self.subject)
        if self.ask is QuestionKind.BUMP:
            return thing_phrase(self.subject)
        if self.ask in (QuestionKind.GOAL, QuestionKind.REACHED):
            return goal_phrase(self.subject)
        if self.ask is QuestionKind.EMOTION:
            return Phrase("why-emotion", emotion=self.subject)
        return self.subject


def questions(history: EventHistory) -> tuple[Question, ...]:
    """What can be asked about a run, in the order of the page: what happened, what did not."""
    choices = [
        *_movements(history),
        *_skills(history),
        *_whens(history),
        *_prints(history),
        *_values(history),
        *_bumps(history),
        *_emotions(history),
        *_goals(history),
        *_games(history),
        *_lines(history),
        *_endings(history),
    ]
    return tuple(dict.fromkeys(choices))


def questions_about_moment(history: EventHistory, time: float) -> tuple[Question, ...]:
    """What can be asked about the robot at a time in s: what it was doing, and what it was not."""
    time = round(min(time, history.end), 2)
    commands = [index for index in movements(history) if history.time(index) <= time]
    moving = movement(*history.arguments(commands[-1])[:2]) if commands else _at_first(history)
    choices = [Question(QuestionKind.NOW, "", time)]
    if moving:
        choices.append(Question(QuestionKind.MOVEMENT, moving, time))
    choices += [
        Question(QuestionKind.NOT_MOVEMENT, name, time)
        for name in _possible(history)
        if name != moving
    ]
    steering = _steering_skills(history)
    choices += [
        replace(question, time=time)
        for question in _skills(history)
        if question.ask is QuestionKind.NOT_SKILL and question.subject not in steering
    ]
    choices += [Question(question.ask, question.subject, time) for question in _whens(history)]
    return tuple(dict.fromkeys(choices))


def with_values(history: EventHistory, question: Question) -> Question:
    """A question that names its skill with the values of its call."""
    for candidate in _skills(history):
        if (candidate.ask, candidate.subject) == (question.ask, question.subject):
            return replace(question, skill=candidate.skill)
    return question


def _at_first(history: EventHistory) -> str:
    """The movement before the first command; without wheels there is none to ask about."""
    return STAND if any(_possible(history)) else ""


def askable(history: EventHistory) -> Iterator[Question]:
    """All questions for a list, without times, except those about printed texts."""
    yield from (replace(question, time=None) for question in questions(history))
    subjects: dict[tuple[QuestionKind, QuestionKind], Iterable[str]] = {
        (QuestionKind.MOVEMENT, QuestionKind.NOT_MOVEMENT): MOVEMENTS,
        (QuestionKind.SKILL, QuestionKind.NOT_SKILL): _calls(history),
        (QuestionKind.WHEN, QuestionKind.NOT_WHEN): (
            node.name for node in history.nodes if node.is_when
        ),
        (QuestionKind.PRINT, QuestionKind.NOT_PRINT): (
            question.subject for question in _prints(history)
        ),
        (QuestionKind.LINE, QuestionKind.NOT_LINE): map(str, _runs_of_lines(history)),
    }
    for (why, why_not), group in subjects.items():
        for subject in group:
            yield Question(why, subject)
            yield Question(why_not, subject)
    yield from (Question(ask) for ask in (*_CODES_OF_ANY, QuestionKind.NOW))


def _possible(history: EventHistory) -> Iterable[str]:
    """The movements that the program could make, in the order of its lines."""
    names = [movement_of(node) for node in history.nodes if node.base == "robot"]
    return dict.fromkeys(name for name in names if name)


def _steering_skills(history: EventHistory) -> frozenset[str]:
    return frozenset(node.name for node in history.nodes if movement_of(node))


def questions_about_lines(
    history: EventHistory, lines: Container[str], time: float | None
) -> tuple[Question, ...]:
    """What can be asked about some lines at a time in s: why they ran last, or why they did not.

    Args:
        history: of the run.
        lines: the author's, as texts.
        time: in s; None for the whole run.
    """
    until = history.end if time is None else min(time, history.end)
    choices: list[Question] = []
    for line, ran in _runs_of_lines(history).items():
        if str(line) not in lines:
            continue
        before = [time_ran for time_ran in map(history.time, ran) if time_ran <= until]
        if before:
            choices.append(Question(QuestionKind.LINE, str(line), max(before)))
        if not before or max(before) < until - _LONG_AGO:
            choices.append(Question(QuestionKind.NOT_LINE, str(line), round(until, 2)))
    return tuple(choices)


def _movements(history: EventHistory) -> Iterator[Question]:
    """Each change of the robot's movement."""
    before = ""
    for index in movements(history):
        advance, rotation = history.arguments(index)[:2]
        name = movement(advance, rotation)
        if name != before:
            yield Question(QuestionKind.MOVEMENT, name, history.time(index))
        before = name


def _skills(history: EventHistory) -> Iterator[Question]:
    ran: dict[str, CalledSkill] = {}
    for use in history.own_uses:
        ran.setdefault(use.name, use)
    for name, call in _calls(history).items():
        block = blocks().get(name)
        if block is not None and block.returns_value:
            continue
        call_phrase = skill_phrase(name, written_values(call.text))
        if name in ran:
            phrase, time = skill_phrase(name, ran[name].args), history.time(ran[name].begun)
            yield Question(QuestionKind.SKILL, name, time, skill=phrase)
        yield Question(QuestionKind.NOT_SKILL, name, round(history.end, 2), skill=call_phrase)


def _calls(history: EventHistory) -> dict[str, Node]:
    """The skills that the program uses, each with its first call."""
    first_calls: dict[str, Node] = {}
    for node in history.nodes:
        if node.kind is Kind.CALL and node.base == "robot" and node.name not in _UNSEEN:
            first_calls.setdefault(node.name, node)
    return first_calls


def _whens(history: EventHistory) -> Iterator[Question]:
    for number, node in enumerate(history.nodes):
        if node.is_when:
            ran = history.of_node.get(number)
            if ran:
                yield Question(QuestionKind.WHEN, node.name, history.time(ran[0]))
            yield Question(QuestionKind.NOT_WHEN, node.name, round(history.end, 2))


def _prints(history: EventHistory) -> Iterator[Question]:
    for number, node in enumerate(history.nodes):
        if node.kind is Kind.CALL and node.name == "print" and not node.base:
            line = str(history.line(number))
            if ran := history.of_node.get(number):
                yield Question(QuestionKind.PRINT, line, history.time(ran[0]))
            else:
                yield Question(QuestionKind.NOT_PRINT, line, round(history.end, 2))


def _values(history: EventHistory) -> Iterator[Question]:
    for name, writes in history.writes.items():
        if writes and name not in ("robot", "_"):
            yield Question(QuestionKind.VALUE, name, history.time(writes[-1]))


def _bumps(history: EventHistory) -> Iterator[Question]:
    for line in history.recorded.lines:
        if "bump" in line:
            yield Question(QuestionKind.BUMP, str(line["bump"]), round(line.get("t", 0.0), 2))


def _emotions(history: EventHistory) -> Iterator[Question]:
    for line in history.recorded.lines:
        if line.get("do") == "show_emotion":
            yield Question(QuestionKind.EMOTION, str(line["args"][0]), round(line.get("t", 0.0), 2))


def _goals(history: EventHistory) -> Iterator[Question]:
    for goal in history.recorded.ending.get("goals") or ():
        is_reached = goal.get("state") == "reached"
        yield Question(
            QuestionKind.REACHED if is_reached else QuestionKind.GOAL, str(goal.get("name"))
        )


def _games(history: EventHistory) -> Iterator[Question]:
    """What can be asked about the game of a run."""
    lines = [line for line in history.recorded.lines if "game" in line]
    if scores := [line for line in lines if "score" in line]:
        last = scores[-1]
        yield Question(QuestionKind.SCORE, f"{last['score']:g}", round(last["t"], 2))
    if lost := [line for line in lines if "lives" in line]:
        yield Question(QuestionKind.LIVES, "", round(lost[-1]["t"], 2))
    if ends := [line for line in lines if line["game"] in ("won", "lost")]:
        yield Question(QuestionKind.GAME, ends[-1]["game"], round(ends[-1]["t"], 2))


def _endings(history: EventHistory) -> Iterator[Question]:
    """Why it ended; for a run in progress or a stopped one, why it did not."""
    ended = history.recorded.ending.get("ended")
    if ended:
        yield Question(QuestionKind.END, "", round(history.end, 2))
    if ended not in ("finished", "error"):
        yield Question(QuestionKind.NOT_END, "", round(history.end, 2))


def _lines(history: EventHistory) -> Iterator[Question]:
    for line, ran in sorted(_runs_of_lines(history).items()):
        if ran:
            yield Question(QuestionKind.LINE, str(line), history.time(min(ran)))
        else:
            yield Question(QuestionKind.NOT_LINE, str(line), round(history.end, 2))


def _runs_of_lines(history: EventHistory) -> dict[int, list[int]]:
    """By line of the author's, the events of its nodes."""
    runs: dict[int, list[int]] = {}
    for number in range(len(history.nodes)):
        line = history.line(number)
        if line:
            runs.setdefault(line, []).extend(history.of_node.get(number, ()))
    return runs
