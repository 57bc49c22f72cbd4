"""A class in another process, as `learnblock class` opens it, and pupils who talk to it."""

import http.client
import itertools
import json
import os
import re
import signal
import subprocess
import sys
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from websockets.sync.client import connect

from pages import TIMEOUT, Visitor


@dataclass(frozen=True)
class Answer:
    """What the class answers to a request."""

    status: int
    headers: dict
    body: bytes

    @property
    def json(self):
        return json.loads(self.body)

    @property
    def cookie(self):
        """The cookie that it sets; empty if it sets none."""
        return self.headers.get("set-cookie", "").partition(";")[0]


class Class:
    """A class that is open.

    Args:
        home: the teacher's folder LEARNBLOCK_HOME.
        options: of the command line.
        name: of the class.
        errors: where the class prints what goes wrong; a file.
    """

    def __init__(self, home, *options, name="7b", errors=None):
        self.home = home
        self.name = name
        self.options = options
        self.errors = errors
        self.port = 0
        self.folder = home / "classes" / name
        self._devices = itertools.count(1)
        self.open()

    def open(self):
        self.home.mkdir(parents=True, exist_ok=True)
        command = [sys.executable, "-m", "learnblock", "class", self.name, "--no-browser"]
        self.process = subprocess.Popen(
            [*command, "--host", "127.0.0.1", "--port", str(self.port), *self.options],
            env={**os.environ, "LEARNBLOCK_HOME": str(self.home)},
            # As a teacher does: not from where this checkout is.
            cwd=self.home,
            stdout=subprocess.PIPE,
            stderr=self.errors,
            text=True,
        )
        output = ""
        for line in self.process.stdout:
            output += line
            if match := re.search(r"(https?://\S+:(\d+))/teacher\?key=(\S+)", output):
                self.address, self.port, self.key = match[1], int(match[2]), match[3]
                break
        self.word = re.search(r"Join word +(.+)", output)[1]

    def close(self):
        """End as Ctrl-C does; return the exit status."""
        self.process.send_signal(signal.SIGINT)
        return self._gone()

    def kill(self):
        """End as a crash does."""
        self.process.kill()
        return self._gone()

    def _gone(self):
        status = self.process.wait(TIMEOUT)
        self.process.stdout.close()
        return status

    def ask(self, path, body=None, *, cookie="", method=None, device=None, **headers):
        """Return the answer to a request, which may come from another device in the room."""
        connection = http.client.HTTPConnection(
            "127.0.0.1", self.port, TIMEOUT, source_address=device
        )
        headers = {**headers, **({"Cookie": cookie} if cookie else {})}
        connection.request(method or ("GET" if body is None else "POST"), path, body, headers)
        response = connection.getresponse()
        answer = Answer(
            response.status, {k.lower(): v for k, v in response.getheaders()}, response.read()
        )
        connection.close()
        return answer

    def join(self, name, pictures=None, word=None, device=None):
        """Come in as a child does; return the answer."""
        request = {"word": word or self.word, "name": name, "pictures": pictures}
        request["is_first_name"] = True
        return self.ask("/join", json.dumps(request), device=device)

    def device(self):
        """The address of another device; None where all have the same."""
        # Only Linux has all of these addresses.
        return (f"127.0.1.{next(self._devices)}", 0) if sys.platform == "linux" else None

    def pupil(self, name):
        """Join as a new pupil, on a device of its own."""
        answer = self.join(name, device=self.device())
        assert answer.status == 200, answer
        return Joined(self, name, answer.json["address"], answer.cookie, answer.json["pictures"])

    def teacher(self):
        """The teacher's cookie."""
        answer = self.ask(f"/teacher?key={self.key}")
        assert answer.cookie
        return answer.cookie

    @contextmanager
    def socket(self, path, cookie="", origin=None):
        headers = {"Cookie": cookie} if cookie else {}
        with connect(
            f"ws://127.0.0.1:{self.port}{path}",
            subprotocols=["learnblock"],
            additional_headers=headers,
            origin=origin,
            max_size=None,
            # A page that is not read any more closes at once, too.
            max_queue=None,
            open_timeout=TIMEOUT,
        ) as opened:
            yield Visitor(opened)

    @contextmanager
    def wall(self, path="/wall"):
        with self.socket(path, self.teacher()) as wall:
            yield wall


@dataclass(frozen=True)
class Joined:
    """A pupil with a browser."""

    room: Class
    name: str
    address: str
    cookie: str
    pictures: list = field(default_factory=list)

    @property
    def id(self):
        return self.address.split("/")[1]

    @property
    def folder(self):
        return self.room.folder / "pupils" / self.id

    def ask(self, path, body=None, **headers):
        return self.room.ask(f"/{self.address}{path}", body, cookie=self.cookie, **headers)

    @contextmanager
    def page(self, cookie=None):
        """The pupil's page, or that of whoever has another cookie."""
        with self.room.socket(f"/{self.address}ws", cookie or self.cookie) as page:
            page.hear("Welcome")
            yield page


@contextmanager
def opened(home, *options, **others):
    """A class that is closed at the end."""
    room = Class(home, *options, **others)
    try:
        yield room
    finally:
        if room.process.poll() is None:
            room.close()


def hand_in(page, lesson, step, text=None):
    """Hand in a step of a lesson, with a program of the pupil's own."""
    page.say("StartLesson", lesson=lesson, name="First drive", step=step)
    while page.hear("LessonShown").get("step") != step:
        pass
    if text:
        page.type(text)
    page.say("HandIn")
    while not page.hear("OwnHandIns").get("hand_ins"):
        pass
    return page.last["OwnHandIns"]["hand_ins"]


def graded(room, lesson, step, out):
    """The table that the command line writes of what was handed in."""
    command = [sys.executable, "-m", "learnblock", "grade", "--class", room.name]
    options = ["--lesson", lesson, "--step", str(step), "--only-handed-in", "--out", str(out)]
    subprocess.run(
        [*command, *options],
        env={**os.environ, "LEARNBLOCK_HOME": str(room.home)},
        cwd=room.home,
        check=True,
        capture_output=True,
    )
    return (Path(out) / "results.csv").read_bytes()
