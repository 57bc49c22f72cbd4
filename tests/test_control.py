"""Control of a run: pause, step, speed, breakpoints and variables, from any thread at any time."""

import itertools
import queue
import threading
from contextlib import contextmanager
from time import monotonic

import pytest

from learnblock import robots, running
from learnblock.errors import LearnBlockError
from learnblock.running import Options, Session
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.messages import Variables
from learnblock.runtime.process import ProcessWorker, ThreadWorker
from learnblock.runtime.program import Program
from learnblock.runtime.watcher import Watcher
from runs import EXAMPLES, TWINS, WORLDS

NAMES = sorted(path.name for path in EXAMPLES.glob("*.bt"))
HEADER = "from learnblock.robots.sim_ebo import Robot\nrobot = Robot()\n"
#: From any order to its effect: some 50 ms on a machine with nothing else to do.
PROMPT = 1.0


class Observer(Watcher):
    """Queues what it is told, for the thread that tests."""

    def __init__(self):
        self.told = queue.Queue()
        self.inputs = queue.Queue()
        self.lines = []

    def state(self, state):
        self.told.put(str(state))

    def held(self, line, variables):
        self.lines.append(line)

    def variables(self, variables):
        self.told.put(variables)

    def input(self, prompt):
        return self.inputs.get(timeout=10)

    def cancel_input(self):
        self.inputs.put(None)

    def wait_for(self, *wanted):
        """The next of these things to be told, within ten seconds."""
        while True:
            told = self.told.get(timeout=10)
            if told in wanted or type(told) in wanted:
                return told


class Playing:
    """A run in a thread of its own."""

    def __init__(self, session, observer):
        self.session, self.observer = session, observer
        self.report = None
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def _run(self):
        self.report = self.session.run()

    def end(self):
        """Wait for its end, and answer its report."""
        self._thread.join(15)
        assert not self._thread.is_alive()
        return self.report


@pytest.fixture
def play():
    """Play a program written in Python after the header; it is stopped at the end of the test."""
    playing = []

    def play(source, *, speed=1.0, debugger=None, worker=ProcessWorker):
        text = HEADER + source
        observer = Observer()
        session = Session(
            Program("program.py", text, text),
            robots.find("sim-ebo"),
            watcher=observer,
            debugger=debugger or Debugger(),
            worker=worker,
        )
        session.set_speed(speed)
        playing.append(Playing(session, observer))
        return playing[-1]

    yield play
    for one in playing:
        one.session.stop()
        one.end()


def begun(playing):
    """Wait until its world goes."""
    playing.observer.wait_for("running")
    while not (playing.session.stage and playing.session.stage.state().time > 0.02):
        assert playing.report is None


def at_rest(stage):
    """Whether the world stands still, looked at for longer than a step."""
    before = stage.state().time
    threading.Event().wait(0.05)
    return stage.state().time == before


def test_a_pause_in_a_long_sleep_holds_the_world_at_once(play):
    playing = play("robot.sleep(60)")
    begun(playing)
    asked = monotonic()
    playing.session.pause()
    assert playing.observer.wait_for("paused")
    assert monotonic() - asked < PROMPT
    assert at_rest(playing.session.stage)


def test_after_a_pause_a_step_goes_on_to_the_next_line(play):
    playing = play("robot.sleep(0.5)\npass\npass")
    begun(playing)
    playing.session.pause()
    playing.observer.wait_for("paused")
    playing.session.step()
    playing.observer.wait_for("held")
    assert playing.observer.lines == [4]
    assert playing.session.stage.state().time == 0.5
    playing.session.step()
    playing.observer.wait_for("held")
    assert playing.observer.lines == [4, 5]


def test_what_is_said_to_a_program_that_has_just_ended_does_not_change_how_it_ended(play):
    made = []

    def worker():
        made.append(ProcessWorker())
        return made[0]

    def printed(text):
        assert text == "the last\n"
        assert made[0].wait(10) == 0
        playing.session.set_breakpoints({1})

    playing = play("print('the last')", debugger=Debugger(paused=True), worker=worker)
    playing.observer.wait_for("held")
    playing.observer.printed = printed
    playing.session.resume()
    assert playing.end().ended == "finished"


def test_a_pause_that_holds_no_line_yet_is_resumed(play):
    playing = play("robot.sleep(0.3)\npass")
    begun(playing)
    playing.session.pause()
    playing.observer.wait_for("paused")
    playing.session.resume()
    assert playing.observer.wait_for("running", "held") == "running"
    assert playing.end().ended == "finished"
    assert playing.observer.lines == []


