"""What changed the score and the lives of a game, and what ended it."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

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
        own = self._ended(until, time) if what == "end" else self._changed(what, until, time)
        return _SKILLS[what] if own else ()

    def _changed(self, name: str, until: int, time: float | None) -> bool:
        own = False
        for line in [*reversed([*self._lines(until, time, name)])][:_MOST]:
            thing = line.get("thing")
            own |= thing is None
            self._say(_CODES[name, thing is None], line, thing=str(thing), value=line[name])
        return own

    def _ended(self, until: int, time: float | None) -> bool:
        for line in self._lines(until, time, "thing"):
            if line["game"] in ("won", "lost"):
                self._say("why-game-ended", line, end=line["game"], reason=str(line["thing"]))
                return str(line["thing"]) == "program"
        return False

    def _lines(self, until: int, time: float | None, key: str) -> Iterator[Line]:
        last = self._history.time(until) if time is None else time
        for line in self._history.recorded.lines:
            if "game" in line and key in line and line["t"] <= last + _ABOUT:
                yield line

    def _say(self, code: str, line: Line, **values: Any) -> None:
        event = max(0, self._history.at(line["t"]))
        name = f"{values.get('thing', '')} {line['t']}"
        self._draft.say_of_line(code, 0, event, name=name, time=round(line["t"], 2), **values)
