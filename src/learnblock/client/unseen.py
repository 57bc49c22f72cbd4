"""The texts that a robot has no screen for."""

from learnblock.devices import LONGEST_TEXT

#: The printed texts, so that a loop that shows a number does not exceed the limit of the output.
MOST_TEXTS = 2000


class UnseenTexts:
    """Prints the texts of a robot without a screen, each time they change."""

    def __init__(self) -> None:
        self._last = ""
        self._count = 0

    def show(self, text: str) -> None:
        """Print a text, cut like on a screen; after `MOST_TEXTS` of them only ``...``, once."""
        if text == self._last:
            return
        self._last = text
        if text and self._count <= MOST_TEXTS:
            # The print of the program's process: the text appears among its output.
            print(text[:LONGEST_TEXT] if self._count < MOST_TEXTS else "...")  # noqa: T201
            self._count += 1
