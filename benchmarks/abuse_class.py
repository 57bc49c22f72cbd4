"""Measure how long a child in a class waits while a client beside it does its worst.

    python benchmarks/abuse_class.py [words in an attack's name]

Each attack has a class of its own, on this computer. The child asks three things twenty times a
second: for its projects, on its page; for its page, on a new connection; and, as a child who has
not joined yet, whether the class is open. The longest answer should take at most 0.5 s.
"""

import http.client
import json
import os
import platform
import socket
import ssl
import sys
import tempfile
import threading
import unicodedata
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from itertools import product
from pathlib import Path
from time import perf_counter, sleep

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from sessions import megabytes
from websockets.sync.client import connect

from classes import Class, Joined, opened

#: Seconds that the child may wait, and between its questions.
AIM, PERIOD = 0.5, 0.05
#: Seconds for which an attack keeps what it has opened: longer than the class gives it.
HELD = 13.0
HALF = b'POST /join HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 100\r\n\r\n{"w'


class Child:
    """Asks again and again, in threads, and measures the longest answer to each question."""

    def __init__(self, room: Class, pupil: Joined, context: ssl.SSLContext | None) -> None:
        self.longest: dict[str, float] = {}
        self.failed: dict[str, str] = {}
        self._room = room
        self._pupil = pupil
        self._context = context
        self._over = threading.Event()
        self._questions = (self._on_its_page, self._with_its_badge, self._without_a_badge)

    @contextmanager
    def asking(self) -> Iterator[None]:
        threads = [threading.Thread(target=self._repeat, args=(one,)) for one in self._questions]
        for thread in threads:
            thread.start()
        try:
            yield
        finally:
            self._over.set()
            for thread in threads:
                thread.join()

    def wait(self) -> None:
        """Wait until each question has been answered."""
        while len(self.longest) < len(self._questions):
            sleep(PERIOD)

    def _repeat(self, question: Callable[[], Iterator[None]]) -> None:
        name = question.__name__.strip("_").replace("_", " ")
        answers = question()
        while not self._over.is_set():
            began = perf_counter()
            try:
                next(answers)
            except Exception as error:  # noqa: BLE001 - it is the result
                self.failed[name] = f"{type(error).__name__}: {error}"
                answers = question()
            self.longest[name] = max(self.longest.get(name, 0.0), perf_counter() - began)
            self._over.wait(PERIOD)

    def _on_its_page(self) -> Iterator[None]:
        scheme = "wss" if self._context else "ws"
        with connect(
            f"{scheme}://127.0.0.1:{self._room.port}/{self._pupil.address}ws",
            subprotocols=["learnblock"],  # type: ignore[list-item]
            additional_headers={"Cookie": self._pupil.cookie},
            ssl=self._context,
            max_size=None,
        ) as page:
            while True:
                page.send('{"kind":"ListProjects"}')
                while not str(page.recv(timeout=30)).startswith('{"kind":"Projects"'):
                    pass
                yield

    def _with_its_badge(self) -> Iterator[None]:
        while True:
            self._get(f"/{self._pupil.address}palette/en.json", self._pupil.cookie)
            yield

    def _without_a_badge(self) -> Iterator[None]:
        while True:
            self._get("/about.json", "")
            yield

    def _get(self, path: str, cookie: str) -> None:
        status = asked(self._room.port, path, cookie=cookie, context=self._context)[0]
        if status != 200:
            raise RuntimeError(f"status {status}")


def asked(
    port: int,
    path: str,
    body: bytes | None = None,
    *,
    cookie: str = "",
    context: ssl.SSLContext | None = None,
) -> tuple[int, bytes]:
    if context:
        connection: http.client.HTTPConnection = http.client.HTTPSConnection(
            "127.0.0.1", port, timeout=30, context=context
        )
    else:
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=30)
    try:
        headers = {"Cookie": cookie} if cookie else {}
        connection.request("GET" if body is None else "POST", path, body, headers)
        answer = connection.getresponse()
        return answer.status, answer.read()
    finally:
        connection.close()


def hold(room: Class, count: int, sent: bytes) -> str:
    """Open connections that send this and then nothing, and leave all at once."""
    kept = 0
    with ExitStack() as stack:
        for _ in range(count):
            with suppress(OSError):
                one = socket.create_connection(("127.0.0.1", room.port), timeout=10)
                stack.enter_context(one)
                one.sendall(sent)
                kept += 1
        open_at_first = descriptors(room)
        sleep(HELD)
        return f"{kept} connected, {open_at_first} descriptors, {descriptors(room)} after {HELD} s"


def halves(room: Class, pupil: Joined) -> str:
    del pupil
    return hold(room, 1100, HALF)


def silent(room: Class, pupil: Joined) -> str:
    del pupil
    return hold(room, 1100, b"")


def handshakes(room: Class, pupil: Joined) -> str:
    del pupil
    return hold(room, 200, b"")


def garbage(room: Class, pupil: Joined) -> str:
    del pupil
    for _ in range(2000):
        with suppress(OSError), socket.create_connection(("127.0.0.1", room.port), 10) as one:
            one.sendall(b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + os.urandom(50))
    return "2000 connections with bytes that are not HTTP"


