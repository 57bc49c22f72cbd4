"""Control of a run: pause, step, speed, breakpoints and variables, from any thread at any time."""

import itertools
import queue
import threading
from contextlib import contextmanager

import pytest

from learnblock import robots, running
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.running import Job, Options, ProgramRun
from learnblock.runtime import variables
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.messages import Variables
from learnblock.runtime.process import ProcessWorker, ThreadWorker
from learnblock.runtime.program import Program
from learnblock.runtime.watcher import Watcher
from learnblock.simulator.physics import DT
from learnblock.testing import VirtualClock
from runs import EXAMPLES, TASKS, able_twin
from waiting import SECONDS, wait_for

NAMES = sorted(path.name for path in EXAMPLES.glob("*.bt"))
HEADER = "from learnblock.robots.sim_ebo import Robot\nrobot = Robot()\n"

pytestmark = [pytest.mark.spread, pytest.mark.realtime]


class Observer(Watcher):
    """Queues the notifications for the thread of the test."""

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
        return self.inputs.get(timeout=SECONDS)

    def cancel_input(self):
        self.inputs.put(None)

    def wait_for(self, *wanted):
        """Return the next of these notifications."""
        while True:
            told = self.told.get(timeout=SECONDS)
            if told in wanted or type(told) in wanted:
                return told


class Playing:
    """A run in its own thread."""

    def __init__(self, run, observer):
        self.run, self.observer = run, observer
        self.report = None
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def _run(self):
        self.report = self.run.run()

    def end(self):
        """Wait until it ends, and return its report."""
        self._thread.join(SECONDS)
        assert not self._thread.is_alive()
        return self.report


@pytest.fixture
def play():
    """Play a program written in Python after the header; it is stopped at the end of the test."""
    playing = []

    def play(source, *, speed=1.0, debugger=None, worker=ProcessWorker):
        text = HEADER + source
        observer = Observer()
        run = ProgramRun(
            Job(Program("program.py", text, text), robots.find("sim-ebo")),
            watcher=observer,
            debugger=debugger or Debugger(),
            worker=worker,
            monitored=True,
        )
        run.set_speed(speed)
        playing.append(Playing(run, observer))
        return playing[-1]

    yield play
    for one in playing:
        one.run.stop()
        one.end()


def begun(playing, time=0.04):
    """Wait until its world has run for this time, in seconds."""
    playing.observer.wait_for("running")
    wait_for(
        lambda: playing.run.monitor and playing.run.monitor.state().time > time - DT / 2,
        f"its world has run for {time} s",
    )


def at_rest(stage):
    """Return whether the world is paused; it may still finish the step in progress."""
    before = stage.state().time
    threading.Event().wait(0.1)
    return stage.state().time <= before + 1.5 * DT


def test_a_pause_in_a_long_sleep_pauses_the_world_at_once(play):
    playing = play("robot.sleep(60)")
    begun(playing)
    playing.run.pause()
    assert playing.observer.wait_for("paused")
    assert at_rest(playing.run.monitor)
    assert playing.run.monitor.state().time < 30


def test_after_a_pause_a_step_runs_to_the_next_line(play):
    playing = play("robot.sleep(60)\npass\npass")
    begun(playing)
    playing.run.pause()
    playing.observer.wait_for("paused")
    playing.run.set_speed(None)
    playing.run.step()
    playing.observer.wait_for("held")
    assert playing.observer.lines == [4]
    assert playing.run.monitor.state().time == 60
    playing.run.step()
    playing.observer.wait_for("held")
    assert playing.observer.lines == [4, 5]


def test_a_message_to_a_program_that_has_just_ended_does_not_change_its_ending(play):
    made = []

    def worker():
        made.append(ProcessWorker())
        return made[0]

    def printed(text):
        assert text == "the last\n"
        assert made[0].wait(SECONDS) == 0
        playing.run.set_breakpoints({1})

    playing = play("print('the last')", debugger=Debugger(paused=True), worker=worker)
    playing.observer.wait_for("held")
    playing.observer.printed = printed
    playing.run.resume()
    assert playing.end().ended == "finished"


def test_a_pause_is_resumed_before_it_reaches_a_line(play):
    playing = play("robot.sleep(60)\npass")
    begun(playing)
    playing.run.pause()
    playing.observer.wait_for("paused")
    playing.run.resume()
    assert playing.observer.wait_for("running", "held") == "running"
    playing.run.set_speed(None)
    assert playing.end().ended == "finished"
    assert playing.observer.lines == []


