"""A program in its host's thread leaves the trace that it leaves in a process of its own."""

import io
import re
from functools import partial
from threading import Event, Thread

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.errors import DeviceValueError
from learnblock.runtime.ending import How
from learnblock.runtime.host import Host
from learnblock.runtime.inline import InlineWorker, stays_the_same
from learnblock.runtime.link import SocketLink
from learnblock.runtime.messages import Answer, Called, Command, FromChild
from learnblock.runtime.process import ProcessWorker, ThreadWorker
from learnblock.runtime.recorder import record
from learnblock.runtime.run import Run
from learnblock.runtime.trace import Trace
from learnblock.runtime.watcher import Watcher
from listener import Listener
from places import ROOT
from runs import EXAMPLES, FEW, TASKS, able_twin, run_example

NAMES = sorted(path.name for path in EXAMPLES.glob("*.bt"))
TURNS = """\
from learnblock.devices import Base
for number in range(10):
    robot.device(Base).move(number, 1)
    robot.clock.sleep(0.01)
"""
PROGRAMS = {
    "prints": "print('hello')\nprint(1, 2, sep='', end='')",
    "waits": "robot.clock.sleep(0.05)\nprint(robot.time())",
    "uses the robot's time": "import time\ntime.sleep(0.2)\nprint(time.time(), time.monotonic())",
    "draws lots": "import random\nprint(random.random())",
    "fails": "robot.clock.sleep(0.05)\n1 / 0",
    "leaves": "import sys\nsys.exit()",
    "has functions": "def f(x):\n    robot.clock.sleep(x)\nfor x in (0.01, 0.02):\n    f(x)",
    "sends what cannot be sent": "from learnblock.devices import Display\n"
    "robot.device(Display).show_image(2**70)",
    "sends a subclass": "from learnblock.devices import Base\nclass Speed(float):\n"
    "    def __repr__(self):\n        return 'fast'\nrobot.device(Base).move(Speed(3), True)",
    "never ends": "while True:\n    robot.clock.sleep(0.01)",
    "refuses to end": "try:\n    while True:\n        robot.clock.sleep(0.01)\n"
    "finally:\n    print('last words')",
}


@pytest.mark.sample(6)
@pytest.mark.slow
@pytest.mark.spread
@pytest.mark.parametrize("name", NAMES)
def test_an_example_leaves_the_same_trace_in_its_hosts_thread(made, name):
    robot, options = able_twin(name), {"world": TASKS[name][0], "seconds": FEW}
    here = made(name, robot, **options)
    there = run_example(name, robot, worker=ThreadWorker, **options)
    assert here.trace == there.trace
    assert here.report == there.report


@pytest.mark.parametrize("kind", PROGRAMS)
def test_a_program_behaves_as_in_a_process_of_its_own(stage, kind):
    outcomes = []
    for worker in (InlineWorker, ProcessWorker):
        fresh = type(stage)()
        fresh.add(PROGRAMS[kind], worker=worker)
        fresh.host(seconds=0.3).run()
        [result] = fresh.results()
        outcomes.append((result.trace, result.output, result.lines, result.ending))

    assert outcomes[0] == outcomes[1]


def test_the_example_of_the_docs_drives_its_square(monkeypatch, capsys):
    page = (ROOT / "docs" / "running.md").read_text("utf-8")
    [code] = [
        block for block in re.findall(r"```python\n(.*?)```", page, re.S) if "Inline" in block
    ]
    monkeypatch.chdir(EXAMPLES)
    exec(code, {})  # noqa: S102 - our own

    assert 500 < float(capsys.readouterr().out) < 5000


def test_a_program_that_prints_too_much_is_stopped(stage):
    stage.add("while True:\n    print('x' * 100_000)", worker=InlineWorker)
    stage.host().run()

    assert stage.results()[0].ending.how is How.OUTPUT_LIMIT


