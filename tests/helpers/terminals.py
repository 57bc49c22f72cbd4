"""Commands that run on a terminal."""

import os
import subprocess


def shown_on_a_terminal(command) -> str:
    """Run a command on a pseudo-terminal until it succeeds; return all that it has shown."""
    ours, theirs = os.openpty()
    process = subprocess.Popen(command, stdout=theirs, stderr=theirs)
    os.close(theirs)
    output = bytearray()
    try:
        while data := os.read(ours, 4096):
            output += data
    except OSError:
        # Linux reports in this way that the other end of a terminal is closed.
        pass
    os.close(ours)
    assert process.wait() == 0
    return output.decode()
