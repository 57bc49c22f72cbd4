"""The end of a program that has to be stopped, and the cause of one that died."""

import signal
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.runtime import messages
from learnblock.runtime.activity import Allowance
from learnblock.runtime.conversation import Conversation
from learnblock.runtime.ending import Ending, How
from learnblock.runtime.limits import Limits
from learnblock.runtime.process import Worker

#: Seconds that a stopped program may spend in its `finally` blocks, as it computes and waits.
GRACE = 0.4
#: Seconds of the wall clock after which it is not waited for, even if a busy machine has kept it
#: from its grace; who stops a run kills it earlier (`escalation.PATIENCE`).
LONGEST_GRACE = 5.0
#: Seconds between two looks at how it spends its grace.
_LOOK = 0.05


def dismiss(
    conversation: Conversation,
    ending: Ending,
    *,
    waits: bool,
    handle: Callable[[Any], None],
) -> Ending:
    """Make a program end itself, and return how and where it ended.

    Args:
        conversation: the conversation with the program.
        ending: how it should end.
        waits: whether the program is waiting for an answer.
        handle: handles the messages it sent before it was interrupted.
    """
    try:
        if waits:
            conversation.send(messages.Stop())
        else:
            conversation.worker.interrupt()
        for message in _messages(conversation):
            match message:
                case messages.Ended(lines=lines):
                    return replace(ending, line=lines[-1] if lines else ending.line)
                case messages.Interrupted(line, file, file_line):
                    waits = True
                    ending = replace(ending, line=line, file=file, file_line=file_line)
                case (
                    messages.Ask()
                    | messages.Sleep()
                    | messages.Input()
                    | messages.Line()
                    | messages.Collect()
                    | messages.Keys()
                ):
                    conversation.send(messages.Stop())
                case messages.Connect() | messages.Disconnect() | None:
                    continue
                case messages.Logged():
                    # What it did before: the last batch.
                    handle(message)
                case event if not waits:
                    handle(event)
    except (EOFError, LearnBlockError):
        # It died first, or sent something invalid; either way it has ended.
        return ending
    return ending


def cause_of_death(worker: Worker, limits: Limits) -> Ending:
    """How a program ended if its link closed without a last message."""
    status, grace = worker.wait(_LOOK), _grace(worker)
    while status is None and not grace.is_over:
        status = worker.wait(_LOOK)
        grace.look()
    if status is None:
        return Ending(How.KILLED, Phrase("run-link-closed"))
    if status >= 0:
        return Ending(How.KILLED, Phrase("run-process-ended", status=str(status)))
    if -status == getattr(signal, "SIGXCPU", None):
        return Ending(How.KILLED, Phrase("run-processor-time", seconds=limits.cpu))
    return Ending(How.KILLED, Phrase("run-killed", signal=_name(-status)))


def _messages(conversation: Conversation) -> Iterator[Any]:
    """The messages that a program sends during its grace period."""
    grace = _grace(conversation.worker)
    while not grace.is_over:
        yield conversation.receive(_LOOK)
        grace.look()


def _grace(worker: Worker) -> Allowance:
    return Allowance(GRACE, LONGEST_GRACE, worker.activity)


def _name(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        # A real-time signal: most of these have no name.
        return str(number)
