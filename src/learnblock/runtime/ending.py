"""How a run ends."""

from dataclasses import dataclass
from enum import StrEnum

from learnblock.i18n import Phrase


class How(StrEnum):
    """How a run ended."""

    FINISHED = "finished"
    ERROR = "error"
    TIME_LIMIT = "time limit"
    STOPPED = "stopped"
    NO_CALL = "no call"
    OUTPUT_LIMIT = "output limit"
    KILLED = "killed"


@dataclass(frozen=True, slots=True)
class Ending:
    """How a run ended.

    Args:
        how: the kind of ending.
        phrase: the message for a person.
        line: the line of the program's Python, from 1; 0 if unknown.
        file: the file in the user's folder where it happened; "" if it was in none.
        file_line: the line of that file, from 1.
    """

    how: How
    phrase: Phrase
    line: int = 0
    file: str = ""
    file_line: int = 0

    @property
    def well(self) -> bool:
        """Whether nothing went wrong."""
        return self.how in {How.FINISHED, How.TIME_LIMIT, How.STOPPED}

    @classmethod
    def of_game(cls) -> "Ending":
        """The end of a run whose game has ended."""
        return cls(How.FINISHED, Phrase("run-finished"))

    @classmethod
    def time_is_up(cls, seconds: float) -> "Ending":
        """The end of a run after its time limit, in seconds of the robot's time."""
        return cls(How.TIME_LIMIT, Phrase("run-time-limit", seconds=seconds))
