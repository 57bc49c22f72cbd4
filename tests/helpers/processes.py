"""Whether a process that a test did not start itself still runs."""

from pathlib import Path

from waiting import wait_for


def runs(pid):
    """Whether a process is running, and not a zombie."""
    try:
        status = Path(f"/proc/{pid}/stat").read_text()
    except (FileNotFoundError, ProcessLookupError):
        return False
    # The state follows the name in brackets.
    return status.rpartition(")")[2].split()[0] != "Z"


def wait_until_gone(pid, name="its guardian"):
    """Wait until a process has ended."""
    wait_for(lambda: not runs(pid), f"{name} ends")
