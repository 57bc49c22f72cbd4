"""Many runs at once have the results of runs one by one, wherever their programs run."""

import sys
from dataclasses import replace
from operator import itemgetter
from threading import Timer

import msgspec
import pytest

from learnblock import robots, running
from learnblock.i18n import Phrase, translate
from learnblock.running import Options, ProgramRun, Report
from learnblock.running.batch import Batch, WarmProcess, checked_result
from learnblock.running.job import Job
from learnblock.running.making import Prints
from learnblock.running.result import RunResult, packed
from learnblock.running.warm import is_shared
from learnblock.runtime.ending import How
from learnblock.runtime.limits import MEGABYTE, Limits
from learnblock.runtime.program import Program
from runs import EXAMPLES, WORLDS

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform != "linux", reason="only Linux forks"),
]
EBO = robots.find("sim-ebo")
HEAD = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n"


def in_python(python):
    return Program("program.py", HEAD + python + "\n", python)


def job(program, **options):
    return Job(program, EBO, Options(**{"world": "empty", "seconds": 3, **options}))


def made(*jobs, **options):
    """What came of the runs of a batch, in the order of its jobs."""
    return [result for _, result in sorted(Batch(jobs, **options).results(), key=itemgetter(0))]


def alone(one):
    """The report of a job's run with a process of its own."""
    prints = Prints()
    run = ProgramRun(one, watcher=prints)
    return replace(run.run(), output=prints.text)


def test_plain_programs_share_a_process_with_their_host_and_end_as_alone():
    programs = [
        running.program(running.read(EXAMPLES / name), EBO)
        for name in ("polygons.bt", "line-ebo.bt", "tags.bt", "watch-out.bt")
    ]
    jobs = [job(one, world=WORLDS.get(one.name, "table")) for one in programs]
    jobs += [job(in_python("print('hi')\nx = [] + 3")), job(in_python("robot.no_such_skill()"))]
    results = made(*jobs, at_once=2)

    assert [one.isolated for one in results] == [False] * 5 + [True]
    assert [one.report for one in results] == list(map(alone, jobs))


def test_a_program_with_imports_never_has_the_simulator_in_its_process():
    look = in_python("import sys\nprint('learnblock.simulator' in sys.modules)")
    [result] = made(job(look))

    assert result.isolated
    assert result.report.output == "False\n"
    assert result.report == alone(job(look))


def test_a_plain_program_that_never_calls_its_robot_ends_as_alone():
    busy = in_python("while True:\n    x = 1")
    [result] = made(replace(job(busy), limits=Limits(silence=0.2)))

    assert result.isolated
    assert result.report.ended == How.NO_CALL


def test_a_plain_program_that_hangs_gets_a_process_of_its_own_at_once():
    hanging = job(in_python("while True: pass"))

    assert is_shared(job(in_python("while True: break")))
    assert not is_shared(hanging)


def test_a_run_in_an_empty_endless_loop_is_not_waited_for_and_ends_as_alone():
    loop = "robot.move_straight(40)\nwhile True:\n    pass"
    # Longer than a test may take: it ends at the loop.
    patient = replace(job(in_python(loop)), limits=Limits(silence=600), with_trace=True)
    brief = replace(patient, limits=Limits(silence=0.2))
    [early], alone_at_last = made(patient), alone(brief)

    assert early.report.ended == alone_at_last.ended == How.NO_CALL
    assert early.report.trace_sha256 == alone_at_last.trace_sha256
    # Alone, it is ended in either line of the loop.
    assert {early.report.error["line"], alone_at_last.error["line"]} <= {5, 6}


def test_a_loop_that_a_program_leaves_before_it_hangs_is_run():
    wanted = job(in_python("if robot.time() > 1:\n    while True: pass\nrobot.sleep(2)"))
    [result] = made(wanted)

    assert result.report == alone(wanted)
    assert result.report.ended == How.FINISHED


def test_a_plain_program_with_too_much_memory_ends_as_one_in_a_process():
    program = in_python("x = [0]\nwhile len(x) < 1e10:\n    x.extend(x)")
    greedy = replace(job(program), limits=Limits(memory=1024 * MEGABYTE))
    [result] = made(greedy)

    assert result.report.ended == How.ERROR
    assert result.report.error["message"] == alone(greedy).error["message"]


def test_a_kept_process_makes_the_runs_of_further_batches():
    wanted = job(in_python("robot.move_straight(40)\nrobot.sleep(2)"))
    kept = WarmProcess()
    try:
        first, second = (made(wanted, kept=kept) for _ in range(2))
        assert first == second
        assert kept.is_running
    finally:
        kept.end()


def test_a_kept_process_ends_with_a_batch_that_is_stopped():
    kept = WarmProcess()
    endless = in_python("while True:\n    robot.sleep(1)")
    batch = Batch([job(endless, seconds=None)] * 2, 1, kept=kept)
    Timer(1.0, batch.stop).start()

    assert [*batch.results()] == []
    assert not kept.is_running


def test_a_batch_whose_kept_process_has_ended_starts_one_of_its_own():
    kept = WarmProcess()
    kept.end()
    [result] = made(job(in_python("robot.sleep(1)")), kept=kept)

    assert result.report.ended == How.FINISHED
    assert result.report.time == 1


def test_a_plain_program_that_is_to_be_isolated_has_the_same_result():
    program = running.program(running.read(EXAMPLES / "square.bt"), EBO)
    jobs = [job(program), replace(job(program), isolated=True)]
    together, apart = made(*jobs)

    assert (together.isolated, apart.isolated) == (False, True)
    assert together.report == apart.report


def test_a_trace_is_kept_if_it_is_wanted():
    program = running.program(running.read(EXAMPLES / "square.bt"), EBO)
    wanted = replace(job(program), with_trace=True)
    [result] = made(wanted)

    lines = [msgspec.json.decode(line) for line in result.trace.splitlines()]
    assert lines[0]["run"]["world"] == "empty"
    assert lines[-1]["end"] == "time limit"


def test_stopped_runs_have_no_result():
    endless = in_python("while True:\n    robot.sleep(1)")
    batch = Batch([job(endless, seconds=None) for _ in range(4)], at_once=2)
    timer = Timer(1.5, batch.stop)
    timer.start()

    assert list(batch.results()) == []


def test_a_program_that_is_not_python_is_refused_as_alone():
    broken = Program("program.py", "x = = 3\n", "x = = 3\n")
    [result] = made(job(broken))

    assert result.report == alone(job(broken))


def test_a_program_that_prints_too_much_ends_alike_in_every_process_and_at_its_line():
    program = in_python("for i in range(10**6):\n    print(i)")
    one = replace(job(program), limits=Limits(output=5000))
    shared, apart = made(one, replace(one, isolated=True))
    assert shared.report == apart.report
    assert ("output limit", 5) == (apart.report.ended, apart.report.error["line"])


@pytest.mark.parametrize(
    ("sent", "ended", "isolated"),
    [
        (RunResult(Report("finished"), lost="mine"), "finished", False),
        (
            RunResult(Report("error", error={"message": Phrase("run-too-much-output")})),
            "error",
            False,
        ),
        (RunResult(Report("error", error={"message": 3})), "killed", True),
    ],
)
def test_a_shared_process_is_believed_neither_a_lost_run_nor_an_error_without_words(
    sent, ended, isolated
):
    result = checked_result(packed(sent), isolated=False)
    assert (result.report.ended, result.lost, result.isolated) == (ended, "", isolated)
    translate(result.report.message or Phrase(""), "en")
