"""Programs end cleanly, whatever they do."""

import signal
import sys
import threading
from functools import partial

import pytest

from learnblock.client import Client
from learnblock.devices import Device
from learnblock.i18n import Phrase
from learnblock.runtime import supervision
from learnblock.runtime.activity import Activity
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.ending import Ending, How
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.limits import MEGABYTE, Limits
from learnblock.runtime.messages import ShowVariables, Stop
from learnblock.runtime.process import ProcessWorker, ThreadWorker
from learnblock.runtime.watcher import Watcher
from waiting import SECONDS

pytestmark = [pytest.mark.slow, pytest.mark.realtime]

DRIVE = """from learnblock.devices import Base
robot.device(Base).move(100, 0)
robot.clock.sleep(0.1)
"""
STOPPED = [("move", 100.0, 0.0), ("move", 0.0, 0.0), ("disconnect",)]
FINISHED = Phrase("run-finished")
BROKEN = Phrase("OSError: the cable is out")
needs_posix = pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
needs_linux = pytest.mark.skipif(sys.platform != "linux", reason="needs the states of Linux")


@pytest.fixture
def run_here(run):
    """Run a program in a thread, where the claim is not about a process."""
    return partial(run, worker=ThreadWorker)


def endless(lines):
    return DRIVE + lines


ENDINGS = {
    "reaches its end": ("pass", How.FINISHED, FINISHED, 0),
    "leaves": ("import sys\nsys.exit()", How.FINISHED, FINISHED, 0),
    "leaves with a message": ("import sys\nsys.exit('bad')", How.ERROR, "SystemExit: bad", 7),
    "raises": ("1 / 0", How.ERROR, "ZeroDivisionError: division by zero", 6),
    "raises an error with a note": (
        "error = ValueError('wrong')\nerror.add_note('see: page 3')\nraise error",
        How.ERROR,
        "ValueError: wrong",
        8,
    ),
    "raises an error without a message": ("raise KeyError", How.ERROR, "KeyError", 6),
    "raises an error whose message fails": (
        "class Odd(Exception):\n    def __str__(self):\n        1 / 0\nraise Odd",
        How.ERROR,
        Phrase("run-error-without-text", type="Odd", failed="ZeroDivisionError"),
        9,
    ),
    "raises an error of ours": (
        "from learnblock.errors import LearnBlockError\n"
        "raise LearnBlockError('file-too-large', name='\\ud800', limit=10**30)",
        How.ERROR,
        Phrase("file-too-large", name="\\ud800", limit=str(10**30)),
        7,
    ),
    "raises an error that no text can hold": (
        "raise ValueError('\\ud800')",
        How.ERROR,
        "ValueError: \\ud800",
        6,
    ),
    "misspells": (
        "robt",
        How.ERROR,
        Phrase(
            "run-means",
            meaning=Phrase("run-means-name-near", name="robt", near="robot"),
            error="NameError: name 'robt' is not defined",
        ),
        6,
    ),
    "fails in a function": ("def f():\n    1 / 0\nf()", How.ERROR, "ZeroDivisionError: ", 7),
    "recurses": (
        "def f():\n    f()\nf()",
        How.ERROR,
        "RecursionError: maximum recursion depth exceeded",
        7,
    ),
    "interrupts itself": ("raise KeyboardInterrupt", How.ERROR, "KeyboardInterrupt", 6),
    "takes 10 GB": ("x = bytearray(10**10)", How.ERROR, "MemoryError", 6),
    "forks": (
        "import os\nos.fork()",
        How.ERROR,
        Phrase("run-no-processes", event="os.fork"),
        7,
    ),
    "starts a program": (
        "import subprocess\nsubprocess.run(['true'])",
        How.ERROR,
        Phrase("run-no-processes", event="subprocess.Popen"),
        7,
    ),
    "kills itself": (
        "import signal\nsignal.raise_signal(signal.SIGKILL)",
        How.KILLED,
        Phrase("run-killed", signal="SIGKILL"),
        0,
    ),
    "dies of a signal without a name": (
        "import signal\nsignal.raise_signal(signal.SIGRTMIN + 3)",
        How.KILLED,
        Phrase("run-killed", signal=str(signal.SIGRTMIN + 3)),
        0,
    ),
    "terminates itself": (
        "import signal\nsignal.raise_signal(signal.SIGTERM)",
        How.STOPPED,
        Phrase("run-stopped-by-signal"),
        7,
    ),
    "leaves at once": (
        "import os\nos._exit(3)",
        How.KILLED,
        Phrase("run-process-ended", status="3"),
        0,
    ),
    "closes its files": ("import os\nos.closerange(0, 100)\nrobot.time()", How.KILLED, "", 0),
    "closes its files and continues": (
        "import os\nos.closerange(0, 100)\nwhile True: pass",
        How.KILLED,
        Phrase("run-link-closed"),
        0,
    ),
    "raises at exit": (
        "import atexit\natexit.register(lambda: 1 / 0)",
        How.FINISHED,
        FINISHED,
        0,
    ),
    "leaves a thread behind": (
        "import threading\nthreading.Thread(target=threading.Event().wait).start()",
        How.FINISHED,
        FINISHED,
        0,
    ),
    "asks for input that does not come": (
        "input('name? ')",
        How.ERROR,
        Phrase("run-input-ended"),
        6,
    ),
    "reads its standard input": ("import sys\nassert sys.stdin.read() == ''", How.FINISHED, "", 0),
    "stops its robot and uses it again": (
        "robot.stop()\nrobot.device(Base)",
        How.ERROR,
        "the robot has been stopped",
        7,
    ),
}


