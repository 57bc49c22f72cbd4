"""The fence that a child puts around itself before it runs a program."""

import os
import signal
import sys

from learnblock.errors import LearnBlockError
from learnblock.runtime.containment import hook, resources
from learnblock.runtime.messages import Setup


def contain(setup: Setup) -> None:
    """Contain this process permanently.

    Raises:
        LearnBlockError: the system refused something that it claims to support.
    """
    try:
        _contain(setup)
    except OSError as error:
        raise LearnBlockError("run-not-contained", reason=str(error)) from error


def _contain(setup: Setup) -> None:
    _let_go_of_terminal()
    if not setup.folder:
        # A program from the page has no files except those that it creates.
        os.chdir(os.environ["TMPDIR"])
    if sys.platform == "linux":
        _contain_files(setup)
    # This comes first, because system calls that change limits are refused afterwards.
    resources.limit(setup.limits)
    if sys.platform == "linux":
        _contain_calls(network=setup.network)
    hook.install(network=setup.network)


def _let_go_of_terminal() -> None:
    """Close the host's error output, which may be a terminal in which the user types."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 2)
    os.close(nowhere)


def _contain_files(setup: Setup) -> None:
    # These modules take time to load, and only Linux needs them.
    from learnblock.runtime.containment import kernel, landlock, paths  # noqa: PLC0415

    kernel.die_with_parent(signal.SIGKILL)
    allowed = paths.allowed(setup.folder, network=setup.network)
    landlock.restrict(allowed, network=setup.network)


def _contain_calls(*, network: bool) -> None:
    from learnblock.runtime.containment import seccomp  # noqa: PLC0415 - as above

    seccomp.restrict(network=network)
