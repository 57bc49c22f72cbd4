"""Several programs in one run, as docs/games.md describes it."""

import io
import json
import threading
from dataclasses import replace
from itertools import combinations
from math import dist
from pathlib import Path

import pytest

from learnblock import robots, running
from learnblock.errors import WorldError
from learnblock.i18n import Phrase
from learnblock.running import Job, Options
from learnblock.running.robot_names import robot_names
from learnblock.running.team import TeamRun
from learnblock.runtime.ending import Ending, How
from learnblock.runtime.watcher import Watcher

pytestmark = pytest.mark.slow

DRIVE = """\
from learnblock.robots.sim_ebo import Robot

robot = Robot()
robot.move_straight(60)
robot.sleep(2)
"""
WAIT = DRIVE.replace("move_straight(60)", "stop_bot()")
KILL = DRIVE + "import signal\nsignal.raise_signal(signal.SIGKILL)\n"
FAIL = DRIVE + "1 / 0\n"
FOREVER = WAIT + "while True:\n    robot.sleep(1)\n"
#: A robot with its own clock, as a real one has.
CART = """\
from learnblock.client import Client
from learnblock.devices import Base


class Robot(Client):
    def connect(self):
        self.moves = []
        self.add(Base(move=lambda *speeds: self.moves.append(speeds)))
"""


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    """A user's folder with a real robot, called cart."""
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    (tmp_path / "robots").mkdir()
    (tmp_path / "robots" / "cart.py").write_text(CART)
    return tmp_path


def job(python, robot="sim-ebo"):
    """A run of a program in an empty world."""
    entry = robots.find(robot)
    source = running.source_of(Path("program.py"), python, is_python=True)
    return Job(running.program(source, entry), entry, Options(world="empty"))


def play(jobs, watch=lambda _: Watcher(), **options):
    """Run programs together; return the run, its report and its trace."""
    trace = io.BytesIO()
    session = TeamRun(chosen(jobs, **options), trace=trace, watch=watch)
    report = session.run()
    return session, report, [json.loads(line) for line in trace.getvalue().splitlines()]


def chosen(jobs, **options):
    """The runs with other options."""
    return {
        name: replace(job, options=replace(job.options, **options)) for name, job in jobs.items()
    }


@pytest.mark.parametrize(
    ("wishes", "names"),
    [
        (["a", "b"], ["a", "b"]),
        (["a", "b", "a"], ["a-1", "b", "a-2"]),
        (["a", "a-1", "a"], ["a-2", "a-1", "a-3"]),
    ],
)
def test_a_robot_is_called_like_its_program_with_a_number_if_needed(wishes, names):
    assert names == list(robot_names(wishes))


def test_programs_in_one_world_leave_one_trace_that_is_the_same_every_time():
    team = {"a": job(DRIVE), "b": job(DRIVE, "sim-thymio"), "c": job(WAIT, "sim-ev3")}
    _, report, trace = play(team, seed=5)
    assert play(team, seed=5)[1].trace_sha256 == report.trace_sha256
    assert {"a", "b", "c"} == {line["robot"] for line in trace}
    assert ["a", "b", "c"] == [line["robot"] for line in trace if "run" in line]
    driven = {name: own.distance for name, own in report.robots.items()}
    assert driven["a"] > 100
    assert driven["b"] > 100
    assert driven["c"] < 1


def test_thirty_robots_start_apart_from_each_other():
    session = TeamRun({f"one-{number}": job(WAIT) for number in range(30)})
    bodies = session.simulation.world.robots
    places = [(body.pose[0], body.pose[1]) for body in bodies.values()]
    reach = bodies["one-0"].description.body.reach
    assert len(places) == 30
    assert all(dist(a, b) > 2 * reach for a, b in combinations(places, 2))


def test_a_world_without_room_is_refused_before_any_program_starts(home):
    (home / "worlds").mkdir()
    (home / "worlds" / "closet.toml").write_text("[floor]\nsize = [300, 300]\n")
    team = {f"one-{number}": job(WAIT) for number in range(9)}
    with pytest.raises(WorldError) as refused:
        TeamRun(chosen(team, world="closet"))
    assert refused.value.diagnostics[0].message == Phrase("world-no-room", world="closet")


@pytest.mark.parametrize(("python", "how"), [(KILL, How.KILLED), (FAIL, How.ERROR)])
def test_the_others_go_on_when_a_program_is_lost(python, how):
    _, report, _ = play({"lost": job(python), "other": job(DRIVE + "robot.sleep(3)\n")})
    lost, other = report.robots.values()
    assert (lost.ended, other.ended) == (how, How.FINISHED)
    assert (lost.time, other.time) == (2.0, 5.0)


