"""A test bench for clients: it creates connected clients and makes their link fail."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from time import monotonic

from learnblock.client import Client
from learnblock.testing.relay import Fault, Relay

Make = Callable[[], Client]


class BrokenClaimError(Exception):
    """The claim is false."""


class SkippedClaimError(Exception):
    """The claim cannot be checked, because the robot lacks a device."""


@dataclass
class Bench:
    """The setup of a check.

    Args:
        make: returns a connected client.
        relay: the link between client and robot, or None.
        patience: the limit of each step, in seconds.
    """

    make: Make
    relay: Relay | None
    patience: float

    @contextmanager
    def robot(self) -> Iterator[Client]:
        """A connected client, which is stopped afterwards."""
        robot = self.make()
        try:
            yield robot
        finally:
            robot.stop()

    @contextmanager
    def fault(self, fault: Fault) -> Iterator[None]:
        """Make the link fail inside the `with` block."""
        assert self.relay is not None  # noqa: S101 - such a claim is skipped without one
        self.relay.fault = fault
        try:
            yield
        finally:
            self.relay.fault = Fault.NONE

    @contextmanager
    def in_time(self, what: str, seconds: float | None = None) -> Iterator[None]:
        """Require that the `with` block ends within the timeout."""
        allowed = self.patience if seconds is None else seconds
        began = monotonic()
        yield
        took = monotonic() - began
        require(took <= allowed, f"{what} took {took:.1f} s, but only {allowed:g} s are allowed")


def require(holds: bool, problem: str) -> None:  # noqa: FBT001 - it holds or it does not
    """Check a condition of a claim.

    Raises:
        BrokenClaimError: it is false.
    """
    if not holds:
        raise BrokenClaimError(problem)