@pytest.mark.parametrize("worker", [ProcessWorker, ThreadWorker])
def test_a_program_that_computes_is_paused_at_once(play, worker):
    playing = play(
        "robot.sleep(0.05)\nn = 0\nwhile n < 10**9:\n    n += 1\n", worker=worker, speed=None
    )
    begun(playing)
    asked = monotonic()
    playing.session.pause()
    playing.observer.wait_for("held")
    assert monotonic() - asked < PROMPT
    assert playing.observer.lines[0] in {4, 5, 6}


def test_a_breakpoint_set_while_the_program_runs_is_found(play):
    playing = play("while True:\n    robot.sleep(0.02)\n    pass")
    begun(playing)
    playing.session.set_breakpoints([5])
    playing.observer.wait_for("held")
    playing.session.set_breakpoints([])
    playing.session.resume()
    assert playing.observer.wait_for("running", "held") == "running"
    assert playing.observer.lines == [5]


def test_a_breakpoint_on_the_first_line_holds_the_program_before_there_is_a_robot(play):
    playing = play("pass", debugger=Debugger([1]))
    playing.observer.wait_for("held")
    assert playing.session.stage is None
    playing.session.resume()
    assert playing.end().ended == "finished"


def test_a_world_is_not_late_after_a_breakpoint(play):
    playing = play("robot.sleep(0.1)\nrobot.sleep(0.1)", debugger=Debugger([4]))
    playing.observer.wait_for("held")
    threading.Event().wait(0.3)
    playing.session.resume()
    playing.end()
    assert not playing.session.client.simulation.pacing.slipped


def test_a_speed_set_before_there_is_a_robot_is_the_worlds(play):
    playing = play("robot.sleep(0.1)", speed=5)
    playing.end()
    assert playing.session.client.simulation.pacing.factor == 5


def test_a_pause_before_there_is_a_robot_holds_the_world_once_it_is_there(play):
    debugger = Debugger()
    debugger.pause()
    playing = play("robot.sleep(1)", debugger=debugger)
    playing.observer.wait_for("held")
    assert playing.observer.lines == [1]
    playing.session.resume()
    assert playing.end().ended == "finished"


def test_a_stop_ends_a_run_that_is_paused(play):
    playing = play("robot.sleep(60)")
    begun(playing)
    playing.session.pause()
    playing.observer.wait_for("paused")
    asked = monotonic()
    playing.session.stop()
    assert playing.end().ended == "stopped"
    assert monotonic() - asked < PROMPT


def test_a_stop_ends_a_run_that_waits_for_input(play):
    playing = play("input('Name?')\nrobot.sleep(60)")
    playing.observer.wait_for("input")
    playing.session.stop()
    assert playing.end().ended == "stopped"


def test_a_pause_during_input_holds_at_the_line_after_it(play):
    playing = play("name = input('Name?')\nprint(name)")
    playing.observer.wait_for("input")
    playing.session.pause()
    playing.observer.inputs.put("Ada")
    playing.observer.wait_for("held")
    assert playing.observer.lines == [4]


def test_the_states_of_a_run_are_told_in_order(play):
    playing = play("robot.sleep(0.1)\npass", debugger=Debugger([4]), speed=None)
    playing.observer.wait_for("held")
    playing.session.resume()
    playing.end()
    assert playing.observer.told.get(timeout=1) == "running"
    assert playing.observer.told.get(timeout=1) == "ended"


def test_variables_are_told_while_a_program_sleeps_but_only_when_wanted(play):
    playing = play("speed = 7\nrobot.sleep(60)")
    begun(playing)
    assert all(type(told) is str for told in iter_queue(playing.observer.told))
    playing.session.tell_variables(True)
    told = [playing.observer.told.get(timeout=5) for _ in range(3)]
    asked = monotonic()
    assert [one.shared for one in told] == 3 * [{"speed": "7"}]
    playing.observer.told.get(timeout=5)
    assert monotonic() - asked > 0.1


def iter_queue(told):
    while not told.empty():
        yield told.get()


def test_variables_are_told_while_a_program_computes(play):
    playing = play("robot.sleep(0.05)\nn = 0\nwhile n < 10**9:\n    n += 1\n", speed=None)
    begun(playing)
    playing.session.tell_variables(True)
    # What is told first may be from before the counting.
    counts = {None}
    while len(counts) < 3:
        counts.add(playing.observer.told.get(timeout=5).shared.get("n"))


WHENS = """
@robot.when_start
def start():
    pass

@robot.when
def dance():
    robot.sleep(0.1)

@robot.when(lambda: False)
def never():
    pass

dance.activate()
robot.run()
"""


def test_the_whens_are_told_with_their_state_and_time(play):
    playing = play(WHENS)
    begun(playing)
    playing.session.tell_variables(True)
    whens = playing.observer.wait_for(Variables).whens
    assert set(whens) == {"dance", "never"}
    assert whens["never"] == (False, 0.0)
    assert whens["dance"][0] is True


