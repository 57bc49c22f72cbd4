"""How a run ends."""

from dataclasses import dataclass
from enum import StrEnum


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
        how: in one word or two.
        sentence: the same in a sentence.
        line: of the program's Python, from 1; 0 where it is not known.
        file: of the user's own folder in which that was; "" where it was not in one.
        file_line: of that file, from 1.
    """

    how: How
    sentence: str
    line: int = 0
    file: str = ""
    file_line: int = 0

    @property
    def well(self) -> bool:
        """Whether nothing went wrong."""
        return self.how in {How.FINISHED, How.TIME_LIMIT, How.STOPPED}

    @classmethod
    def time_is_up(cls, seconds: float) -> "Ending":
        """The end of a run that was to last so long, in seconds of the robot's time."""
        return cls(How.TIME_LIMIT, f"the time limit of {seconds:g} s is up")
