"""Joining: the word of the class, a first name, and four pictures."""

import asyncio
import math
import time
from collections import Counter
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass, field

from learnblock import names
from learnblock.classroom import limits
from learnblock.classroom import messages as ours
from learnblock.classroom.attempts import Attempts
from learnblock.classroom.join_words import is_join_word
from learnblock.classroom.pins import Picture
from learnblock.classroom.quota import Buckets
from learnblock.classroom.roster import Pupil, Roster, checked_name
from learnblock.errors import LearnBlockError

#: The most tries of one address that wait for their turn.
_MOST_WAITING = 5


@dataclass
class Entrance:
    """Lets pupils in.

    Args:
        roster: the class.
        now: returns the time of a monotonic clock in seconds.
    """

    roster: Roster
    now: Callable[[], float] = time.monotonic
    _names: Attempts = field(init=False)
    #: A whole class may come from one address, and children mistype.
    _addresses: Attempts = field(init=False)
    _new: Buckets = field(init=False)
    #: One try at a time, because each takes a processor for a while.
    _turn: asyncio.Lock = field(default_factory=asyncio.Lock)
    _waiting: Counter[str] = field(default_factory=Counter)

    def __post_init__(self) -> None:
        self._names = Attempts(*limits.WRONG_BY_NAME, now=self.now)
        self._addresses = Attempts(*limits.WRONG_BY_ADDRESS, now=self.now)
        self._new = Buckets(limits.JOINING, self.now)

    async def join(self, message: ours.Join, address: str) -> tuple[Pupil, tuple[Picture, ...]]:
        """Let a pupil in; return the pupil, and the pictures of a new one.

        Args:
            message: what the pupil has typed.
            address: of the pupil's computer.

        Raises:
            LearnBlockError: the word, the name or the pictures are wrong, the class is closed, or
                there have been too many tries.
            OSError: a new pupil can't be saved.
        """
        self.require_word(message.word, address)
        name = checked_name(message.name)
        is_new = message.pictures is None
        if is_new and not message.is_first_name and names.may_have_surname(name):
            raise LearnBlockError("class-only-first-name", name=name)
        async with self._turn_of(address):
            if message.pictures is None:
                return await self._added(name, address)
            return await self._recognised(name, message.pictures, address), ()

    def require_word(self, word: str, address: str) -> None:
        """Check the join word that is typed at an address.

        Raises:
            LearnBlockError: it is wrong, or there have been too many tries.
        """
        self._addresses.require(address)
        if not is_join_word(word, self.roster.word):
            self._addresses.failed(address)
            raise LearnBlockError("class-wrong-word")

    @asynccontextmanager
    async def _turn_of(self, address: str) -> AsyncIterator[None]:
        """Wait until it is this address's turn; one with many tries must not delay the others."""
        if self._waiting[address] >= _MOST_WAITING:
            raise LearnBlockError("class-join-wait", seconds=1)
        self._waiting[address] += 1
        try:
            async with self._turn:
                yield
        finally:
            self._waiting[address] -= 1
            if not self._waiting[address]:
                del self._waiting[address]

    async def _added(self, name: str, address: str) -> tuple[Pupil, tuple[Picture, ...]]:
        self.roster.require_place(name)
        if wait := self._new.try_take(address):
            raise LearnBlockError("class-join-wait", seconds=math.ceil(wait))
        return await asyncio.to_thread(self.roster.add, name)

    async def _recognised(self, name: str, pictures: tuple[Picture, ...], address: str) -> Pupil:
        # The same for every name, so that the answer doesn't reveal who is in the class.
        key = names.folded(name)
        self._names.require(key)
        pupil = await asyncio.to_thread(self.roster.recognise, name, pictures)
        if pupil is None:
            self._names.failed(key)
            self._addresses.failed(address)
            raise LearnBlockError("class-wrong-pictures")
        self._names.succeeded(key)
        return pupil
