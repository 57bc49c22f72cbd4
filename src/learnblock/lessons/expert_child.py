"""The process that runs a check in a lesson's Python: see `expert`."""

import json
import os
import signal
import socket
import sys
from types import SimpleNamespace
from typing import Any

from learnblock.runtime import forking
from learnblock.runtime.containment import fence
from learnblock.runtime.limits import Limits
from learnblock.runtime.messages import Setup


def main() -> None:
    """Run as ``python -m learnblock.lessons.expert_child FD``: FD is our end of the connection.

    The task arrives there, and the answer is sent there. If it is a fork server's end of its
    orders, each order makes a process that does this.
    """
    given = socket.socket(fileno=int(sys.argv[1]))
    connection = given if given.type is socket.SOCK_STREAM else _forked(given)
    if connection is not None:
        _judge(connection)


def _forked(orders: socket.socket) -> socket.socket | None:
    """Be a fork server; return the connection in the process of a check."""
    from learnblock.runtime.containment import kernel  # noqa: PLC0415 - only Linux has it

    kernel.die_with_parent(signal.SIGKILL)
    fence.prepare()
    return forking.next_program(orders)


def _judge(connection: socket.socket) -> None:
    with connection.makefile("rb") as stream:
        task = json.load(stream)
    fence.contain(Setup("", "checks.py", "", (), (), None, Limits(*task["limits"])))
    answer = json.dumps(_answer(task["source"], task["function"], SimpleNamespace(**task["run"])))
    connection.sendall(answer.encode())
    # Nothing of the check's is to run any more, such as its threads.
    os._exit(0)


def _answer(source: str, function: str, run: SimpleNamespace) -> dict[str, Any]:
    # What a check prints is ignored.
    sys.stdout = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115, PTH123 - until the end
    try:
        names: dict[str, Any] = {"__name__": "checks"}
        exec(compile(source, "checks.py", "exec", dont_inherit=True), names)  # noqa: S102 - contained
        verdict = names[function](run)
    except BaseException as error:  # noqa: BLE001 - with any error, the check is not met
        return {"met": False, "error": f"{type(error).__name__}: {error}"[:300]}
    if isinstance(verdict, str):
        return {"met": False, "reason": verdict}
    if isinstance(verdict, dict):
        texts = {str(key): str(value) for key, value in verdict.items()}
        return {"met": False, "reason": texts}
    return {"met": verdict is True}


if __name__ == "__main__":
    main()