@pytest.mark.parametrize("worker", [ProcessWorker, ThreadWorker])
def test_a_busy_program_is_paused_at_once(play, worker):
    playing = play(
        "robot.sleep(0.05)\nn = 0\nwhile n < 10**9:\n    n += 1\n", worker=worker, speed=None
    )
    # A pause during the sleep would hold the world, and the program with it.
    begun(playing, 0.05)
    playing.run.pause()
    playing.observer.wait_for("held")
    assert playing.observer.lines[0] in {4, 5, 6}


def test_a_breakpoint_set_while_the_program_runs_is_found(play):
    playing = play("while True:\n    robot.sleep(0.02)\n    pass")
    begun(playing)
    playing.run.set_breakpoints([5])
    playing.observer.wait_for("held")
    playing.run.set_breakpoints([])
    playing.run.resume()
    assert playing.observer.wait_for("running", "held") == "running"
    assert playing.observer.lines == [5]


def test_a_breakpoint_on_the_first_line_pauses_the_program_before_it_has_a_robot(play):
    playing = play("pass", debugger=Debugger([1]))
    playing.observer.wait_for("held")
    assert playing.run.monitor is None
    playing.run.resume()
    assert playing.end().ended == "finished"


def test_a_world_is_not_late_after_a_breakpoint(play):
    playing = play("robot.sleep(0.1)\nrobot.sleep(0.1)", debugger=Debugger([3, 4]))
    playing.observer.wait_for("held")
    pacing = playing.run.client.simulation.pacing
    clock = VirtualClock()
    pacing._clock, pacing._changed.wait = clock.time, clock.sleep
    playing.run.resume()
    playing.observer.wait_for("held")
    clock.sleep(0.3)
    playing.run.resume()
    playing.end()
    assert not pacing.slipped


def test_a_speed_set_before_there_is_a_robot_is_the_worlds(play):
    playing = play("robot.sleep(0.1)", speed=5)
    playing.end()
    assert playing.run.client.simulation.pacing.factor == 5


def test_a_pause_before_there_is_a_robot_pauses_its_world_too(play):
    debugger = Debugger()
    debugger.pause()
    playing = play("robot.sleep(1)", debugger=debugger)
    playing.observer.wait_for("held")
    assert playing.observer.lines == [1]
    playing.run.resume()
    assert playing.end().ended == "finished"


def test_a_stop_ends_a_run_that_is_paused(play):
    playing = play("robot.sleep(60)")
    begun(playing)
    playing.run.pause()
    playing.observer.wait_for("paused")
    playing.run.stop()
    assert playing.end().ended == "stopped"
    assert playing.report.time < 30


def test_a_stop_ends_a_run_waiting_for_input(play):
    playing = play("input('Name?')\nrobot.sleep(60)")
    playing.observer.wait_for("input")
    playing.run.stop()
    assert playing.end().ended == "stopped"


def test_a_pause_during_input_pauses_at_the_next_line(play):
    playing = play("name = input('Name?')\nprint(name)")
    playing.observer.wait_for("input")
    playing.run.pause()
    playing.observer.inputs.put("Ada")
    playing.observer.wait_for("held")
    assert playing.observer.lines == [4]


def test_the_states_of_a_run_are_reported_in_order(play):
    playing = play("robot.sleep(0.1)\npass", debugger=Debugger([4]), speed=None)
    playing.observer.wait_for("held")
    playing.run.resume()
    playing.end()
    assert playing.observer.told.get(timeout=SECONDS) == "running"
    assert playing.observer.told.get(timeout=SECONDS) == "ended"


def test_variables_are_reported_while_a_program_sleeps_but_only_if_enabled(play, monkeypatch):
    playing = play("speed = 7\nrobot.sleep(60)")
    begun(playing)
    assert all(type(told) is str for told in iter_queue(playing.observer.told))
    world, told = playing.run.client.simulation.world, playing.observer.told
    # Measured in the world's time, because reports arrive late on a busy machine.
    monkeypatch.setattr(variables, "monotonic", lambda: world.time)
    playing.observer.variables = lambda found: told.put((world.time, found.shared))
    playing.run.report_variables(enabled=True)
    times, found = zip(*(told.get(timeout=SECONDS) for _ in range(3)), strict=True)
    assert found == 3 * ({"speed": "7"},)
    assert all(later - earlier > 0.1 for earlier, later in itertools.pairwise(times))


def iter_queue(told):
    while not told.empty():
        yield told.get()


def test_variables_are_reported_while_a_program_is_busy(play):
    playing = play("robot.sleep(0.05)\nn = 0\nwhile n < 10**9:\n    n += 1\n", speed=None)
    begun(playing)
    playing.run.report_variables(enabled=True)
    # The first notification may date from before the loop.
    counts = {None}
    while len(counts) < 3:
        counts.add(playing.observer.told.get(timeout=SECONDS).shared.get("n"))


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


