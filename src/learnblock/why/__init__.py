"""What a run did, and why: its log read again, for questions about any moment of it.

    >>> from learnblock import why
    >>> history = why.History(why.read("square.why"))  # doctest: +SKIP

`learnblock.runtime.log` writes logs, for the page and for ``learnblock run --why FILE``.
"""

from learnblock.why.history import CalledSkill, EventHistory, Frame
from learnblock.why.recorded import Recorded, read

__all__ = ["CalledSkill", "EventHistory", "Frame", "Recorded", "read"]
