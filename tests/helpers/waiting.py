"""Wait in tests for a condition rather than for a time."""

import time


def wait_for(condition, what, seconds=5.0):
    """Wait until the condition is true."""
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, f"in vain: {what}"
        time.sleep(0.002)