def uploads(room: Class, pupil: Joined) -> str:
    head = (
        f"POST /{pupil.address}projects/x/runs?filename=a.why HTTP/1.1\r\nHost: 127.0.0.1\r\n"
        f"Cookie: {pupil.cookie}\r\nContent-Length: 39900000\r\n\r\n"
    ).encode()
    part = bytes(1_000_000)

    def upload(stack: ExitStack) -> None:
        with suppress(OSError):
            one = socket.create_connection(("127.0.0.1", room.port), timeout=10)
            stack.enter_context(one)
            one.sendall(head)
            for _ in range(39):
                one.sendall(part)

    with ExitStack() as stack:
        threads = [threading.Thread(target=upload, args=(stack,)) for _ in range(15)]
        for thread in threads:
            thread.start()
        most = 0.0
        for _ in range(int(HELD)):
            most = max(most, megabytes(room.process.pid))
            sleep(1)
        for thread in threads:
            thread.join()
        return f"15 uploads of 39 MB, the class at most {most:.0f} MB"


def pages(room: Class, pupil: Joined) -> str:
    refused = 0
    with ExitStack() as stack:
        for _ in range(200):
            with suppress(Exception):
                page = connect(
                    f"ws://127.0.0.1:{room.port}/{pupil.address}ws",
                    subprotocols=["learnblock"],  # type: ignore[list-item]
                    additional_headers={"Cookie": pupil.cookie},
                    max_size=None,
                )
                stack.enter_context(page)
                refused += "class-too-many-pages" in str(page.recv(timeout=10))
        return f"200 pages, {refused} refused"


def names(room: Class, pupil: Joined) -> str:
    del pupil
    wrong = ["apple", "apple", "apple", "apple"]
    marks = ["", "\u0300", "\u0301", "\u0302", "\u0308", "\u0304", "\u0306", "\u030c"]
    spellings = [unicodedata.normalize("NFC", f"Le{e}o{o}") for e, o in product(marks, marks)][:58]
    codes: dict[str, int] = {}
    tries = [("Zoe", None)] * 58 + [(name, wrong) for name in spellings]
    for name, pictures in tries:
        body = json.dumps({"word": room.word, "name": name, "pictures": pictures}).encode()
        status, answer = asked(room.port, "/join", body)
        code = "joined" if status == 200 else json.loads(answer)["message"]["code"]
        codes[code] = codes.get(code, 0) + 1
    return ", ".join(f"{code} {count}" for code, count in codes.items())


def descriptors(room: Class) -> int:
    return len(list(Path(f"/proc/{room.process.pid}/fd").iterdir()))


Attack = Callable[[Class, Joined], str]
ATTACKS: tuple[tuple[Attack, tuple[str, ...]], ...] = (
    (halves, ()), (silent, ()), (handshakes, ("--tls",)), (halves, ("--tls",)), (garbage, ()),
    (uploads, ()), (pages, ()), (names, ()),
)  # fmt: skip


def joined(room: Class, name: str, context: ssl.SSLContext | None) -> Joined:
    body = json.dumps({"word": room.word, "name": name, "pictures": None}).encode()
    if context is None:
        return room.pupil(name)
    connection = http.client.HTTPSConnection("127.0.0.1", room.port, context=context)
    connection.request("POST", "/join", body)
    answer = connection.getresponse()
    cookie = (answer.getheader("set-cookie") or "").partition(";")[0]
    return Joined(room, name, json.loads(answer.read())["address"], cookie)


def measure(attack: Attack, options: tuple[str, ...]) -> None:
    context = ssl._create_unverified_context() if options else None  # noqa: S323, SLF001 - our own
    with tempfile.TemporaryDirectory() as home, tempfile.TemporaryFile("w+") as errors:
        with opened(Path(home), *options, errors=errors) as room:
            child, attacker = joined(room, "Ana", context), joined(room, "Leo", context)
            watched = Child(room, child, context)
            with watched.asking():
                # The first answer starts the child's server.
                watched.wait()
                watched.longest = {}
                sleep(3)
                quiet, watched.longest = watched.longest, {}
                outcome = attack(room, attacker)
            memory = megabytes(room.process.pid)
            began = perf_counter()
            room.close()
            closing = perf_counter() - began
        errors.seek(0)
        lines = len(errors.read().splitlines())
    print(f"{attack.__name__} {' '.join(options)}: {outcome}")
    for name, longest in sorted(watched.longest.items()):
        mark = "!" if longest > AIM else " "
        print(f"{mark}{longest * 1e3:6.0f} ms  {name}, {quiet.get(name, 0) * 1e3:.0f} ms before")
    for name, failed in watched.failed.items():
        print(f"!           {name}: {failed}")
    print(
        f"  the class: {memory:.0f} MB, printed {lines} lines, closed in {closing:.1f} s",
        flush=True,
    )


def main() -> None:
    words = sys.argv[1] if len(sys.argv) > 1 else ""
    print(f"Python {platform.python_version()}, {os.cpu_count()} processors")
    for attack, options in ATTACKS:
        if words in attack.__name__:
            measure(attack, options)


if __name__ == "__main__":
    main()