@needs_posix
@pytest.mark.parametrize("name", ENDINGS)
def test_a_program_ends_with_a_phrase_with_its_robot_stopped_and_no_process_left(run, name):
    source, how, said, line = ENDINGS[name]
    result = run(DRIVE + source)
    if isinstance(said, Phrase):
        assert result.ending.phrase == said
    else:
        # Python's own words are in the last line, below what they mean.
        last = str(result.ending.phrase).rpartition("Python: ")[2]
        assert last.casefold().startswith(said.casefold())
    assert str(result.ending.phrase).count("\n") <= 1
    assert (how, line) == (result.how, result.ending.line)
    assert result.log == STOPPED
    result.wait_until_gone()


ENDLESS = {
    "loops without a call": ("while True:\n    pass", {6, 7}),
    "ignores SIGTERM": (
        "import signal\nsignal.signal(signal.SIGTERM, signal.SIG_IGN)\nwhile True: pass",
        {0},
    ),
    "swallows every exception": (
        "while True:\n    try:\n        while True: pass\n    except: pass",
        {6, 7, 8, 9},
    ),
    "forks past our fence": (
        "import ctypes\nctypes.CDLL(None).fork()\nwhile True: pass",
        {8},
    ),
    "waits for its thread": (
        "from threading import *\nt = Thread(target=Event().wait)\nt.start()\nt.join()",
        {9},
    ),
    "stops itself with SIGSTOP": (
        "import signal\nsignal.raise_signal(signal.SIGSTOP)",
        {0, 7},
    ),
    "prints without end": ("while True: print('x' * 80)", {6}),
}


@needs_posix
@pytest.mark.parametrize("name", ENDLESS)
def test_an_endless_program_is_ended(run, impatient, name):
    source, lines = ENDLESS[name]
    result = run(DRIVE + source, limits=impatient)
    assert result.how in {How.NO_CALL, How.OUTPUT_LIMIT}
    assert result.ending.line in lines
    assert result.log == STOPPED
    result.wait_until_gone()


