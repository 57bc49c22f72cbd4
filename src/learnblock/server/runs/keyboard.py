"""The keyboard of a project: every listening program gets the keys held on any page.

Only a guest's program has keys of its own: those held on the guest's page.
"""

from collections.abc import Hashable, Iterable, Mapping, Sequence

from learnblock.client.keyboard import KEYS, Key
from learnblock.server import messages
from learnblock.server.runs.viewers import Viewer, Viewers


class SharedKeyboard:
    """The keys that users hold down, and those that running programs ask for.

    Its methods run in the event loop, except `held`.

    Args:
        viewers: the pages that show the project, with any of its robots.
    """

    def __init__(self, viewers: Viewers) -> None:
        self._viewers = viewers
        self._wanted: dict[Hashable, tuple[Key, ...]] = {}
        #: The keys that the user of each page holds down.
        self._pages: dict[Viewer, frozenset[Key]] = {}
        #: The robots that guests drive, by the guests' pages.
        self._guests: dict[Viewer, Hashable] = {}
        #: The keys that are held for each robot of a guest, and for all others.
        self._held: Mapping[Hashable, frozenset[Key]] = {}
        self._told = messages.KeysWanted(())

    def held(self, program: Hashable, *, is_guests: bool = False) -> Sequence[Key]:
        """The keys of a program that its users hold down; called from its thread.

        Args:
            program: the program.
            is_guests: whether it is a guest's, even if the guest has left.
        """
        keys = self._held.get(program if is_guests else None, frozenset())
        return [key for key in self._wanted.get(program, ()) if key in keys]

    def keep_apart(self, page: Viewer, program: Hashable) -> None:
        """Hold the keys of a guest's page for a guest's program only, until the page leaves."""
        self._guests[page] = program
        self._renew()

    def want(self, program: Hashable, keys: tuple[Key, ...]) -> None:
        """A program asks for these keys from now on."""
        self._wanted[program] = keys
        self._tell()

    def ignore(self, program: Hashable) -> None:
        """A program asks for no more keys, if it ever did."""
        if self._wanted.pop(program, None) is None:
            return
        if not self._wanted:
            # Keys held now are not for the next run.
            self._pages.clear()
            self._renew()
        self._tell()

    def hold(self, page: Viewer, keys: Iterable[Key]) -> None:
        """Let a page's user hold down these keys, and no others."""
        if self._wanted:
            self._pages[page] = frozenset(keys)
            self._renew()

    def join(self, page: Viewer) -> None:
        """Tell a page which keys the programs ask for."""
        if self._wanted:
            page.send(self._told)

    def release(self, page: Viewer) -> None:
        """Release the keys that the user of a page holds down."""
        if self._pages.pop(page, None):
            self._renew()

    def leave(self, page: Viewer) -> None:
        """Forget a page that leaves, and release its keys."""
        self._pages.pop(page, None)
        self._guests.pop(page, None)
        self._renew()

    def _renew(self) -> None:
        groups = {None, *self._guests.values()}
        self._held = {group: self._held_for(group) for group in groups}

    def _held_for(self, program: Hashable) -> frozenset[Key]:
        """The keys held for the program of a guest, or for all others with None."""
        pages = (keys for page, keys in self._pages.items() if self._guests.get(page) == program)
        return frozenset[Key]().union(*pages)

    def _tell(self) -> None:
        wanted = frozenset[Key]().union(*self._wanted.values())
        keys = tuple(key for key in KEYS if key in wanted)
        self._told = messages.KeysWanted(keys, programs=len(self._wanted))
        self._viewers.send(self._told)
