"""What changed the score and the lives of a game, and what ended it."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from learnblock.i18n.names import goal_phrase
from learnblock.why.history import EventHistory
from learnblock.why.sentences import Draft

#: The most changes that an answer names, the last one first.
_MOST = 4
#: Seconds by which a thing may happen after the moment that is asked about.
_ABOUT = 0.05
#: The skills with which a program changes what counts, and ends the game.
_SKILLS: Mapping[str, Sequence[str]] = {
    "score": ("change_score", "set_score"),
    "lives": ("change_lives", "set_lives"),
    "end": ("win_game", "game_over"),
}

#: What tells a change, by the program or not.
_CODES = {
    ("score", True): "why-score-changed",
    ("score", False): "why-score-changed-by",
    ("lives", True): "why-lives-changed",
    ("lives", False): "why-lives-changed-by",
}

Line = Mapping[str, Any]


class GameFacts:
    """Tells what happened in a game.

    Args:
        history: of the run.
        draft: the answer.
    """

    def __init__(self, history: EventHistory, draft: Draft) -> None:
        self._history = history
        self._draft = draft

    def tell(self, what: str, until: int, time: float | None) -> Sequence[str]:
        """Tell what changed ``score`` or ``lives``, or what was the ``end``.

        Returns:
            the skills with which the program did it; none if it did not.
        """
        last = self._last(until, time)
        own = self._ended(last) if what == "end" else self._changed(what, last)
        return _SKILLS[what] if own else ()

    def _changed(self, name: str, last: float) -> bool:
        own = False
        for line in [*reversed([*self._lines(last, name)])][:_MOST]:
            thing = line.get("thing")
            own |= thing is None
            self._say(_CODES[name, thing is None], line, thing=str(thing), value=line[name])
        return own

    def tell_end(self) -> bool:
        """Tell what ended the game, if that ended the program, too; return whether it did."""
        ended = float(self._history.recorded.ending.get("time", 0.0))
        if self._end_line(ended) is None:
            return False
        self._ended(ended)
        return True

    def tell_winner(self, until: int, time: float | None) -> None:
        """Tell who has won the game with a goal, if that has happened."""
        line = self._end_line(self._last(until, time))
        if line and "winner" in line:
            self._tell_winner(line)

    def _ended(self, last: float) -> bool:
        line = self._end_line(last)
        if line is None:
            return False
        if "winner" in line:
            self._tell_winner(line)
            return False
        reason = goal_phrase(str(line["thing"]))
        self._say("why-game-ended", line, end=line["game"], reason=reason)
        return str(line["thing"]) == "program"

    def _end_line(self, last: float) -> Line | None:
        lines = self._lines(last, "thing")
        return next((line for line in lines if line["game"] in ("won", "lost")), None)

    def _tell_winner(self, line: Line) -> None:
        goal, robot = goal_phrase(str(line["thing"])), str(line["winner"])
        if "winning_team" in line:
            team = goal_phrase(str(line["winning_team"]))
            self._say("why-team-won", line, team=team, robot=robot, goal=goal)
        else:
            self._say("why-robot-won", line, robot=robot, goal=goal)

    def _last(self, until: int, time: float | None) -> float:
        """The moment in question, in s; the last event may be long before the end of the run."""
        if time is not None:
            return time
        history = self._history
        return history.end if until >= len(history.events) - 1 else history.time(until)

    def _lines(self, last: float, key: str) -> Iterator[Line]:
        for line in self._history.recorded.lines:
            if "game" in line and key in line and line["t"] <= last + _ABOUT:
                yield line

    def _say(self, code: str, line: Line, **values: Any) -> None:
        event = max(0, self._history.at(line["t"]))
        name = f"{values.get('thing', '')} {line['t']}"
        self._draft.say_of_line(code, 0, event, name=name, time=round(line["t"], 2), **values)
