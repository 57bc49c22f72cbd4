"""A process is ended together with everything it has started."""

import subprocess
import sys

import pytest

from learnblock.runtime import process_group

WAITS = "print('ready', flush=True); import threading; threading.Event().wait()"
STARTS = f"import subprocess, sys; subprocess.run([sys.executable, '-c', {WAITS!r}])"


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no process groups")
def test_a_process_ends_with_what_it_has_started():
    with subprocess.Popen(
        [sys.executable, "-c", STARTS], stdout=subprocess.PIPE, start_new_session=True
    ) as process:
        assert process.stdout.readline() == b"ready\n"
        process_group.kill(process)
        # The output ends when the last process that can write to it has ended.
        assert process.stdout.read() == b""
    assert process.returncode != 0


def test_killing_a_process_that_has_ended_changes_nothing():
    process = subprocess.Popen([sys.executable, "-c", ""], start_new_session=True)
    assert process.wait() == 0

    process_group.kill(process)

    assert process.returncode == 0
