"""Those who are told what happens in a run."""

from learnblock.runtime.messages import Variables
from learnblock.runtime.status import State


class Watcher:
    """Is told what happens while it happens; the base class ignores it all."""

    def printed(self, text: str) -> None:
        """The program printed a line."""

    def line(self, number: int) -> None:
        """A line of the program's Python is about to run."""

    def input(self, prompt: str) -> str | None:  # noqa: ARG002 - for those who have someone to ask
        """The program asks for a line; None when there is no one to answer."""
        return None

    def cancel_input(self) -> None:
        """The run is being stopped: `input` returns at once, now and later; from any thread."""

    def state(self, state: State) -> None:
        """What the run is doing has changed; from any thread, and never to wait for another."""

    def held(self, line: int, variables: Variables) -> None:
        """The program is held before a line of its Python, its world with it."""

    def resumed(self) -> None:
        """The program goes on after it was held."""

    def variables(self, variables: Variables) -> None:
        """The program's variables now; told only while the run's `tells_variables` is set."""

    def tick(self) -> None:
        """Some time has passed: a good moment to draw."""
