"""What programs print, on its way to the page."""

import threading

#: Characters; of what is printed within one moment no more is sent, and no more is kept for a page
#: that comes later.
MOST_AT_ONCE = 20_000
MOST_KEPT = 100_000


class Console:
    """Gathers prints in the thread that runs the program, and hands them out in portions."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._new: list[str] = []
        self._kept = ""

    @property
    def kept(self) -> str:
        """The last of all that was handed out."""
        return self._kept

    def printed(self, text: str) -> None:
        """Add what the program printed; from any thread."""
        with self._lock:
            self._new.append(text)

    def take(self) -> str:
        """What was printed since this was last asked, or its end where that is very much."""
        with self._lock:
            new, self._new = "".join(self._new), []
        shown = _shortened(new)
        self._kept = (self._kept + shown)[-MOST_KEPT:]
        return shown

    def clear(self) -> None:
        """A new run begins with an empty page."""
        with self._lock:
            self._new, self._kept = [], ""


def _shortened(text: str) -> str:
    left_out = len(text) - MOST_AT_ONCE
    if left_out <= 0:
        return text
    return f"[{left_out} characters left out]\n{text[left_out:]}"
