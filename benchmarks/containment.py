"""Measure what containing a program costs at its start, and try all attacks on this computer.

Run it with ``python benchmarks/containment.py``. It starts programs with and without the fence in
turn, prints the fastest of each and their ratio, then the table: attack, its result in a process of
its own and in one that is shared with the host (where only programs get that can name nothing of
this), and by what.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path
from time import perf_counter

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from attacks import (
    GROUPS,
    IN_SHARED_FOLDER,
    NOT_CONTAINED,
    Targets,
    prepare,
    try_contained,
    try_shared,
)
from learnblock.runtime.limits import Limits
from learnblock.runtime.messages import Contained, Printed, Setup
from learnblock.runtime.process import ProcessWorker
from learnblock.runtime.standby import Standby

ROUNDS = 25
#: Milliseconds that the fence may add to the start.
AIM = 20.0
#: Runs the child as it is, or without its fence.
WITHOUT = """
import learnblock.runtime.child as child
child.fence.contain = lambda setup: None
child.main()
"""


class Uncontained(Standby):
    """The same child without its fence, in the host's environment."""

    @staticmethod
    def _start(handle: int, variables: object) -> "subprocess.Popen[bytes]":  # noqa: ARG004
        return subprocess.Popen(
            [sys.executable, "-P", "-c", WITHOUT, str(handle)],
            env={**os.environ, "PYTHONHASHSEED": "0"},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            pass_fds=(handle,),
            start_new_session=True,
        )


def start(kind: type[Standby]) -> float:
    """Return the milliseconds from the start of a process to the program's first line."""
    began = perf_counter()
    worker = ProcessWorker(kind())
    try:
        worker.link.send(Setup("print(1)", "start.py", "", (), (), None, Limits()))
        while isinstance(message := worker.link.receive(30), Contained):
            pass
        if not isinstance(message, Printed):
            raise SystemExit(f"expected a print, got {message}")
        return (perf_counter() - began) * 1000
    finally:
        worker.kill()


def cost() -> None:
    """Print the cost of a start with and without the fence."""
    pairs = [(start(Uncontained), start(Standby)) for _ in range(ROUNDS)]
    # The fastest of each: on a busy machine all else measures the others.
    without, contained = (min(column) for column in zip(*pairs, strict=True))
    added = contained - without
    verdict = "met" if added <= AIM else "MISSED"
    print(f"{'start without the fence':28} {without:8.2f} ms")
    print(f"{'start with the fence':28} {contained:8.2f} ms  {contained / without:5.2f} times")
    print(f"{'added':28} {added:8.2f} ms  (aim {AIM:g}: {verdict})")


def result(answer: str) -> str:
    return f"{'GOT IN' if answer == 'IN' else 'refused':8}"


def attacks() -> None:
    """Print what comes of each attack."""
    with tempfile.TemporaryDirectory() as folder:
        os.environ["LEARNBLOCK_HOME"] = str(Path(folder) / "home")
        others, project = prepare(Path(folder))
        with subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE) as victim:
            targets = Targets(others, project, victim.pid)
            for group, members in {**GROUPS, "known": NOT_CONTAINED}.items():
                print(f"\n{group}")
                alone, shared = try_contained(members, targets), try_shared(members, targets)
                for attack in members:
                    found = (result(each[attack.name]) for each in (alone, shared))
                    print(f"  {attack.name:44} {' '.join(found)} {attack.by}")
            print("\nin a folder with folders of others, such as the home folder")
            alone = try_contained(IN_SHARED_FOLDER, targets.in_shared_folder)
            for attack in IN_SHARED_FOLDER:
                print(f"  {attack.name:44} {result(alone[attack.name])} {attack.by}")
            victim.communicate(b"\n")


def main() -> None:
    cost()
    attacks()


if __name__ == "__main__":
    main()
