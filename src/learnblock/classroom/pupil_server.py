"""A pupil's own server: a LearnBlock with the pupil's folder, which only the classroom can reach.

It runs in a process of its own, and may read and write the pupil's folder only.
"""

import os
import resource
import signal
from collections.abc import Callable
from pathlib import Path
from urllib.parse import urlsplit

import msgspec

from learnblock.blocks import block_sets
from learnblock.blocks.block_sets import EVERYTHING, BuiltIn
from learnblock.classroom import limits
from learnblock.classroom.memory import watch_programs
from learnblock.classroom.pupil_folder import HOME, PROJECTS, TEMPORARY
from learnblock.lessons.reading import shipped_folder
from learnblock.project.files.writer import Access, FolderClaim
from learnblock.running.examples import examples_folder
from learnblock.runtime.containment import kernel
from learnblock.runtime.containment.fence import contain_server
from learnblock.server import serve
from learnblock.server.http.address import VARIABLE
from learnblock.server.last_resort import Deadlines
from learnblock.storage import quota

#: So that a class is closed within 10 s of Ctrl-C, even if a program hangs.
_DEADLINES = Deadlines(ending=5.0, saving=3.0)
#: A pupil's server gives way to the classroom, which everybody waits for.
_NICENESS = 5


class Order(msgspec.Struct, frozen=True):
    """A server to start.

    Args:
        pupil: the id of the pupil.
        folder: the pupil's folder.
        base_url: the path of the pupil's page.
        token: with which the classroom comes in.
        blocks: the block set with which the pupil's own projects begin.
    """

    pupil: str
    folder: str
    base_url: str
    token: str
    blocks: BuiltIn = EVERYTHING


# Why: docs/decisions.md, "Each pupil has a process"
def run(order: Order, started: Callable[[int], object]) -> None:
    """Serve until SIGTERM, or until the process that has started this one ends.

    Args:
        order: the server.
        started: called with its port once it answers.
    """
    folder = Path(order.folder)
    for name in (HOME, PROJECTS, TEMPORARY):
        (folder / name).mkdir(parents=True, exist_ok=True)
    os.environ |= {
        "LEARNBLOCK_HOME": str(folder / HOME),
        "LEARNBLOCK_ROBOTS": "simulated",
        "TMPDIR": str(folder / TEMPORARY),
        block_sets.VARIABLE: order.blocks,
        quota.VARIABLE: quota.setting(limits.DISK, folder),
        VARIABLE: order.token,
    }
    kernel.die_with_parent(signal.SIGTERM)
    os.nice(_NICENESS)
    _limit()
    contain_server(folder, examples_folder(), shipped_folder())
    watch_programs(limits.PROGRAMS_MEMORY)
    with FolderClaim(folder / PROJECTS) as writer:
        # The classroom has waited for the last server of this folder.
        writer.claim(patience=10.0)
        service = serve.Service(
            folder / PROJECTS,
            port=0,
            base_url=order.base_url,
            access=Access(writer),
            for_one=True,
            deadlines=_DEADLINES,
            announce=lambda _: None,
        )
        serve.serve(service, show=lambda address: started(_port(address)))


def _limit() -> None:
    resource.setrlimit(resource.RLIMIT_DATA, (limits.SERVER_MEMORY, limits.SERVER_MEMORY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (limits.LARGEST_FILE, limits.LARGEST_FILE))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def _port(address: str) -> int:
    return urlsplit(address).port or 0
