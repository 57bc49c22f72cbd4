"""The output of programs for the page."""

import threading

#: The maximum number of characters sent at once and kept for a page that opens later.
MOST_AT_ONCE = 20_000
MOST_KEPT = 100_000


class Console:
    """Collects the output in the thread of the program, and hands it out in portions."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._new: list[str] = []
        self._kept = ""

    @property
    def kept(self) -> str:
        """The end of the output returned so far."""
        return self._kept

    def printed(self, text: str) -> None:
        """Add output of the program; may be called from any thread."""
        with self._lock:
            self._new.append(text)

    def take(self) -> str:
        """The output since the last call, or only its end if there is too much."""
        with self._lock:
            new, self._new = "".join(self._new), []
        shown = _shortened(new)
        self._kept = (self._kept + shown)[-MOST_KEPT:]
        return shown

    def clear(self) -> None:
        """Forget all output, as at the beginning of a run."""
        with self._lock:
            self._new, self._kept = [], ""


def _shortened(text: str) -> str:
    left_out = len(text) - MOST_AT_ONCE
    if left_out <= 0:
        return text
    return f"[{left_out} characters left out]\n{text[left_out:]}"
