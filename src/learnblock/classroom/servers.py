"""The servers of the pupils, as the classroom starts, reaches and stops them."""

import asyncio
import secrets
import socket
import subprocess
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Protocol

import msgspec

from learnblock.blocks.block_sets import EVERYTHING, BuiltIn
from learnblock.classroom.nursery import News, NurseryRequest, Patience
from learnblock.classroom.pupil_server import Order
from learnblock.errors import LearnBlockError
from learnblock.runtime.escalation import Measure, escalate

#: Seconds within which a server answers, and within which the nursery has ended one.
_STARTING, _ENDING = 30.0, Patience().asked + 3.0
#: Seconds for the nursery to end, with every server: after it was asked, hurried and killed.
_CLOSING, _HURRIED, _KILLED = _ENDING, Patience().hurried + 1.0, 1.0


@dataclass(frozen=True, slots=True)
class ServerAddress:
    """Where a pupil's server answers.

    Args:
        host: its address and port.
        base_url: the path of the page there.
        token: with which the classroom comes in; empty if others let it in by its headers.
        headers: what each request says besides.
        is_encrypted: whether it is reached by HTTPS.
        process: its process; 0 if it is not on this computer.
    """

    host: str
    base_url: str
    token: str = ""
    headers: Mapping[str, str] = field(default_factory=dict)
    is_encrypted: bool = False
    process: int = 0

    def url(self, scheme: str, path: str) -> str:
        """The address of a path of the page, by `http` or `ws`."""
        return f"{scheme}{'s' * self.is_encrypted}://{self.host}{self.base_url}{path}"


class PupilServers(Protocol):
    """What starts and ends pupils' servers."""

    @property
    def are_saved(self) -> bool:
        """Whether every server has saved everything, once all are closed."""

    async def open(self) -> None:
        """Get ready to start them."""

    def refuse(self) -> None:
        """Start no more servers."""

    async def close(self) -> None:
        """Have every server save everything and end."""

    def hurry(self) -> None:
        """Have every server save and end at once."""

    async def place(self, pupil: str, folder: Path) -> ServerAddress:
        """The place of a pupil's server, which is started if it is not running."""

    async def stop(self, pupil: str) -> None:
        """Have a pupil's server save everything and end."""


class Servers:
    """The pupils' servers, by pupil.

    Args:
        ended: called with a pupil's id when the pupil's server has ended.
        blocks: the block set with which pupils' own projects begin.
    """

    def __init__(self, ended: Callable[[str], object], blocks: BuiltIn = EVERYTHING) -> None:
        self._ended = ended
        self._blocks = blocks
        #: Whether every server has saved everything and ended by itself, once all are closed.
        self.are_saved = False
        self._is_ending = False
        self._places: dict[str, ServerAddress] = {}
        self._starting: dict[str, asyncio.Future[News]] = {}
        self._locks: dict[str, asyncio.Lock] = {}
        self._changed = asyncio.Condition()
        self._process: subprocess.Popen[bytes] | None = None
        self._writer: asyncio.StreamWriter | None = None
        self._listening: asyncio.Task[None] | None = None

    async def open(self) -> None:
        """Start the process that starts servers."""
        ours, theirs = socket.socketpair()
        with theirs:
            command = [sys.executable, "-m", "learnblock.classroom.nursery", str(theirs.fileno())]
            # A session of its own, so that Ctrl-C reaches only the classroom.
            self._process = subprocess.Popen(  # noqa: S603 - our own module
                command, pass_fds=[theirs.fileno()], start_new_session=True
            )
        reader, self._writer = await asyncio.open_connection(sock=ours)
        self._listening = asyncio.create_task(self._listen(reader))

    def refuse(self) -> None:
        """Start no more servers, and tell those who wait for one; the others go on."""
        self._is_ending = True
        for news in self._starting.values():
            if not news.done():
                news.set_exception(LearnBlockError("class-ends"))

    async def close(self) -> None:
        """Have every server save everything and end."""
        if self._writer is None:
            return
        self.refuse()
        self._writer.close()
        await asyncio.to_thread(self._end, Measure(bool, _CLOSING))
        if self._listening:
            self._listening.cancel()

    def hurry(self) -> None:
        """Have every server save and end at once; from another thread than the event loop's."""
        self._end()

    def _end(self, *measures: Measure) -> None:
        process = self._process
        if process:
            # A killed nursery takes its servers with it, see `kernel.die_with_parent`.
            harder = Measure(process.terminate, _HURRIED), Measure(process.kill, _KILLED)
            escalate([*measures, *harder], partial(_ends_within, process))
            self.are_saved = process.returncode == 0

    async def place(self, pupil: str, folder: Path) -> ServerAddress:
        """The place of a pupil's server, which is started if it is not running.

        Raises:
            LearnBlockError: it does not start, or the class ends.
        """
        async with self._locks.setdefault(pupil, asyncio.Lock()):
            if pupil not in self._places:
                self._places[pupil] = await self._start(pupil, folder)
            return self._places[pupil]

    async def stop(self, pupil: str) -> None:
        """Have a pupil's server save everything and end, if it is running.

        Raises:
            TimeoutError: it has not ended after some seconds, although it was killed.
        """
        async with self._locks.setdefault(pupil, asyncio.Lock()):
            place = self._places.get(pupil)
            if place is None:
                return
            self._ask(NurseryRequest(stop=place.process))
            async with asyncio.timeout(_ENDING), self._changed:
                await self._changed.wait_for(lambda: self._places.get(pupil) is not place)

    async def _start(self, pupil: str, folder: Path) -> ServerAddress:
        if self._is_ending:
            raise LearnBlockError("class-ends")
        token, base_url = secrets.token_urlsafe(24), f"/p/{pupil}/"
        news = self._starting[pupil] = asyncio.get_running_loop().create_future()
        self._ask(NurseryRequest(Order(pupil, str(folder), base_url, token, self._blocks)))
        try:
            async with asyncio.timeout(_STARTING):
                started = await news
        except TimeoutError as error:
            raise LearnBlockError("class-server-silent") from error
        finally:
            del self._starting[pupil]
        if not started.port:
            raise LearnBlockError("class-server-failed", reason=started.reason)
        return ServerAddress(f"127.0.0.1:{started.port}", base_url, token, process=started.process)

    def _ask(self, ask: NurseryRequest) -> None:
        assert self._writer is not None  # noqa: S101 - `open` comes first
        self._writer.write(msgspec.json.encode(ask) + b"\n")

    async def _listen(self, reader: asyncio.StreamReader) -> None:
        while line := await reader.readline():
            news = msgspec.json.decode(line, type=News)
            waiting = self._starting.get(news.pupil)
            if waiting and not waiting.done() and (news.port or news.reason):
                waiting.set_result(news)
            elif not news.port:
                await self._forget(news)

    async def _forget(self, news: News) -> None:
        place = self._places.get(news.pupil)
        if place is None or place.process != news.process:
            return
        async with self._changed:
            del self._places[news.pupil]
            self._changed.notify_all()
        self._ended(news.pupil)


def _ends_within(process: "subprocess.Popen[bytes]", seconds: float) -> bool:
    """Wait for a process to end; return whether it has ended within `seconds`."""
    try:
        process.wait(seconds)
    except subprocess.TimeoutExpired:
        return False
    return True
