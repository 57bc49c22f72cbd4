"""The notebook in whose kernel a program makes its robot, if it does.

Nothing of IPython is loaded here: a kernel has loaded it already, and every other program does
without it.
"""

import sys
from importlib import import_module
from typing import Any, Protocol

from learnblock.errors import LearnBlockError


class Notebook(Protocol):
    """What a notebook does for the robots of its kernel; each `robot` is a `Client`."""

    def make_room(self, robot: Any) -> None:
        """Disconnect an earlier robot that is the same device as one that is about to connect."""

    def join(self, robot: Any) -> None:
        """Take a robot in that has been connected."""

    def show(self, robot: Any, *, after_each_cell: bool) -> None:
        """Show a robot after this cell, and after each cell that moves it, or no longer."""

    def why(self, robot: Any, question: str) -> object:
        """Answer a question about what a robot has done; without one, say what can be asked."""


class InNotebook:
    """What a robot can do in a notebook only."""

    #: What the notebook keeps of it.
    membership: Any = None

    def show(self, *, after_each_cell: bool = True) -> None:
        """Show its world below the cell, with the way that the cell drove.

        Args:
            after_each_cell: whether each cell that moves it shows that from now on.

        Raises:
            LearnBlockError: the program runs in no notebook.
        """
        _notebook("show").show(self, after_each_cell=after_each_cell)

    def why(self, question: str = "") -> object:
        """Answer a question about what it has done in the notebook, such as "why did it bump?".

        Args:
            question: in English or Spanish; without one, the answer is what can be asked.

        Raises:
            LearnBlockError: the program runs in no notebook.
        """
        return _notebook("why").why(self, question)

    def _join_notebook(self, *, is_hosted: bool) -> None:
        """Join the notebook, if there is one; what a host makes belongs to its run."""
        if not is_hosted and (notebook := current_notebook()):
            notebook.join(self)


def current_notebook() -> Notebook | None:
    """The notebook in whose kernel this program runs; None elsewhere."""
    ipython = sys.modules.get("IPython")
    shell = getattr(ipython, "get_ipython", lambda: None)()
    if shell is None:
        return None
    # By its name, because it knows all of LearnBlock, and robots only know this protocol.
    sessions: Any = import_module("learnblock.notebook.session")
    notebook: Notebook = sessions.session_of(shell)
    return notebook


def _notebook(call: str) -> Notebook:
    notebook = current_notebook()
    if notebook is None:
        raise LearnBlockError("notebook-none", call=call)
    return notebook