def test_the_whens_are_reported_with_their_state_and_time(play):
    playing = play(WHENS)
    begun(playing)
    playing.run.report_variables(enabled=True)
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


@pytest.mark.certain
@pytest.mark.parametrize("breakpoints", [(), (12,)])
def test_inspecting_a_variable_neither_moves_the_robot_nor_prints(play, breakpoints):
    quiet = play(SHY, speed=None).end()
    playing = play(SHY, speed=3.0, debugger=Debugger(breakpoints))
    playing.run.report_variables(enabled=True)
    if breakpoints:
        playing.observer.wait_for("held")
        playing.run.resume()
    assert playing.end().trace_sha256 == quiet.trace_sha256


def test_a_description_that_never_ends_can_be_stopped(play):
    source = "class Slow:\n    def __repr__(self):\n        while True: pass\nslow = Slow()\n"
    playing = play(source + "robot.sleep(60)")
    begun(playing)
    playing.run.report_variables(enabled=True)
    playing.run.stop()
    assert playing.end().ended == "stopped"


def test_pausing_without_a_debugger_is_reported():
    program = Program("program.py", HEADER, HEADER)
    run = ProgramRun(Job(program, robots.find("sim-ebo")))
    with pytest.raises(LearnBlockError) as refused:
        run.pause()
    assert refused.value.phrase == Phrase("run-no-debugger")


# The trace stays the same however the run is watched and controlled.


class Stepper(Watcher):
    """Step through this many lines and then resume."""

    def __init__(self, debugger, steps):
        steppings = itertools.cycle((debugger.step, debugger.step_over))
        self._commands = itertools.islice(steppings, steps)
        self._resume = debugger.resume
        self.held_lines = 0

    def held(self, line, variables):
        self.held_lines += 1
        next(self._commands, self._resume)()


CONDITIONS = {"seed": 3, "seconds": 1.0}


def session_of(name, **options):
    robot = robots.find(able_twin(name))
    program = running.program(running.read(EXAMPLES / name), robot)
    job = Job(program, robot, Options(world=TASKS[name][0], **CONDITIONS))
    return ProgramRun(job, **options)


@pytest.mark.sample(6)
@pytest.mark.certain
@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_an_example_that_is_debugged_leaves_the_trace_of_one_that_is_not(name):
    # Nobody presses keys.
    expected = session_of(name).run()
    debugger = Debugger(paused=True)
    stepper = Stepper(debugger, 60)
    assert session_of(name, debugger=Debugger()).run() == expected
    assert session_of(name, debugger=debugger, watcher=stepper).run() == expected
    assert stepper.held_lines > 5


CAP = "n = 0\nwhile n < 3000:\n    n += 1\nrobot.sleep(0.1)\nn += 1\n"


@pytest.mark.certain
def test_the_limit_of_lines_at_one_time_applies_to_a_debugged_program_too(play):
    traces = []
    for debugger in (Debugger(), Debugger([6])):
        playing = play("m = 0\n" + CAP, debugger=debugger, speed=None)
        if debugger.control.breakpoints:
            for _ in range(3):
                playing.observer.wait_for("held")
                playing.run.step_over()
            playing.observer.wait_for("held")
            playing.run.set_breakpoints([])
            playing.run.resume()
        traces.append(playing.end().trace_sha256)
    text = HEADER + "m = 0\n" + CAP
    plain = ProgramRun(Job(Program("program.py", text, text), robots.find("sim-ebo"))).run()
    assert set(traces) == {plain.trace_sha256}


@contextmanager
def hammering(run):
    """Read all of its state repeatedly, and pause occasionally."""
    over = threading.Event()

    def hammer():
        for look in itertools.count():
            if over.is_set():
                break
            if run.monitor:
                run.monitor.state(), run.monitor.sounds(), run.monitor.scene()
            if run.monitor and look % 9 == 5:
                run.monitor.camera()
            if look % 7 == 3:
                run.pause()
                run.step()
            if look % 5 == 4:
                run.set_speed((None, 40.0, 15.0)[look % 3])
            run.resume()

    thread = threading.Thread(target=hammer)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()


@pytest.mark.sample(5)
@pytest.mark.certain
@pytest.mark.slow
@pytest.mark.parametrize("speed", [None, 4.0, 10.0, 15.0, 20.0, 30.0, 50.0, 75.0, 100.0])
@pytest.mark.parametrize("name", ["tags.bt", "line-ebo.bt"])
def test_a_run_watched_paused_and_at_any_speed_leaves_the_same_trace(made, name, speed):
    run = session_of(name, debugger=Debugger(), monitored=True)
    run.set_speed(speed)
    run.report_variables(enabled=True)
    with hammering(run):
        assert run.run() == made(name, able_twin(name), **CONDITIONS).report