SHY = """
class Shy:
    def __repr__(self):
        print("looked at")
        robot.move_straight()
        robot.sleep(1)
        return "Shy"

shy = Shy()
robot.sleep(1)
pass
"""


@pytest.mark.parametrize("breakpoints", [(), (12,)])
def test_to_look_at_a_variable_neither_moves_the_robot_nor_prints(play, breakpoints):
    quiet = play(SHY, speed=None).end()
    playing = play(SHY, speed=3.0, debugger=Debugger(breakpoints))
    playing.session.tell_variables(True)
    if breakpoints:
        playing.observer.wait_for("held")
        playing.session.resume()
    assert playing.end().trace_sha256 == quiet.trace_sha256


def test_a_description_that_never_ends_can_be_stopped(play):
    source = "class Slow:\n    def __repr__(self):\n        while True: pass\nslow = Slow()\n"
    playing = play(source + "robot.sleep(60)")
    begun(playing)
    playing.session.tell_variables(True)
    playing.session.stop()
    assert playing.end().ended == "stopped"


def test_a_run_without_a_debugger_says_that_it_cannot_be_paused():
    source = Program("program.py", HEADER, HEADER)
    session = Session(source, robots.find("sim-ebo"))
    with pytest.raises(LearnBlockError, match="only a run with a debugger can be paused"):
        session.pause()


# The trace is the same, whoever watches and controls.


class Stepper(Watcher):
    """Steps through so many lines and then resumes."""

    def __init__(self, debugger, steps):
        steppings = itertools.cycle((debugger.step, debugger.step_over))
        self._commands = itertools.islice(steppings, steps)
        self._resume = debugger.resume
        self.held_lines = 0

    def held(self, line, variables):
        self.held_lines += 1
        next(self._commands, self._resume)()


def robot_for(name):
    """A twin that can run the example."""
    source = running.read(EXAMPLES / name)
    for robot in map(robots.find, TWINS):
        if not any(found.severity == "error" for found in running.check(source, robot)):
            return robot
    raise AssertionError(f"no twin runs {name}")


def session_of(name, *, seconds=2.0, **options):
    robot = robot_for(name)
    program = running.program(running.read(EXAMPLES / name), robot)
    return Session(
        program, robot, Options(world=WORLDS.get(name), seed=3, seconds=seconds), **options
    )


@pytest.mark.parametrize("name", NAMES)
def test_an_example_that_is_debugged_leaves_the_trace_of_one_that_is_not(name):
    expected = session_of(name).run()
    debugger = Debugger(paused=True)
    stepper = Stepper(debugger, 60)
    assert session_of(name, debugger=Debugger()).run() == expected
    assert session_of(name, debugger=debugger, watcher=stepper).run() == expected
    assert stepper.held_lines > 5


CAP = "n = 0\nwhile n < 3000:\n    n += 1\nrobot.sleep(0.1)\nn += 1\n"


def test_the_cap_of_lines_at_one_time_holds_for_a_debugged_program_too(play):
    traces = []
    for debugger in (Debugger(), Debugger([6])):
        playing = play("m = 0\n" + CAP, debugger=debugger, speed=None)
        if debugger.control.breakpoints:
            for _ in range(3):
                playing.observer.wait_for("held")
                playing.session.step_over()
            playing.observer.wait_for("held")
            playing.session.set_breakpoints([])
            playing.session.resume()
        traces.append(playing.end().trace_sha256)
    text = HEADER + "m = 0\n" + CAP
    plain = Session(Program("program.py", text, text), robots.find("sim-ebo")).run()
    assert set(traces) == {plain.trace_sha256}


@contextmanager
def hammering(session):
    """Ask for all there is to see, again and again, and pause now and then."""
    over = threading.Event()

    def hammer():
        for look in itertools.count():
            if over.is_set():
                break
            if session.stage:
                session.stage.state(), session.stage.sounds(), session.stage.scene()
            if session.stage and look % 9 == 5:
                session.stage.camera()
            if look % 7 == 3:
                session.pause()
                session.step()
            if look % 5 == 4:
                session.set_speed((None, 40.0, 15.0)[look % 3])
            session.resume()

    thread = threading.Thread(target=hammer)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()


@pytest.mark.parametrize("name", ["tags.bt", "line-ebo.bt"])
def test_ten_runs_watched_paused_and_at_any_speed_leave_one_trace(name):
    expected = session_of(name).run()
    for speed in (None, 4.0, 30.0, 10.0, None, 100.0, 20.0, None, 50.0):
        session = session_of(name, debugger=Debugger())
        session.set_speed(speed)
        session.tell_variables(True)
        with hammering(session):
            assert session.run() == expected
