"""Joining: the word of the class, a first name, and four pictures."""

import asyncio
from dataclasses import dataclass, field

from learnblock.classroom import messages as ours
from learnblock.classroom.attempts import Attempts
from learnblock.classroom.join_words import is_join_word
from learnblock.classroom.pins import Picture
from learnblock.classroom.roster import Pupil, Roster, checked_name
from learnblock.errors import LearnBlockError


def _attempts_by_name() -> Attempts:
    return Attempts(free=5, pause=10.0)


def _attempts_by_address() -> Attempts:
    # A whole class may come from one address, and children mistype.
    return Attempts(free=60, pause=5.0)


@dataclass
class Entrance:
    """Lets pupils in.

    Args:
        roster: the class.
    """

    roster: Roster
    _names: Attempts = field(default_factory=_attempts_by_name)
    _addresses: Attempts = field(default_factory=_attempts_by_address)
    #: One try at a time, because each takes a processor for a while.
    _turn: asyncio.Lock = field(default_factory=asyncio.Lock)

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
        self._addresses.require(address)
        if not is_join_word(message.word, self.roster.word):
            self._addresses.failed(address)
            raise LearnBlockError("class-wrong-word")
        name = checked_name(message.name)
        async with self._turn:
            if message.pictures is None:
                return await asyncio.to_thread(self.roster.add, name)
            return await self._recognised(name, message.pictures, address), ()

    async def _recognised(self, name: str, pictures: tuple[Picture, ...], address: str) -> Pupil:
        # The same for every name, so that the answer doesn't tell who is in the class.
        key = name.casefold()
        self._names.require(key)
        pupil = await asyncio.to_thread(self.roster.recognise, name, pictures)
        if pupil is None:
            self._names.failed(key)
            self._addresses.failed(address)
            raise LearnBlockError("class-wrong-pictures")
        self._names.succeeded(key)
        return pupil
