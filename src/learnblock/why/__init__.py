"""What a run did, and why: its log read again, for questions about any moment of it.

    >>> from learnblock import why
    >>> history = why.History(why.read("square.why"))  # doctest: +SKIP

A log is made by `learnblock.runtime.log`, which the page and ``learnblock run --why FILE`` do.
"""

from learnblock.why.history import Frame, History, SkillUse
from learnblock.why.recorded import Recorded, read

__all__ = ["Frame", "History", "Recorded", "SkillUse", "read"]
