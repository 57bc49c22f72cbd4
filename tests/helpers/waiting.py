"""Wait in tests for a condition rather than for a time."""

import time

#: The limit of a wait. It is long, because it costs time only where something fails, and a little
#: shorter than that of a test, so that a failure says what it waited for.
SECONDS = 50


def wait_for(condition, what, seconds=SECONDS):
    """Wait until the condition is true."""
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, f"in vain: {what}"
        # Leaves the processor to what the test waits for.
        time.sleep(0.002)
