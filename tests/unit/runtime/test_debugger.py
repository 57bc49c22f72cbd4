import threading

import pytest

from learnblock.i18n import Phrase
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.ending import How
from learnblock.runtime.messages import Variables
from learnblock.runtime.process import ProcessWorker, ThreadWorker
from listener import Listener

# The header has two lines.
PROGRAM = """
def double(n):
    result = 2 * n
    return result

total = 0
for i in range(2):
    total += double(i)
print(total)
"""


class Script(Listener):
    """Answers each pause of a program with the next command of a list."""

    def __init__(self, *commands, **options):
        super().__init__()
        self.commands = list(commands)
        self.lines, self.variables_held = [], []
        self.debugger = Debugger(**options)

    def held(self, line, variables):
        self.lines.append(line)
        self.variables_held.append(variables)
        getattr(self.debugger, self.commands.pop(0) if self.commands else "resume")()


@pytest.fixture(params=[ProcessWorker, ThreadWorker])
def debug(run, request):
    def debug(script, source=PROGRAM):
        return run(source, debugger=script.debugger, watcher=script, worker=request.param)

    return debug


def test_a_program_pauses_at_its_breakpoints(debug):
    script = Script(breakpoints=[10])
    result = debug(script)
    assert script.lines == [10, 10]
    assert (How.FINISHED, "2\n") == (result.how, result.output)


def test_the_variables_are_those_before_the_line(debug):
    script = Script(breakpoints=[6])
    debug(script)
    first, second = script.variables_held
    assert first.local == {"n": "0", "result": "0"}
    assert second.local == {"n": "1", "result": "2"}
    assert second.shared == {"total": "0", "i": "1"}


def test_outside_functions_all_variables_are_the_programs(debug):
    script = Script(breakpoints=[11])
    debug(script)
    assert script.variables_held[0] == Variables({}, {"total": "2", "i": "1"})


def test_a_program_paused_from_the_start_runs_line_by_line(debug):
    script = Script("step", "step", "step", "step", "step", "step", "step", paused=True)
    debug(script)
    assert script.lines == [1, 2, 4, 8, 9, 10, 5, 6]


def test_stepping_enters_functions(debug):
    script = Script("step", "step", "step", breakpoints=[9])
    debug(script)
    assert script.lines[:4] == [9, 10, 5, 6]


def test_stepping_over_stays_in_the_function(debug):
    script = Script("step_over", "step_over", "step_over", breakpoints=[9])
    debug(script, PROGRAM.replace("range(2)", "range(1)"))
    assert script.lines == [9, 10, 9, 11]


def test_stepping_over_the_end_of_a_function_pauses_in_its_caller(debug):
    script = Script("step_over", "step_over", breakpoints=[5])
    debug(script, PROGRAM.replace("range(2)", "range(1)"))
    assert script.lines == [5, 6, 9]


def test_a_command_while_nothing_is_paused_changes_nothing(debug):
    script = Script(breakpoints=[11])
    for command in ("resume", "step", "step_over"):
        getattr(script.debugger, command)()
    debug(script)
    assert script.lines == [11]


def test_a_pause_takes_effect_at_the_next_line(run):
    class Pausing(Script):
        def input(self, prompt):
            self.debugger.pause()
            return ""

    script = Pausing()
    run("input()\nrobot.sleep(1)\npass\n", debugger=script.debugger, watcher=script)
    assert script.lines == [4]


def test_a_stop_during_a_pause_ends_the_program_at_once(stage):
    class Held(Listener):
        at = threading.Event()

        def held(self, line, variables):
            self.at.set()

    held = Held.at
    run = stage.add("print('never')", debugger=Debugger(breakpoints=[3]), watcher=Held())
    host = stage.host()
    thread = threading.Thread(target=host.run)
    thread.start()
    assert held.wait(20)
    host.stop()
    thread.join(20)
    assert not thread.is_alive()
    assert (How.STOPPED, Phrase("run-stopped")) == (run.ending.how, run.ending.phrase)
    assert stage.results()[0].output == ""


def test_a_variable_that_cannot_be_shown_does_not_end_the_program(debug):
    source = (
        "class Shy:\n    def __repr__(self):\n        raise ValueError\n"
        "shy = Shy()\nlong = 'x' * 999\nodd = '\\ud800'\npass"
    )
    script = Script(breakpoints=[9])
    assert debug(script, source).how == How.FINISHED
    assert script.variables_held[0].shared == {
        "shy": "<ValueError in its own description>",
        "long": "'" + 199 * "x" + "...",
        "odd": "'\\ud800'",
    }


def test_debugging_does_not_change_the_trace(stage, run):
    script = Script(breakpoints=[9])
    debugged = run(PROGRAM, debugger=script.debugger, watcher=script)
    fresh = type(stage)()
    fresh.add(PROGRAM)
    fresh.host().run()
    assert debugged.trace == fresh.results()[0].trace


def held(**options):
    """The debugger of a program that is held at its breakpoint in line 5."""
    debugger = Debugger({5}, **options)
    assert debugger.holds(5, 0)
    return debugger


def test_a_breakpoint_is_the_reason_even_after_a_step():
    debugger = held()
    debugger.step()
    assert debugger.held_by(5) == "breakpoint"


@pytest.mark.parametrize("command", ["step", "step_over"])
def test_after_a_step_the_step_is_the_reason(command):
    debugger = held()
    getattr(debugger, command)()
    assert debugger.held_by(6) == "step"


def test_a_program_that_is_paused_is_held_for_that():
    debugger = held()
    debugger.step()
    debugger.pause()
    assert debugger.held_by(6) == "pause"


def test_a_program_that_begins_with_a_step_is_held_for_that():
    assert Debugger({5}, paused=True).held_by(1) == "step"


def test_breakpoints_that_are_set_while_it_runs_count():
    debugger = Debugger({5})
    debugger.set_breakpoints({7})
    assert [debugger.held_by(5), debugger.held_by(7)] == ["pause", "breakpoint"]
