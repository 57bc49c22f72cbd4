"""A host believes nothing: no message of a program stops it, or makes it grow or fail."""

import itertools
import os
import resource
import socket
import sys
import threading
from types import SimpleNamespace
from typing import get_args

import msgspec
import pytest

from edges import altered, framed
from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase, can_be_said, languages, translate
from learnblock.running.report import report
from learnblock.runtime import run as runs
from learnblock.runtime.activity import Activity
from learnblock.runtime.containment.scratch import Usage
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.ending import How
from learnblock.runtime.limits import Limits
from learnblock.runtime.lines import MOST_LINES_AT_ONE_TIME
from learnblock.runtime.link import SocketLink
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.messages import FromChild, Steps
from learnblock.runtime.own_files import own_files, quoted
from learnblock.runtime.program import Program
from learnblock.runtime.supervision import MOST_CALLS_AT_ONE_TIME, Supervision
from learnblock.runtime.validation import Validator
from learnblock.runtime.variables import VariableReports
from learnblock.runtime.watcher import Watcher
from learnblock.storage.home import home

KINDS = get_args(FromChild)
#: What fields mean in a program that is honest.
TYPICAL = {
    "module": "learnblock.robots.tiny", "arguments": {}, "device": 0, "function": "move",
    "args": [1.0, 0.0], "skill": "turn", "name": "go", "value": 1, "number": 1, "lines": [1],
    "change": "change-score", "amount": 1.0,
}  # fmt: skip
BEGIN = [["Contained"], ["Connect", "learnblock.robots.tiny", {}]]
BEHIND = ["Ended", None, False, []]
ENDINGS = {How.FINISHED, How.ERROR, How.STOPPED, How.TIME_LIMIT}
PROGRAM = Program("tiny.py", "pass\n" * 9, "pass\n" * 9)


class Sender:
    """A worker that sends what it is given, whatever it is answered."""

    def __init__(self, data):
        self._socket, theirs = socket.socketpair()
        self.link = SocketLink(theirs, FromChild)
        self._thread = threading.Thread(target=self._send, args=(data,), daemon=True)
        self._thread.start()

    def _send(self, data):
        try:
            self._socket.sendall(data)
            self._socket.shutdown(socket.SHUT_WR)
        except OSError:
            return

    def interrupt(self):
        """Do nothing: it ends by itself."""

    def kill(self):
        self.link.close()
        # The next socket may have the number of a closed one, and would be shut down.
        self._thread.join()
        self._socket.close()

    def wait(self, timeout):
        return 0

    def usage(self, limits):
        return Usage()

    def activity(self):
        return Activity(0.0, waits=False)


@pytest.fixture
def said(stage):
    """Return how a run ends in which a program says some messages, and its report is made."""

    def said(*sent, watched=True):
        data = b"".join(map(framed, [*BEGIN, *sent, BEHIND]))
        stage.parts.clear()
        run = stage.add(
            PROGRAM.python,
            header="",
            worker=lambda: Sender(data),
            debugger=Debugger() if watched else None,
            log=RunLog(PROGRAM) if watched else None,
        )
        stage.host(5.0).run()
        done = report(PROGRAM, run, "")
        for language in languages():
            translate(run.ending.phrase, language)
        msgspec.json.encode(msgspec.to_builtins(done, enc_hook=str))
        return run.ending

    return said


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_no_field_of_a_message_stops_its_host_or_makes_it_grow(said, kind):
    said()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    names = {field.name for field in msgspec.structs.fields(kind)}
    known = {name: value for name, value in TYPICAL.items() if name in names}
    for message in altered(kind, **known):
        ending = said(message)
        assert ending.how in ENDINGS, message
        assert can_be_said(ending.phrase), message
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    assert grown < 50 * 1024 * (1 if sys.platform == "linux" else 1024)