@needs_posix
@pytest.mark.parametrize("name", ENDLESS)
def test_every_program_ends_when_it_is_stopped(stage, name):
    source, _ = ENDLESS[name]
    run = stage.add(
        DRIVE + "print('go')\n" + source,
        # Nothing else ends it before the test is over.
        limits=Limits(silence=1000, blocked=1000, output=10**12),
        watcher=(watcher := Begun()),
    )
    host = stage.host()
    thread = threading.Thread(target=host.run)
    thread.start()
    assert watcher.begun.wait(SECONDS)
    host.stop()
    thread.join()
    assert run.ending.phrase == Phrase("run-stopped")
    assert run.ending.how == How.STOPPED
    assert run.client.log == STOPPED
    stage.results()[0].wait_until_gone()


class Begun(Watcher):
    def __init__(self):
        self.text, self.numbers = [], []
        self.begun = threading.Event()

    def printed(self, text):
        self.begun.set()


def test_a_program_that_prints_too_much_is_ended(run):
    result = run("for i in range(10**6): print('x' * 99)", limits=Limits(output=20_000))
    assert How.OUTPUT_LIMIT == result.how
    assert result.ending.phrase == Phrase("run-too-much-output", megabytes=20_000 / MEGABYTE)
    assert len(result.output) <= 20_000


def test_ten_megabytes_in_one_print_are_too_much_too(run):
    assert How.OUTPUT_LIMIT == run("print('x' * 10**7)").how


@needs_posix
def test_flushed_output_is_shown_even_if_the_program_dies(run):
    result = run("import os\nprint('here', end='', flush=True)\nos._exit(0)")
    assert result.output == "here"


@needs_posix
def test_output_that_bypasses_the_link_is_not_shown(run, capfd):
    run("import os, sys\nos.write(1, b'sneaky')\nsys.__stdout__.write('sneaky')")
    assert capfd.readouterr().out == ""


@needs_posix
def test_processor_time_is_limited(run):
    result = run("while True: pass", limits=Limits(cpu=1, silence=30))
    assert result.how == How.KILLED
    assert result.ending.phrase == Phrase("run-processor-time", seconds=1)


def test_a_program_that_never_creates_its_robot_is_ended(run):
    result = run("while True: pass", header="", limits=Limits(preparation=0.2))
    assert How.NO_CALL == result.how
    assert result.ending.phrase == Phrase("run-no-robot", seconds=0.2)


@needs_linux
@pytest.mark.parametrize(
    "source",
    ["import os\nos.read(os.pipe()[0], 1)", "import threading\nthreading.Event().wait()"],
)
def test_a_program_that_waits_for_something_else_is_ended(run, source):
    result = run(DRIVE + source, limits=Limits(blocked=0.3))
    assert How.NO_CALL == result.how
    assert result.ending.phrase == Phrase("run-blocked", seconds=0.3)
    assert result.log == STOPPED


class Starved(ProcessWorker):
    """The program of a machine so busy that it gets no processor, as far as anyone can see."""

    def activity(self):
        return Activity(0.0, waits=False)


@needs_linux
@pytest.mark.parametrize(("worker", "how"), [(ProcessWorker, How.NO_CALL), (Starved, How.FINISHED)])
def test_a_program_that_gets_no_processor_is_not_ended(run, worker, how):
    source = "import time as t\nend = t.process_time() + 0.6\nwhile t.process_time() < end: pass"
    limits = Limits(silence=0.1, blocked=0.1)
    assert run(source, limits=limits, worker=worker).how == how


def test_an_error_in_the_python_names_its_line(run_here):
    result = run_here("def f(x:\n    pass")
    assert result.ending == Ending(How.ERROR, Phrase("SyntaxError: '(' was never closed"), 3)


def test_a_stop_that_fails_is_reported_if_nothing_else_went_wrong(run_here):
    result = run_here("", broken={"disconnect"})
    assert How.ERROR == result.how
    assert result.ending.phrase == Phrase("run-robot-not-stopped", reason=BROKEN)


def test_a_stop_that_fails_does_not_hide_an_earlier_error(run_here):
    ending = run_here("1 / 0", broken={"disconnect"}).ending
    assert ending.phrase.values["error"] == "ZeroDivisionError: division by zero"


