"""Notifications of events in a run."""

from collections.abc import Collection, Mapping, Sequence
from typing import Any

from learnblock.runtime.messages import Variables
from learnblock.runtime.status import State


class Watcher:
    """Receives events as they happen; the base class ignores them all."""

    def printed(self, text: str) -> None:
        """The program printed a line."""

    def line(self, number: int) -> None:
        """A line of the program's Python is about to run."""

    def called(self, skill: str, args: Sequence[Any], kwargs: Mapping[str, Any]) -> None:
        """The program has called a skill."""

    def missing(self, skill: str, device: str) -> None:
        """The skill that was called last had no effect: the robot lacks a device."""

    def input(self, prompt: str) -> str | None:  # noqa: ARG002 - subclasses need it
        """Return the line of input that the program is waiting for; None if there is no input."""
        return None

    def cancel_input(self) -> None:
        """The run is being stopped: `input` must return at once, now and later; from any thread."""

    def held_keys(self, time: float) -> Collection[str]:  # noqa: ARG002 - subclasses need it
        """Return the keys that are held down; asked only while the program asks for keys.

        Args:
            time: the robot's time in seconds.
        """
        return ()

    def state(self, state: State) -> None:
        """The state of the run has changed; called from any thread, and must not block."""

    def held(self, line: int, variables: Variables) -> None:
        """The program and its world have paused before a line of its Python code."""

    def resumed(self) -> None:
        """The program continues after a pause."""

    def variables(self, variables: Variables) -> None:
        """The program's current variables; reported only while this is enabled."""

    def tick(self) -> None:
        """Some time has passed: a good moment to redraw."""
