"""The host's side of the conversation with the child that runs a program."""

from collections.abc import Callable
from contextlib import suppress
from typing import Any

from learnblock.client import skills
from learnblock.errors import LearnBlockError
from learnblock.runtime import messages
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.limits import Limits
from learnblock.runtime.link import AtOnce
from learnblock.runtime.process import Worker
from learnblock.runtime.program import Program


class Conversation:
    """The messages between host and child.

    Args:
        worker: runs the program.
        debugger: the debugger whose breakpoints are sent to the child whenever they change.
        check: checks what the child says.
    """

    def __init__(
        self,
        worker: Worker,
        debugger: Debugger | None,
        check: Callable[[Any], object] = lambda _: None,
    ) -> None:
        self.worker = worker
        self._check = check
        self._link = worker.link
        self._debugger = debugger
        self._control = debugger.control if debugger else None

    def begin(
        self,
        program: Program,
        limits: Limits,
        robots: tuple[str, ...],
        *,
        network: bool,
        anyway: bool,
        log: bool,
        variables: bool,
    ) -> None:
        """Send the program, with the modules that are robots and what it may use."""
        self._link.send(
            messages.Setup(
                source=program.python,
                filename=program.name,
                folder=program.folder,
                skills=_skills(program),
                robots=robots,
                debug=self._control,
                limits=limits,
                network=network,
                anyway=anyway,
                tags=dict(program.tags),
                log=log,
                variables=variables,
                dead_ends=program.dead_ends,
            )
        )

    def offer(self, at_once: AtOnce | None) -> None:
        """Offer a program in this thread what needs no message; see `Link.offer`."""
        # A debugger decides before each line whether it may run.
        if self._debugger is None:
            self._link.offer(at_once)

    def fail(self, error: Exception) -> None:
        """Raise an error at the next turn of the host; see `Link.fail`."""
        self._link.fail(error)

    def give_turn(self) -> None:
        """Let the host run, for a program in its thread; see `Link.give_turn`."""
        self._link.give_turn()

    def copied(self, value: Any) -> Any:
        """A value as it arrives at a program in this thread; see `Link.copied`."""
        return self._link.copied(value)

    def send(self, message: messages.Message) -> None:
        """Send a message that the program is waiting for.

        Raises:
            EOFError: the program is gone.
        """
        self.update_control()
        self._link.send(message)

    def send_unasked(self, message: messages.Message) -> None:
        """Send a message that the program accepts at any time."""
        # It may have ended meanwhile, in which case its ending is the next message we receive.
        with suppress(EOFError):
            self._link.send(message)

    def update_control(self) -> None:
        """Send the debugger's breakpoints and mode if they have changed."""
        if self._debugger and self._debugger.control is not self._control:
            self._control = self._debugger.control
            self.send_unasked(self._control)

    def receive(self, timeout: float) -> Any:
        """The next message, or None if none arrived within `timeout` seconds.

        Raises:
            EOFError: the program is gone.
            RobotConnectionError: the program has sent what cannot be true.
        """
        return self._checked(self._link.receive(timeout))

    def receive_last(self) -> Any:
        """The next message of an ended process; None while the process runs.

        Raises:
            EOFError: it has ended, and there is no further message.
            RobotConnectionError: as above.
        """
        if self.worker.wait(0) is None:
            return None
        message = self._link.receive_now()
        if message is None:
            raise EOFError("the program's process has ended")
        return self._checked(message)

    def _checked(self, message: Any) -> Any:
        if message is not None:
            self._check(message)
        return message


class Exchange:
    """A part of a conversation; several times faster than a generator's context.

    Args:
        conversation: the conversation.
        fail: handles an error in it; returns whether it did.
    """

    __slots__ = ("_conversation", "_fail")

    def __init__(
        self,
        conversation: Conversation,
        fail: Callable[[Conversation, BaseException], bool],
    ) -> None:
        self._conversation = conversation
        self._fail = fail

    def __enter__(self) -> Conversation:
        return self._conversation

    def __exit__(self, kind: object, error: BaseException | None, traceback: object) -> bool:
        return error is not None and self._fail(self._conversation, error)


def _skills(program: Program) -> tuple[str, ...]:
    """The skills that a program uses, so that the child need not search all installed ones."""
    try:
        return tuple(sorted(skills.find(program.names)))
    except LearnBlockError:
        # The child finds the same error, and raises it at the line of the program that causes it.
        return program.names