def test_a_stop_that_fails_in_the_program_is_reported_too(run_here):
    result = run_here("robot.stop()", broken={"disconnect"})
    assert result.ending.phrase == Phrase("run-robot-not-stopped", reason=BROKEN)
    assert result.log.count(("disconnect",)) == 1


def test_motors_that_do_not_stop_are_still_disconnected(run_here):
    assert run_here("", broken={"move"}).log == [("move", 0.0, 0.0), ("disconnect",)]


def test_a_failing_sensor_raises_at_the_line_that_reads_it(run_here):
    result = run_here(
        "from learnblock.devices import DistanceSensors\n\nrobot.read(DistanceSensors)",
        broken={"read"},
    )
    failed = Phrase("run-call-failed", function="read", reason=BROKEN)
    assert result.ending == Ending(How.ERROR, failed, 5)


def test_a_command_that_fails_ends_the_program(run):
    result = run(DRIVE + "while True: pass", broken={"move"})
    assert How.ERROR == result.how
    assert result.ending.phrase == Phrase("run-call-failed", function="move", reason=BROKEN)


@pytest.mark.parametrize("error", [OSError("no such port"), TypeError("no argument `speed`")])
def test_a_robot_that_cannot_be_created_is_reported_at_its_line(run_here, error):
    def fail(module, arguments):
        raise error

    result = run_here("", make_robot=fail)
    assert result.ending.line == 2
    reason = Phrase(f"{type(error).__name__}: {error}")
    assert result.ending.phrase == Phrase("run-robot-not-created", reason=reason)


def test_a_program_has_one_robot_at_a_time(run_here):
    result = run_here("Robot()")
    assert result.ending.phrase == Phrase("run-second-robot")


def test_a_second_robot_may_follow_the_first(run_here):
    result = run_here("robot.stop()\nwith Robot() as robot: print(robot.stopped)")
    assert (How.FINISHED, "False\n") == (result.how, result.output)


def test_a_device_kept_after_the_stop_cannot_be_used(run_here):
    result = run_here(
        "from learnblock.devices import Base\n"
        "base = robot.device(Base)\nrobot.stop()\nbase.move(100, 0)\nrobot.sleep"
    )
    assert result.log == [("move", 0.0, 0.0), ("disconnect",)]
    assert result.ending.phrase == Phrase("run-robot-stopped")


def test_a_gyroscope_reset_is_seen_at_once(run_here):
    result = run_here(
        "from learnblock.devices import Gyroscope\n"
        "gyroscope = robot.device(Gyroscope, 'Z_AXIS')\n"
        "print(gyroscope.read())\ngyroscope.reset()\nprint(gyroscope.read())"
    )
    assert result.output == "90.0\n0.0\n"
    assert [event["do"] for event in result.events if "device" in event] == ["reset", "move"]


def test_a_frame_crosses_to_the_robot_as_a_picture(run_here):
    result = run_here(
        "import numpy\nfrom learnblock.devices import Display\n"
        "robot.device(Display).show_image(numpy.full((2, 3, 3), 7, numpy.uint8))"
    )
    ((_, frame), *_) = result.log
    assert (2, 3, 3) == frame.shape
    assert {"args": ["<array of shape (2, 3, 3)>"]}.items() <= next(
        event for event in result.events if "device" in event
    ).items()


def test_input_comes_from_the_watcher(run_here):
    result = run_here("print('hello', input('name? '))", answers=["Ada"])
    assert result.output == "name? hello Ada\n"


def test_a_sleep_takes_time_of_the_world(run_here):
    assert run_here("robot.clock.sleep(1.234)\nprint(robot.clock.time())").output == "1.24\n"


def test_a_poll_without_a_sleep_moves_the_world(run_here):
    result = run_here("while robot.time() < 0.05: pass\nprint(robot.clock.time())")
    assert result.output == "0.05\n"


