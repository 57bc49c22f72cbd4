"""The timeline of a run that goes on."""

import pytest

from learnblock import robots, running
from learnblock.running import Job, ProgramRun
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.process import ThreadWorker
from learnblock.runtime.watcher import Watcher
from learnblock.server import messages
from learnblock.server.runs.live_timeline import LiveTimeline
from learnblock.server.runs.looking import Looking
from logged_runs import logged_blocks, logged_file


class Log:
    """A log that has grown up to a block."""

    def __init__(self, blocks):
        self.blocks = blocks
        self.complete_since = 0


@pytest.fixture(scope="module")
def blocks():
    return logged_blocks("avoid.bt", "sim-ebo", world="arena", seconds=30)


def test_read_in_parts_it_is_that_of_the_whole_run(blocks):
    live, whole = LiveTimeline(), Looking(Log(blocks), []).timeline()
    for known in range(1, len(blocks) + 1):
        shown = live.read(blocks[:known])
    assert (shown.end, shown.exact) == (whole.end, True)
    of_program = {"when", "error"}
    assert shown.marks == tuple(one for one in whole.marks if one.sort not in of_program)
    assert set(shown.way) <= set(whole.way)
    assert shown.way[0] == whole.way[0]


def test_a_run_that_goes_on_is_looked_back_at_up_to_where_it_is(blocks):
    log = Log(blocks[:-1])
    looking = Looking(log, [])
    assert looking.timeline(live=True).end == 30
    then = looking.past(messages.LookBack(12.0))
    log.blocks = blocks
    assert looking.past(messages.LookBack(12.0)) == then
    assert looking.timeline().end == 30


def test_a_log_that_lags_behind_a_paused_program_tells_no_values():
    blocks = logged_blocks("polygons.bt", "sim-ebo", seconds=5)
    looking = Looking(Log(blocks), [f"b{line}" for line in range(1, 60)])
    values = {one.name: one.value for one in looking.values({}).values}
    assert values["corners"] == "3"
    assert looking.values({"corners": "3"}).values
    assert looking.values({"corners": "4"}).values == ()


OBJECT = """\
from learnblock.robots.sim_ebo import Robot

robot = Robot()


class Driver:
    pass


driver = Driver()
count = 1 + 1
robot.sleep(1)
"""


def test_an_object_is_named_as_among_the_variables(tmp_path):
    path = tmp_path / "program.py"
    path.write_text(OBJECT, encoding="utf-8")
    blocks = logged_file(path, "sim-ebo").blocks
    looking = Looking(Log(blocks), [f"b{line}" for line in range(1, 20)])
    values = looking.values({"driver": "Driver", "count": "2"}).values
    assert {one.name: one.value for one in values} == {"driver": "Driver", "count": "2"}


class AtPause(Watcher):
    """Reads the values beside the lines when the program pauses."""

    def __init__(self, log, debugger):
        self.looking = Looking(log, [f"b{line}" for line in range(1, 20)])
        self.debugger = debugger
        self.values = {}

    def held(self, line, variables):
        found = self.looking.values({**variables.shared, **variables.local}).values
        self.values = {one.block: one.value for one in found}
        self.debugger.resume()


def test_a_program_that_pauses_at_a_breakpoint_has_its_values_beside_its_lines(tmp_path):
    path = tmp_path / "program.py"
    path.write_text(OBJECT, encoding="utf-8")
    entry = robots.find("sim-ebo")
    program = running.program(running.read(path), entry)
    log, debugger = RunLog(program), Debugger([12])
    watcher = AtPause(log, debugger)
    run = ProgramRun(
        Job(program, entry),
        worker=ThreadWorker,
        watcher=watcher,
        debugger=debugger,
        log=log,
    )
    assert run.run().ended == "finished"
    assert watcher.values == {"b10": "Driver", "b11": "2"}