def test_programs_in_one_thread_have_random_numbers_and_times_of_their_own(stage):
    program = (
        "import random, time\nfrom random import randint\n"
        "for _ in range(3):\n    print(random.random(), randint(1, 99), time.time())\n"
        "    robot.clock.sleep({})"
    )
    outcomes = []
    for worker in (InlineWorker, ProcessWorker):
        fresh = type(stage)()
        for seconds in (0.05, 0.05, 0.02):
            fresh.add(program.format(seconds), worker=worker)
        fresh.host(seconds=1).run()
        outcomes.append([(one.trace, one.output, one.lines) for one in fresh.results()])

    assert outcomes[0] == outcomes[1]


def test_another_thread_of_the_program_cannot_use_the_robot(stage):
    stage.add(
        "import threading\nfound = []\n"
        "def work():\n    try:\n        robot.clock.sleep(1)\n"
        "    except Exception as error:\n        found.append(error.phrase.code)\n"
        "thread = threading.Thread(target=work)\nthread.start()\nthread.join()\nprint(found)",
        worker=InlineWorker,
    )
    stage.host(seconds=1).run()

    assert "run-inline-thread" in stage.results()[0].output


values = st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text()


@given(st.lists(values | st.lists(values, max_size=2), max_size=4))
def test_a_message_that_is_not_encoded_would_have_arrived_as_it_is(args):
    for message in (Called("skill", tuple(args), {}), Command(1, "move", tuple(args))):
        if stays_the_same(message):
            link = SocketLink(None, FromChild)
            length = link.put(message)
            assert repr(link.decode(link._outgoing[4:length])) == repr(message)


@given(st.recursive(values, lambda items: st.lists(items) | st.dictionaries(st.text(), items)))
def test_a_copied_value_is_what_would_have_arrived(value):
    link = InlineWorker().link
    try:
        link.put(Answer((value, ())))
    except DeviceValueError:
        with pytest.raises(DeviceValueError):
            link.copied((value, ()))
    else:
        assert repr(link.copied((value, ()))) == repr(link._queue[0].value)


class Silent(Watcher):
    """Keeps what is printed; without interest in lines, so that nothing is sent as a message."""

    def __init__(self):
        self.text, self.numbers = [], []

    def printed(self, text):
        self.text.append(text)


AT_ONCE = {
    **PROGRAMS,
    "drives, waits and prints": "from learnblock.devices import Base\n"
    "for speed in (1, 2, 2, 2.0, True, 3):\n    robot.device(Base).move(speed, 0)\n"
    "    print(speed)\n    robot.device(Base).move(-0.0, speed)\n    robot.clock.sleep(0.01)",
    "shows the same face again": "from learnblock.devices import Display\n"
    "for _ in range(30):\n    robot.device(Display).show_emotion('joy')",
    "reads what it changes": "from learnblock.devices import Gyroscope\n"
    "print(robot.read(Gyroscope, 'Z_AXIS'))\nrobot.device(Gyroscope, 'Z_AXIS').reset()\n"
    "robot.forget_readings()\nprint(robot.read(Gyroscope, 'Z_AXIS'))",
    "waits between readings": "from learnblock.devices import DistanceSensors\n"
    "for seconds in (0.01, 0.02, 0.07, 0.1, 0.2):\n    robot.clock.sleep(seconds)\n"
    "    print(robot.time(), robot.read(DistanceSensors))",
    "changes a reading of its own": "from learnblock.devices import DistanceSensors\n"
    "robot.read(DistanceSensors)['front'].append(1)\nrobot.forget_readings()\n"
    "print(robot.read(DistanceSensors))",
    "calls functions as skills": "def hop(robot, far=1, *, high=2):\n    pass\n"
    "robot.learn(hop)\nfor far in (1, 1.0, 'a', 'é', [1]):\n    robot.hop(far)\n"
    "robot.hop()\nrobot.hop(high=3)",
    "computes for long": "for _ in range(3000):\n    x = 1",
    "drives with a stopped robot": "from learnblock.devices import Base\n"
    "base = robot.device(Base)\nrobot.stop()\nx = 1\nbase.move(1, 1)\nx = 2",
}