def test_a_time_limit_is_not_an_error(run_here):
    result = run_here("n = 0\nwhile True:\n    robot.clock.sleep(0.3)\n    n += 1\n", seconds=1)
    assert result.ending == Ending(How.TIME_LIMIT, Phrase("run-time-limit", seconds=1), 5)
    assert result.ending.well
    assert result.run.recorder.time() == 1.0


def test_a_time_limit_applies_to_a_real_robot_too(run):
    result = run("while True: pass", real=True, seconds=0.2)
    assert result.how == How.TIME_LIMIT


def test_on_a_real_robot_long_silence_is_allowed(run):
    limits = Limits(silence=0.05)
    result = run("n = 0\nfor i in range(2 * 10**5): n += 1", real=True, limits=limits)
    assert result.how == How.FINISHED


class EndsWhenLookedAt(ThreadWorker):
    """A program that sends its last message and ends between our last receive and our check."""

    def wait(self, timeout):
        self._thread.join(5)
        return super().wait(timeout)


def test_the_last_message_of_an_ended_process_is_received(run):
    result = run("robot.clock.sleep(0.2)", real=True, worker=EndsWhenLookedAt)
    assert result.how == How.FINISHED


@pytest.mark.certain
def test_programs_in_one_world_take_turns_in_order(stage):
    shared = Listener()
    for name, period in (("a", 0.2), ("b", 0.1)):
        stage.add(
            f"for i in range(3):\n    robot.clock.sleep({period})\n"
            f"    print('{name}', robot.clock.time())",
            label={"robot": name},
            watcher=shared,
            worker=ThreadWorker,
        )
    stage.host().run()
    assert shared.text == [
        "b 0.1\n", "a 0.2\n", "b 0.2\n", "b 0.3\n", "a 0.4\n", "a 0.6\n",
    ]  # fmt: skip


class Listener(Watcher):
    def __init__(self):
        self.text, self.numbers = [], []

    def printed(self, text):
        self.text.append(text)


def test_a_program_that_was_ended_does_not_delay_the_others(stage, impatient):
    stage.add("while True: pass", limits=impatient)
    stage.add("robot.clock.sleep(5)\nprint(robot.clock.time())", limits=impatient)
    stage.host().run()
    first, second = stage.results()
    assert (How.NO_CALL, How.FINISHED) == (first.how, second.how)
    assert second.output == "5.0\n"


class GoneAtTheEnd(ThreadWorker):
    """A program that can't be looked at once it has ended, as a process with its folder."""

    ended = False

    def kill(self):
        self.ended = True
        super().kill()

    def usage(self, limits):
        assert not self.ended
        return super().usage(limits)


def test_an_ended_program_is_not_looked_at_while_the_others_go_on(stage, monkeypatch):
    monkeypatch.setattr(supervision, "USAGE_PERIOD", 0.0)
    stage.add("print('bye')", worker=GoneAtTheEnd)
    stage.add("robot.clock.sleep(500)", worker=ThreadWorker)
    stage.host().run()
    assert [result.how for result in stage.results()] == [How.FINISHED, How.FINISHED]


class EndedWhenAsked(ThreadWorker):
    """A program that is ended while it waits, at the moment when it is asked for its variables."""

    def __init__(self):
        super().__init__()
        send = self.link.send
        self.link.send = lambda message: send(Stop() if message == ShowVariables() else message)


def test_a_program_that_is_ended_while_its_variables_are_read_ends_once(stage):
    class Reading(Listener):
        def tick(self):
            run.variables.enabled = run.wake is not None

    run = stage.add("robot.clock.sleep(500)", worker=EndedWhenAsked, watcher=Reading())
    stage.host().run()
    assert run.ending.phrase == Phrase("run-stopped-by-signal")


class LastVariables(Watcher):
    """Keeps the variables that were reported last."""

    def variables(self, variables):
        self.last = variables.shared


