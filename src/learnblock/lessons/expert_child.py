"""The process that runs a check in a lesson's Python: see `expert`."""

import json
import os
import socket
import sys
from collections.abc import Mapping
from types import SimpleNamespace
from typing import Any

from learnblock.runtime.containment import fence
from learnblock.runtime.forking import next_program
from learnblock.runtime.limits import Limits
from learnblock.runtime.messages import Setup


def main() -> None:
    """Run as ``python -m learnblock.lessons.expert_child FD``: FD is our end of the connection.

    The task arrives there, and the answer is sent there. If it is a fork server's end of its
    orders, each order makes a process that does this.
    """
    endpoint = socket.socket(fileno=int(sys.argv[1]))
    is_task = endpoint.type is socket.SOCK_STREAM
    connection = endpoint if is_task else next_program(endpoint, fence.prepare)
    if connection is not None:
        _judge(connection)


def _judge(connection: socket.socket) -> None:
    with connection.makefile("rb") as stream:
        task = json.load(stream)
    fence.contain(Setup("", "checks.py", "", (), (), None, Limits(*task["limits"])))
    run = seen_run(task["run"], task["texts"])
    answer = _answer(task["source"], task["function"], run, task["texts"])
    connection.sendall(json.dumps(answer).encode())
    # Nothing of the check's is to run any more, such as its threads.
    os._exit(0)


def seen_run(run: Mapping[str, Any], texts: Mapping[str, Mapping[str, str]]) -> SimpleNamespace:
    """What a check sees: a run, and each of the lesson's texts in all its languages."""
    names = dict.fromkeys(name for language_texts in texts.values() for name in language_texts)
    every = {name: [language_texts[name] for language_texts in texts.values()] for name in names}
    return SimpleNamespace(**run, texts=every)


def reason(verdict: object, texts: Mapping[str, Mapping[str, str]]) -> str | dict[str, str]:
    """Why a check is not met, as text or as texts by language; "" if it does not say.

    Args:
        verdict: what its function returned: the name of one of the lesson's texts, alone or in
            front of the text's values by name; a text; or texts by language.
        texts: those of the lesson by language, each by its name.

    Raises:
        LookupError: the lesson has no such text, or a text needs another value.
        ValueError: a value cannot be formatted as its text wants.
    """
    if isinstance(verdict, dict):
        return {str(language): str(text) for language, text in verdict.items()}
    if isinstance(verdict, str):
        if not any(verdict in language_texts for language_texts in texts.values()):
            return verdict
        verdict = (verdict, {})
    if not isinstance(verdict, tuple):
        return ""
    if not texts:
        raise LookupError("there is no checks.en.toml")
    return {
        language: str(_in_language(verdict, language_texts))
        for language, language_texts in texts.items()
    }


def _in_language(value: object, texts: Mapping[str, str]) -> object:
    """A value of a text; a named text, with values of its own, is that text."""
    if not isinstance(value, tuple):
        return value
    name, values = value
    parts = {key: _in_language(part, texts) for key, part in values.items()}
    return texts[name].format(**parts)


def _answer(
    source: str, function: str, run: SimpleNamespace, texts: Mapping[str, Mapping[str, str]]
) -> dict[str, Any]:
    # What a check prints is ignored.
    sys.stdout = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115, PTH123 - until the end
    try:
        names: dict[str, Any] = {"__name__": "checks"}
        exec(compile(source, "checks.py", "exec", dont_inherit=True), names)  # noqa: S102 - contained
        verdict = names[function](run)
        return {"met": verdict is True, "reason": reason(verdict, texts)}
    except BaseException as error:  # noqa: BLE001 - with any error, the check is not met
        return {"met": False, "error": f"{type(error).__name__}: {error}"[:300]}


if __name__ == "__main__":
    main()
