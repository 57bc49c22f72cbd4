"""The programs of an open project, in the order of their tabs."""

from collections.abc import Iterable, Iterator

from learnblock.errors import LearnBlockError
from learnblock.running import MOST_ROBOTS
from learnblock.running.robot_names import robot_names
from learnblock.server import messages
from learnblock.server.runs.viewers import Viewer
from learnblock.server.sessions.part import Part
from learnblock.server.sessions.prepared import PreparedPart


class Parts:
    """The programs of an open project with their robots, each of which has a name of its own.

    Args:
        parts: the programs, at least one.
    """

    def __init__(self, parts: Iterable[Part]) -> None:
        self._parts = list(parts)
        self.name_robots()
        #: What the pages show of them.
        self._tabs = self.tabs

    def __iter__(self) -> Iterator[Part]:
        return iter(tuple(self._parts))

    def __len__(self) -> int:
        return len(self._parts)

    @property
    def first(self) -> Part:
        """The first of them."""
        return self._parts[0]

    @property
    def last(self) -> Part:
        """The last of them."""
        return self._parts[-1]

    @property
    def kinds(self) -> tuple[str, ...]:
        """The name of each robot's kind."""
        return tuple(part.robot.name for part in self._parts for _ in part.players)

    @property
    def has_several(self) -> bool:
        """Whether there are several robots, which need names."""
        return len(self.kinds) > 1

    def index(self, part: Part) -> int:
        """The place of a program among the others."""
        return self._parts.index(part)

    def insert(self, index: int, part: Part) -> None:
        """Insert a program at a place."""
        self._parts.insert(index, part)
        self.name_robots()

    def remove(self, part: Part) -> None:
        """Remove a program."""
        self._parts.remove(part)
        self.name_robots()

    # Names.

    def named(self, name: str) -> Part | None:
        """The program with this name; None if there is none."""
        return next((part for part in self._parts if part.name == name), None)

    def require(self, name: str) -> Part:
        """The program with this name.

        Raises:
            LearnBlockError: there is none.
        """
        part = self.named(name)
        if part is None:
            raise LearnBlockError("tabs-no-such", name=name)
        return part

    def like(self, prepared: PreparedPart, count: int) -> Part | None:
        """The program that another form of the project names so; a single one has any name.

        Args:
            prepared: the program in the other form.
            count: how many programs that has.
        """
        if count == len(self._parts) == 1:
            return self.first
        return self.named(prepared.name)

    def free_name(self, wish: str) -> str:
        """The name that is wished for, with a number if it is taken."""
        names = (wish, *(f"{wish} {number}" for number in range(2, MOST_ROBOTS + 2)))
        return next(name for name in names if self.named(name) is None)

    def name_robots(self) -> None:
        """Give each robot its name in the world."""
        names = robot_names([part.name for part in self._parts for _ in part.players])
        for part in self._parts:
            part.name_robots([next(names) for _ in part.players])

    # Pages.

    def shown_to(self, page: Viewer) -> Part:
        """The program that a page shows."""
        return next(part for part in self._parts if page in part.viewers)

    @property
    def tabs(self) -> tuple[messages.Tab, ...]:
        """Their tabs; a robot that is alone has none."""
        return tuple(part.tab for part in self._parts) if self.has_several else ()

    def tab_name(self, part: Part) -> str:
        """The name of a program's tab; a robot that is alone has none."""
        return part.name if self.has_several else ""

    def show_tabs(self) -> None:
        """Show the pages what has changed on a tab."""
        before, self._tabs = self._tabs, self.tabs
        if self._tabs == before:
            return
        for part in self._parts:
            for player in part.players:
                tab, shows = self.tab_name(part), player.voice.robot
                player.viewers.send(messages.Tabs(self._tabs, tab, shows))