FORGED = {
    "a device that the robot lacks": ["Command", 9, "move", [1, 0]],
    "a function that it lacks": ["Ask", 0, "explode", []],
    "a negative device": ["Ask", -1, "read", []],
    "a robot that is not known": ["Connect", "os.path", {}],
    "a second beginning": ["Contained"],
    "a loop that the program lacks": ["Stuck"],
    "a line behind the last": ["Steps", [10**6]],
    "no line": ["Steps", [0]],
    "more lines than at one time": ["Steps", [1] * 1001],
    "a skill without a name": ["Called", "a b", [], {}],
    "a step that is no skill": ["Steps", ["\x1b[2J"]],
    "a device that is not known": ["Missing", "turn", "Nonsense:x"],
    "a wait backwards": ["Sleep", -5, []],
    "a reading of what has none": ["Sleep", 1, [3]],
    "events that nobody keeps": ["Logged", 0, 0, b"\x90"],
    "variables that were not asked for": ["Variables", {}, {}, {}],
    "variables at its end that were not asked for": [
        "Ended", None, False, [], ["Variables", {}, {}, {}]
    ],
    "a pause that was not asked for": ["Line", 1, 0, ["Variables", {}, {}, {}]],
    "a file of the system": ["Ended", [Phrase("x"), [1], "/dev/ptmx", 2], False, []],
    "a file with a zero": ["Ended", [Phrase("x"), [1], "/a\0b", 2], False, []],
    "a file while it is interrupted": ["Interrupted", 1, "/etc/passwd", 1],
    "an error without its values": ["Ended", [Phrase("run-value-too-large"), []], False, []],
    "an error of another code": ["Ended", [Phrase("no-such-code"), []], False, []],
    "an error of its host": ["Ended", [Phrase("run-lost", reason="x"), []], False, []],
    "an error before it began": [
        "Ended", [Phrase("run-not-contained", reason="x"), []], False, []
    ],
    "an error of the grading": ["Ended", [Phrase("grade-no-program"), []], False, []],
    "one of these in another": [
        "Ended",
        [Phrase("run-means", meaning=Phrase("run-lost", reason="x"), error="x"), []],
        False,
        [],
    ],
    "millions of empty maps": ["Send", "x", [{}] * 500_000],
    "a long text": ["Printed", "x" * 10**6],
    "a large log": ["Logged", 0, 0, b"x" * 10**6],
    "a command with a large text": ["Command", 0, "move", ["x" * 10**6]],
    "a list of large lists": ["Command", 0, "move", [[[]] * 10**6]],
}  # fmt: skip


@pytest.mark.parametrize("name", FORGED)
def test_what_cannot_be_true_ends_the_run_as_the_programs_error(said, name):
    ending = said(FORGED[name], watched=False)
    assert (How.ERROR, "run-not-a-message") == (ending.how, ending.phrase.code)


EVENTS = msgspec.msgpack.encode([[0, 5], [18]])


@pytest.mark.parametrize(
    ("batches", "how"),
    [
        ([(5, 9, EVENTS), (9, 9, EVENTS)], How.FINISHED),
        ([(5, 9, EVENTS), (8, 9, EVENTS)], How.ERROR),
        ([(5, 4, EVENTS)], How.ERROR),
        ([(5, 9, b"x")], How.ERROR),
        ([(5, 9, msgspec.msgpack.encode([[99]]))], How.ERROR),
        ([(5, 9, msgspec.msgpack.encode([[1, -5]]))], How.ERROR),
    ],
)
def test_events_of_a_log_have_to_be_in_order_and_in_their_form(said, batches, how):
    assert how is said(*(["Logged", *batch] for batch in batches)).how


def test_a_flood_of_events_ends_its_run(said, monkeypatch):
    # Each batch takes a fifth of a second of the host's time, and none of the program's.
    times = itertools.count(step=0.2)
    monkeypatch.setattr(runs, "thread_time", lambda: next(times))
    ending = said(*[["Logged", 0, 0, EVENTS]] * 40)
    assert ending.phrase.code == "run-not-a-message"


def test_calls_without_end_at_one_moment_are_no_calls():
    robot = SimpleNamespace(client=object(), world=SimpleNamespace(simulation=object()))
    supervision = Supervision(Limits(silence=1.0), robot)
    for _ in range(MOST_CALLS_AT_ONE_TIME):
        supervision.note_call()
    busy = iter(range(100))
    assert supervision.check(lambda: Activity(next(busy), waits=False)) is None
    supervision.note_call()
    supervision.check(lambda: Activity(next(busy), waits=False))
    ending = supervision.check(lambda: Activity(next(busy), waits=False))
    assert ending.how is How.NO_CALL
    supervision.note_time()
    assert supervision.check(lambda: Activity(next(busy), waits=False)) is None


def test_lines_are_limited_at_one_step_of_the_world_however_its_time_passes():
    world = SimpleNamespace(simulation=SimpleNamespace(steps=0))
    robot = SimpleNamespace(world=world)
    validator = Validator(PROGRAM, (), robot, VariableReports(Watcher()), pauses=False, log=False)
    many = Steps((1,) * MOST_LINES_AT_ONE_TIME)
    for step in range(3):
        # No message tells that time passes for a program in its host's thread.
        world.simulation.steps = step
        validator.check(many)
    with pytest.raises(RobotConnectionError):
        validator.check(Steps((1,)))


def test_only_files_of_skills_and_libraries_are_known_and_only_regular_ones_are_read(stage):
    skills, library = home() / "skills", home() / "libraries" / "dance"
    library.mkdir(parents=True)
    skills.mkdir()
    (skills / "waltz.py").write_text("1\n  two\n3\n")
    (library / "steps.py").write_text("left")
    (home() / "secret.py").write_text("secret")
    os.mkfifo(skills / "pipe.py")
    (skills / "link.py").symlink_to(home() / "secret.py")
    (skills / "folder.py").mkdir()
    assert str(home() / "secret.py") not in own_files()
    assert ("two", "left") == (
        quoted(str(skills / "waltz.py"), 2), quoted(str(library / "steps.py"), 1)
    )  # fmt: skip
    for name in ("pipe", "link", "folder", "none"):
        assert quoted(str(skills / f"{name}.py"), 1) == ""
    assert quoted(str(skills / "waltz.py"), 2**32 - 1) == ""