@pytest.mark.parametrize("broken", [(), ("move",), ("read",), ("show_emotion",)])
@pytest.mark.parametrize("kind", AT_ONCE)
def test_what_the_host_does_at_once_is_as_if_it_had_been_sent(stage, kind, broken):
    outcomes = []
    ways = [(InlineWorker, Silent()), (InlineWorker, None), (ThreadWorker, None)]
    for worker, watcher in [*ways, (ThreadWorker, Silent())]:
        fresh = type(stage)()
        fresh.add(AT_ONCE[kind], worker=worker, watcher=watcher, broken=broken)
        fresh.host(seconds=0.3).run()
        [result] = fresh.results()
        outcomes.append((result.trace, result.output, result.ending, result.log))

    assert outcomes[0] == outcomes[1]
    # A thread is interrupted elsewhere, which shows in nothing but the line of its ending.
    assert outcomes[0][0] == outcomes[2][0]
    assert outcomes[2] == outcomes[3]


def test_a_program_that_nobody_looks_at_is_answered_without_a_turn_of_its_host(stage, monkeypatch):
    released = []
    monkeypatch.setattr(Host, "_wake", lambda _, due: released.append(due))
    stage.add("for _ in range(20):\n    robot.clock.sleep(0.01)", watcher=Silent())
    stage.host(seconds=0.3).run()

    assert stage.results()[0].ending.how is How.FINISHED
    assert released == []


@pytest.mark.parametrize("broken", [(), ("read",)])
@pytest.mark.parametrize("kind", AT_ONCE)
def test_robots_that_take_turns_wait_as_if_each_wait_had_been_sent(stage, kind, broken):
    outcomes = []
    for watch in (Silent, Listener):
        fresh = type(stage)()
        for python in (AT_ONCE[kind], TURNS):
            fresh.add(python, worker=InlineWorker, watcher=watch(), broken=broken)
        fresh.host(seconds=0.3).run()
        outcomes.append([(one.trace, one.output, one.ending, one.log) for one in fresh.results()])

    assert outcomes[0] == outcomes[1]


def test_robots_that_take_turns_in_one_thread_send_no_waits(stage, monkeypatch):
    waits = []
    monkeypatch.setattr(Run, "_on_sleep", lambda _, message: waits.append(message))
    for _ in range(2):
        stage.add(TURNS, worker=InlineWorker, watcher=Silent())
    stage.host(seconds=0.3).run()

    assert [one.ending.how for one in stage.results()] == [How.FINISHED] * 2
    assert waits == []


@pytest.mark.parametrize("count", [1, 2])
@pytest.mark.parametrize("worker", [InlineWorker, ThreadWorker])
def test_a_program_whose_run_nobody_looks_at_is_stopped_by_another_thread(stage, worker, count):
    began = Event()

    class Beginning(Silent):
        def printed(self, text):
            super().printed(text)
            began.set()

    loop = "print('begun')\nwhile True:\n    robot.clock.sleep(0.01)"
    for _ in range(count):
        stage.add(loop, worker=worker, watcher=Beginning())
    host = stage.host()
    stopping = Thread(target=lambda: began.wait(10) and host.stop())
    stopping.start()
    host.run()
    stopping.join()

    assert [one.ending.how for one in stage.results()] == [How.STOPPED] * count


def test_steps_of_robots_that_take_turns_stay_in_order(stage):
    traces = []
    for watch in (Silent, Listener):
        fresh = type(stage)()
        file = io.BytesIO()
        for name in ("a", "b"):
            run = fresh.add(TURNS, worker=InlineWorker, watcher=watch())
            run.robot._make_recorder = partial(_recorded, Trace(file), name)
        fresh.host(seconds=0.3).run()
        traces.append(file.getvalue())

    assert traces[0] == traces[1]
    assert traces[0].count(b'"line"') > 50


def _recorded(trace, name, client):
    return record(client, "tiny", trace, {"robot": name})