def test_a_program_that_is_stopped_alone_wakes_no_other():
    team = {"first": job(FOREVER), "second": job(WAIT + "print(robot.time())\n")}
    printed = []

    class Stopping(Watcher):
        def tick(self):
            session._runs["first"].stop(Ending(How.STOPPED, Phrase("run-stopped")))

    class Printing(Watcher):
        def printed(self, text):
            printed.append(text)

    session = TeamRun(team, watch=lambda name: Stopping() if name == "first" else Printing())
    session.run()
    assert printed == ["2.0\n"]


def test_stopping_ends_all_programs_and_their_motors():
    begun = threading.Event()

    class Begun(Watcher):
        def printed(self, text):
            begun.set()

    endless = DRIVE + "print('go')\nwhile True:\n    robot.sleep(1)\n"
    team = {"a": job(endless), "b": job(endless, "cart")}
    session = TeamRun(chosen(team, pace="real"), watch=lambda _: Begun())
    reports = []
    thread = threading.Thread(target=lambda: reports.append(session.run()))
    thread.start()
    assert begun.wait(20)
    session.stop()
    thread.join(5)
    assert [How.STOPPED, How.STOPPED] == [own.ended for own in reports[0].robots.values()]
    assert session.client("b").moves[-1] == (0.0, 0.0)


def test_a_run_with_a_real_robot_has_no_hash_and_its_trace_says_why():
    team = {"twin": job(DRIVE), "cart": job(DRIVE.replace("2", "0.1"), "cart")}
    session, report, trace = play(team, pace=20)
    assert [How.FINISHED, How.FINISHED] == [own.ended for own in report.robots.values()]
    assert report.trace_sha256 is None
    assert [False, False] == [one["run"]["deterministic"] for one in trace if "run" in one]
    assert session.client("cart").moves[-1] == (0.0, 0.0)


TELL = """\
from learnblock.robots.sim_ebo import Robot

robot = Robot()
for number in range(3):
    robot.send("number", [NAME, number])
    robot.sleep(0.5)
"""
HEAR = """\
from learnblock.robots.sim_ebo import Robot

robot = Robot()


@robot.when(lambda: robot.received("number"))
def number():
    print(round(robot.time(), 2), robot.message_value("number"))


@robot.when(lambda: robot.elapsedTime(1.5))
def end():
    robot.stop()


robot.run()
"""


def test_messages_reach_the_others_in_a_fixed_order():
    printed = []

    class Printing(Watcher):
        def printed(self, text):
            printed.append(text)

    one, two = (job(TELL.replace("NAME", repr(name))) for name in ("one", "two"))
    team = {"one": one, "hear": job(HEAR), "two": two}
    _, _, trace = play(team, watch=lambda _: Printing())
    said = [line.split(" ", 1)[1].strip() for line in printed]
    assert said == [f"['{name}', {number}]" for number in range(3) for name in ("one", "two")]
    sent = [line for line in trace if "send" in line]
    assert sent[0] == {"t": 0.0, "send": "number", "value": ["one", 0], "robot": "one"}
    assert len(sent) == 6


def test_a_message_is_read_a_step_after_it_was_sent_whoever_is_first():
    ask = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n" + (
        "while not robot.received('number'):\n    robot.sleep(0.01)\nprint(robot.time())\n"
    )
    printed = []

    class Printing(Watcher):
        def printed(self, text):
            printed.append(text)

    team = {"before": job(ask), "tell": job(TELL.replace("NAME", "1")), "after": job(ask)}
    play(team, watch=lambda _: Printing())
    assert printed == ["0.01\n", "0.01\n"]


def test_real_and_simulated_robots_send_each_other_messages():
    ask = DRIVE.replace("robot.sleep(2)\n", "") + (
        "robot.send('hello', 'from NAME')\n"
        "while not robot.received('hello'):\n    robot.sleep(0.05)\n"
        "print(robot.message_value('hello'))\nrobot.sleep(0.3)\n"
    )
    printed = []

    class Printing(Watcher):
        def printed(self, text):
            printed.append(text)

    team = {
        "twin": job(ask.replace("NAME", "twin")),
        "cart": job(ask.replace("NAME", "cart"), "cart"),
    }
    _, report, _ = play(team, pace="real", seconds=20, watch=lambda _: Printing())
    assert [How.FINISHED, How.FINISHED] == [own.ended for own in report.robots.values()]
    assert sorted(printed) == ["from cart\n", "from twin\n"]


def test_a_message_that_is_too_large_ends_its_program_at_its_line():
    python = WAIT + "robot.send('go', 'x' * 5000)\n"
    _, report, _ = play({"big": job(python), "other": job(DRIVE)})
    big, other = report.robots.values()
    assert (big.ended, other.ended) == (How.ERROR, How.FINISHED)
    assert big.error["line"] == 6
    assert big.error["message"].code == "robot-message-too-large"
