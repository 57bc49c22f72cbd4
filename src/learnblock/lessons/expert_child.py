"""The process that runs a check in a lesson's Python: see `expert`."""

import json
import os
import sys
from types import SimpleNamespace
from typing import Any

from learnblock.runtime.containment.fence import contain
from learnblock.runtime.limits import Limits
from learnblock.runtime.messages import Setup


def main() -> None:
    """Read the task from the standard input, and write the answer to the standard output."""
    task = json.load(sys.stdin.buffer)
    contain(Setup("", "checks.py", "", (), (), None, Limits(*task["limits"])))
    answer = json.dumps(_answer(task["source"], task["function"], SimpleNamespace(**task["run"])))
    os.write(1, answer.encode())
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