@pytest.mark.parametrize("worker", [ThreadWorker, ProcessWorker])
@pytest.mark.parametrize("ending", ["", "raise ValueError", "sys.exit()"])
def test_the_variables_of_a_program_are_reported_as_they_are_at_its_end(stage, worker, ending):
    watcher = LastVariables()
    run = stage.add(
        f"import sys\ncount = 0\nrobot.clock.sleep(1)\ncount = 7\n{ending}",
        worker=worker,
        watcher=watcher,
    )
    run.variables.enabled = True
    stage.host().run()
    assert watcher.last == {"count": "7"}


PROGRAM = """
import random, time
from learnblock.devices import Base, DistanceSensors

def drive(speed):
    robot.device(Base).move(speed, 0)
    time.sleep(0.25)

for speed in range(3):
    drive(speed * 10)
    print(random.random(), robot.read(DistanceSensors), [n * n for n in range(3)])
print(object(), time.time())
"""


@pytest.mark.certain
def test_a_trace_is_the_same_every_time_in_a_process_and_in_a_thread(stage):
    traces = []
    for worker in (None, None, ThreadWorker):
        fresh = type(stage)()
        fresh.add(PROGRAM, **({"worker": worker} if worker else {}))
        fresh.host().run()
        (result,) = fresh.results()
        assert result.how == How.FINISHED, result.ending
        traces.append(result.trace.replace(b" at 0x", b" at "))
    addresses = [trace.split(b"object object at ")[0] for trace in traces]
    assert addresses[0] == addresses[1] == addresses[2]


def test_nothing_is_recorded_after_the_robot_was_stopped(run_here):
    result = run_here("robot.stop()\nprint('bye')")
    assert [key for event in result.events for key in event][-2:] == ["t", "end"]
    assert b"bye" not in result.trace
    assert result.output == "bye\n"


def test_a_programs_module_is_found_next_to_it(run, tmp_path):
    (tmp_path / "helper.py").write_text("def greet(): print('hello')\n")
    assert run("from helper import greet\ngreet()", folder=str(tmp_path)).output == "hello\n"


def test_third_party_robots_come_from_their_own_modules(run_here):
    header = "from acme.rover import Robot\nrobot = Robot()\n"
    result = run_here("print(robot.stopped)", header=header, robots=("acme.rover",))
    assert result.output == "False\n"


@pytest.mark.certain
def test_lines_reach_the_watcher_and_the_trace_in_order(run_here):
    result = run_here("x = 1\nfor i in range(2):\n    x += i\nrobot.time()")
    assert [3, 4, 5, 4, 5, 4, 6] == result.lines
    assert result.lines == [event["line"] for event in result.events if "line" in event]


def test_lines_at_one_time_are_limited(run_here):
    result = run_here("for i in range(5000):\n    x = i\nrobot.time()")
    assert 1000 == len(result.lines)


def test_an_endless_loop_of_skills_without_a_call_is_ended(run, impatient, tmp_path):
    skills = tmp_path / "home" / "skills"
    skills.mkdir(parents=True)
    (skills / "mine.py").write_text("def ponder(robot):\n    return 42\n")
    result = run("while True: robot.ponder()", limits=impatient)
    assert How.NO_CALL == result.how


def test_an_endless_loop_in_a_skill_of_the_user_s_is_stopped_with_its_line(
    run, impatient, tmp_path
):
    skills = tmp_path / "home" / "skills"
    skills.mkdir(parents=True)
    (skills / "mine.py").write_text("def ponder(robot):\n    while True:\n        x = 1\n")
    result = run("x = 1\nrobot.ponder()", limits=impatient)
    assert (How.NO_CALL, 4) == (result.how, result.ending.line)
    assert str(skills / "mine.py") == result.ending.file
    assert result.ending.file_line in {2, 3}


def test_ending_a_run_twice_does_nothing(run_here):
    result = run_here("pass")
    result.run.end()
    assert result.log.count(("disconnect",)) == 1


def test_memory_of_other_sizes_may_be_allowed(run):
    assert run("x = bytearray(10**8)", limits=Limits(memory=2048 * MEGABYTE)).how == How.FINISHED


