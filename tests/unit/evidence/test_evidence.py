"""What is known of a run, while it goes on and when it is over."""

from msgspec import structs

from learnblock import robots, running
from learnblock.evidence.evidence import evidence_so_far
from learnblock.evidence.trace_lines import TraceLines
from learnblock.lessons.checks import Drives, Ends, Happens, Printed
from learnblock.lessons.judging import judge
from learnblock.lessons.trying import read_program
from learnblock.running import Job, Options, ProgramRun
from learnblock.runtime.recorder import MOST_COLLISIONS, Recorder
from learnblock.runtime.trace import Trace
from learnblock.runtime.watcher import Watcher
from lesson_files import STEP, evidence

PROGRAM = """main:
    function.drive_distance(200)
    print("there")
    function.drive_distance(200)
end
"""


class Looking(Watcher):
    """Judges whenever something is printed."""

    def __init__(self, look):
        self.look = look
        self.seen = []

    def printed(self, text):
        self.seen.append(self.look())


def test_a_run_can_be_judged_while_it_goes_on():
    source, robot = read_program(PROGRAM), robots.find("sim-ebo")
    lines = TraceLines()
    checks = (Drives(at_least=300), Happens(what=Printed(what="there")), Ends())
    step = structs.replace(STEP, check=checks)

    def look():
        run_so_far = evidence_so_far(lines, run.recorder.time())
        return [one.state for one in judge(step, source.tree, run_so_far, None)]

    watcher = Looking(look)
    job = Job(running.program(source, robot), robot, Options(world="empty"))
    run = ProgramRun(job, lines=lines, watcher=watcher)
    report = run.run()
    assert watcher.seen == [["open", "met", "open"]]
    over = evidence_so_far(lines, report.time, report, {"": report.collisions})
    assert [one.state for one in judge(step, source.tree, over, None)] == ["met"] * 3


def test_the_place_at_the_end_is_part_of_the_way():
    run = evidence({"t": 0.0, "pose": [0, 0, 0]})
    assert len(run.path) == 1
    ended = evidence(
        {"t": 0.0, "pose": [0, 0, 0]},
        report=running.Report(ended="finished", time=0.15, pose=(12.0, 0.0, 0.0)),
    )
    assert ended.distance == 12.0


def test_only_the_first_collisions_are_kept():
    recorder = Recorder(Trace(), lambda: 0.0, lambda: None)
    for number in range(MOST_COLLISIONS + 10):
        recorder.collision(number / 10, "wall")
    assert len(recorder.collisions) == MOST_COLLISIONS
    assert recorder.collisions[3].time == 0.3


def test_collisions_do_not_change_the_trace():
    one, other = Trace(), Trace()
    Recorder(one, lambda: 0.0, lambda: None).collision(1.0, "wall")
    assert one.sha256 == other.sha256


def test_the_lines_of_the_program_that_ran_are_known():
    run = evidence({"t": 0.0, "line": 3}, {"t": 0.1, "line": 7}, {"t": 0.1, "line": "x"})
    assert run.lines_run == {3, 7}


def test_a_real_robots_pose_is_no_place_in_a_world():
    report = running.Report(ended="finished", time=0.15, pose=(12.0, 0.0, 0.0))
    assert evidence({"t": 0.0, "line": 1}, report=report).path == []
