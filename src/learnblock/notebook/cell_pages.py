"""The run of a cell as a page to take home, which notebooks show in a frame below the cell."""

import html
from collections.abc import Callable, Mapping
from pathlib import Path
from uuid import uuid4

from learnblock import language
from learnblock.blocks.known import all_configurations
from learnblock.i18n import Phrase, translate
from learnblock.i18n.reader import system_language
from learnblock.notebook.cell_program import CellProgram
from learnblock.notebook.robot_log import RobotLog
from learnblock.project.document.document import Document
from learnblock.running import source_of
from learnblock.server.runs.take_home import RobotRun, Titles, run_page

#: The time of a robot, in s, after which its cells have no page: each page runs its world again.
LONGEST = 180.0
#: The page may run its own scripts, and can read nothing of the notebook.
_FRAME = (
    '<iframe title="{title}" sandbox="allow-scripts" srcdoc="{page}"'
    ' style="width: 100%; height: 640px; border: 0"></iframe>'
)


class ShownCells:
    """Shows a robot below the cells that move it.

    Only the last one has a page; the ones before it keep their picture. A page would make the
    notebook's file 1.6 MB longer, and a browser draws only so many worlds in 3D at a time.

    Args:
        publish: shows data by types, as IPython's display publisher does.
    """

    def __init__(self, publish: Callable[..., object]) -> None:
        self._publish = publish
        self._last = ""
        self._picture: Mapping[str, str] = {}

    def show(self, picture: Mapping[str, str], page: str) -> None:
        """Show a cell.

        Args:
            picture: of the cell, by the types that notebooks show.
            page: its page as HTML; empty for none.
        """
        if self._last:
            self._show(self._last, self._picture, update=True)
        self._last, self._picture = uuid4().hex if page else "", picture
        self._show(self._last, {**picture, **({"text/html": page} if page else {})})

    def _show(self, name: str, data: Mapping[str, str], *, update: bool = False) -> None:
        transient = {"display_id": name} if name else {}
        self._publish(data=data, metadata={}, transient=transient, update=update)


def cell_page(log: RobotLog, cells: CellProgram, cell: int, began: float, now: float) -> str:
    """The run of a cell, as HTML; empty if it can't be shown.

    Args:
        log: of its robot, which is simulated.
        cells: all cells that have run.
        cell: the number of the cell.
        began: when it began, in s.
        now: when it ended.
    """
    kept = log.kept(cells)
    is_known = cells.nodes and not kept.complete_since
    if not is_known or not began < now < LONGEST:
        return ""
    words = system_language()
    title = translate(Phrase("notebook-cell", cell=str(cell)), words)
    robot = RobotRun(kept, _document(cells), log.robot)
    page = run_page([robot], Titles(title, words), began)
    return framed(page, title)


def framed(page: str, title: str) -> str:
    """A page in a frame, as HTML."""
    return _FRAME.format(title=html.escape(title), page=html.escape(page))


def _document(cells: CellProgram) -> Document:
    text = cells.program.python
    tree = source_of(Path("cells.py"), text, is_python=True).tree
    return Document.from_text(language.format(tree), "", all_configurations(), python=text)