@needs_posix
def test_an_interrupted_host_leaves_nothing_behind(stage):
    class Interrupting(Watcher):
        def printed(self, text):
            signal.raise_signal(signal.SIGINT)

    # The second print arrives while the first interrupt is being handled.
    stage.add(DRIVE + "print(1)\nprint(2)\nwhile True: pass", watcher=Interrupting())
    with pytest.raises(KeyboardInterrupt):
        stage.host().run()
    assert stage.parts[0][0].client.log == STOPPED
    assert not any(worker.wait(0) is None for worker in stage.workers)


def test_output_before_a_program_was_ended_is_shown_and_recorded(run, impatient):
    result = run("print('a')\nprint('b')\nwhile True: pass", limits=impatient)
    assert result.output == "a\nb\n"
    assert ["a", "b"] == [event["print"] for event in result.events if "print" in event]
    assert [3, 4, 5] == result.lines[:3]


def test_a_debugged_loop_without_a_call_is_ended_too(run, impatient):
    result = run("n = 0\nwhile True:\n    n += 1", limits=impatient, debugger=Debugger())
    assert How.NO_CALL == result.how


def test_a_device_of_a_type_that_programs_cannot_reach_is_named(run_here):
    class Gripper(Device):
        pass

    class Rover(Client):
        def connect(self):
            self.add(Gripper(close=bool))

    result = run_here("", make_robot=lambda module, arguments: Rover(skills=[]))
    assert result.ending.phrase.code == "run-unknown-device"
    assert result.ending.phrase.values["device"] == "Gripper"


@needs_posix
def test_the_size_of_a_file_is_limited(run):
    result = run("open('big', 'wb').write(bytes(10**6))", limits=Limits(file_size=1000))
    assert str(result.ending.phrase).startswith("OSError: [Errno 27]")


@needs_posix
def test_the_number_of_open_files_is_limited(run):
    result = run("files = [open('/dev/null') for _ in range(100)]")
    assert str(result.ending.phrase).startswith("OSError: [Errno 24]")


@pytest.mark.parametrize(
    "argument", ["10**30", "'\\ud800'", "[[[[[]]]]]", "{(1, 2): 3}", "object()"]
)
def test_an_argument_that_cannot_be_sent_is_recorded_by_its_description(run_here, argument):
    result = run_here(f"robot.say_Text({argument})\nrobot.clock.sleep(1)\nprint('on')")
    assert (How.FINISHED, "on\n") == (result.how, result.output)
    assert ["say_Text"] == [event["call"] for event in result.events if "call" in event]
    assert result.run.recorder.missed == {("say_Text", "Speaker:ROBOT"): 1}


def test_a_watcher_has_a_turn_while_a_program_waits_for_its_world(stage):
    class Ticking(Watcher):
        ticks = 0
        text = ()
        numbers = ()

        def tick(self):
            self.ticks += 1
            if self.ticks == 3:
                run.stop(Ending(How.STOPPED, Phrase("run-stopped")))

    run = stage.add("robot.clock.sleep(1e6)\n", worker=ThreadWorker, watcher=Ticking())
    stage.host().run()
    assert run.ending.how is How.STOPPED
    assert 0 < stage.world.steps < 1e8


@pytest.mark.certain
@pytest.mark.parametrize("worker", [InlineWorker, ThreadWorker])
def test_a_watcher_has_its_turns_at_the_same_times_of_a_world_however_fast_it_is(stage, worker):
    class Ticking(Listener):
        def tick(self):
            # While a program computes, a watcher has turns by the wall clock.
            if run.wake is not None:
                steps.append(stage.world.steps)

    steps = []
    run = stage.add(
        "robot.clock.sleep(0.1)\nrobot.clock.sleep(0.06)\n", worker=worker, watcher=Ticking()
    )
    stage.host().run()
    assert steps == [4, 8, 10, 14, 16]
