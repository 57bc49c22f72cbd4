"""Wait in tests for a condition rather than for a time."""

import time

#: The limit of a wait. It is long, because it costs time only where something fails.
SECONDS = 60


def wait_for(condition, what, seconds=SECONDS):
    """Wait until the condition is true."""
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, f"in vain: {what}"
        # Leaves the processor to what the test waits for.
        time.sleep(0.002)
