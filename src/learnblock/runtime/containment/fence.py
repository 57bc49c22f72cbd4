"""The fence that a child puts around itself before it runs a program."""

import os
import signal
import sys
from importlib import import_module
from itertools import chain
from pathlib import Path

import msgspec

from learnblock.errors import LearnBlockError
from learnblock.runtime.containment import hook, resources
from learnblock.runtime.limits import Limits
from learnblock.runtime.messages import Setup


def prepare() -> None:
    """Load what `contain` needs, before there is a program."""
    if sys.platform == "linux":
        # These modules take time to load, and only Linux needs them.
        for name in ("beside", "kernel", "landlock", "paths", "seccomp"):
            import_module(f"learnblock.runtime.containment.{name}")


# Why: docs/decisions.md, "A pupil's program is contained by the kernel, from within"
def contain(setup: Setup) -> None:
    """Contain this process permanently.

    Raises:
        LearnBlockError: the system refused something that it claims to support.
    """
    try:
        _contain(setup)
    except OSError as error:
        raise LearnBlockError("run-not-contained", reason=str(error)) from error


def contain_host(limits: Limits, world: str | None) -> None:
    """Contain this process permanently; it runs a robot's host together with a program.

    It may read what hosts of simulated robots need, and write nothing.

    Args:
        limits: the resources that the program may use, besides what this process already uses.
        world: the name or the path of its world.

    Raises:
        LearnBlockError: the system refused something that it claims to support.
    """
    try:
        _contain_host(limits, world)
    except OSError as error:
        raise LearnBlockError("run-not-contained", reason=str(error)) from error


def contain_server(folder: Path, *read: Path) -> None:
    """Contain this process permanently; it serves one pupil of a class, and starts programs.

    It may use the network, because the classroom reaches it there; its programs may not.

    Args:
        folder: the pupil's folder, the only one that it may write to.
        read: more folders that it may read.

    Raises:
        LearnBlockError: the system refused something that it claims to support.
    """
    if sys.platform != "linux":
        return
    # These modules take time to load, and only Linux needs them.
    from learnblock.runtime.containment import landlock, paths  # noqa: PLC0415

    try:
        more = ((str(path), landlock.READ) for path in read)
        landlock.restrict(chain(paths.allowed_to_server(folder), more), network=True)
    except OSError as error:
        raise LearnBlockError("run-not-contained", reason=str(error)) from error


def _contain_host(limits: Limits, world: str | None) -> None:
    # These modules take time to load, and only Linux needs them.
    from learnblock.runtime.containment import kernel, landlock, paths  # noqa: PLC0415

    _let_go_of_terminal()
    kernel.die_with_parent(signal.SIGKILL)
    landlock.restrict(paths.allowed_to_host(world), network=False)
    memory = limits.memory + resources.address_space()
    resources.limit(msgspec.structs.replace(limits, memory=memory))
    _contain_calls(network=False)
    hook.install(network=False)


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
    from learnblock.runtime.containment import beside, kernel, landlock, paths  # noqa: PLC0415

    kernel.die_with_parent(signal.SIGKILL)
    folder = Path(setup.folder).resolve()
    if setup.folder and paths.is_shared(folder):
        beside.make_importable(setup.folder, beside.files_beside(folder))
    allowed = paths.allowed(setup.folder, network=setup.network)
    landlock.restrict(allowed, network=setup.network)


def _contain_calls(*, network: bool) -> None:
    from learnblock.runtime.containment import seccomp  # noqa: PLC0415 - as above

    seccomp.restrict(network=network)
