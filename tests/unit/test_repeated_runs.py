"""A plain program's runs follow each other in one process, and none finds what another left.

Programs that can name more are let in here, to show what becomes of a process that they change.
"""

import sys
from dataclasses import replace
from operator import itemgetter

import pytest

from attacks import children, process_for_all
from learnblock import robots, running
from learnblock.running import Options
from learnblock.running.batch import Batch, WarmProcess
from learnblock.running.job import Job
from learnblock.runtime.limits import MEGABYTE, Limits
from learnblock.runtime.program import Program
from runs import EXAMPLES, WORLDS

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform != "linux", reason="only Linux forks"),
]
EBO = robots.find("sim-ebo")
HEAD = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n"
#: Says in which process it runs.
PROCESS = "import os\nprint(os.getpid())\n"


def job(python, **options):
    program = Program("program.py", HEAD + python + "\n", python)
    return Job(program, EBO, Options(**{"world": "empty", "seconds": 3, **options}))


def made(jobs, kept=None, at_once=1):
    return [
        result for _, result in sorted(Batch(jobs, at_once, kept=kept).results(), key=itemgetter(0))
    ]


@pytest.fixture(scope="module")
def letting_in():
    """A process that lets every program share that of its host."""
    process = process_for_all()
    yield process
    process.end()


@pytest.fixture(scope="module")
def kept():
    process = WarmProcess()
    yield process
    process.end()


def lines(python, letting_in, times=2, **options):
    """What a program prints in runs that follow each other, by line."""
    runs = made([job(python, **options)] * times, letting_in)
    assert not any(run.isolated for run in runs)
    return [run.report.output.split("\n")[:-1] for run in runs]


@pytest.mark.parametrize("name", ["square.bt", "line-ebo.bt", "tags.bt", "dance.bt"])
def test_runs_in_one_process_have_the_reports_and_traces_of_runs_in_their_own(kept, name):
    program = running.program(running.read(EXAMPLES / name), EBO)
    world = WORLDS.get(name, "table")
    jobs = [
        Job(program, EBO, Options(world=world, seconds=5, seed=seed), with_trace=True)
        for seed in (0, 1, 1, 0)
    ]
    # All at once, each in its own process; then one after the other.
    own, in_one = made(jobs, kept, len(jobs)), made(jobs, kept)
    assert own == in_one
    assert own[0] == own[3]
    assert len(children(kept)) == 1


def test_further_runs_of_a_program_are_made_in_its_process(letting_in):
    first, second, third = lines(PROCESS, letting_in, 3)
    assert first == second == third


def test_a_further_batch_with_the_same_program_is_made_in_its_process(letting_in):
    assert lines(PROCESS, letting_in, 1) == lines(PROCESS, letting_in, 1)


def test_another_program_has_another_process(letting_in):
    programs = [job(PROCESS), job(PROCESS + "x = 1"), job(PROCESS)]
    processes = {run.report.output for run in made(programs, letting_in)}
    assert len(processes) == 3


def test_what_differs_besides_seed_and_variant_needs_another_process(letting_in):
    jobs = [
        job(PROCESS),
        job(PROCESS, start=(100, 0, 0)),
        replace(job(PROCESS), limits=Limits(memory=1024 * MEGABYTE)),
        job(PROCESS, world="square"),
    ]
    processes = {run.report.output for run in made(jobs, letting_in)}
    assert len(processes) == len(jobs)


def test_names_and_random_numbers_of_a_run_are_not_those_of_the_next(letting_in):
    python = PROCESS + "import random\nprint('x' in globals(), random.random())\nx = 1"
    first, second = lines(python, letting_in, seed=3)
    assert first == second
    assert first[1].startswith("False ")


LEFT = {
    "a patched robot": "type(robot).x = 1",
    "a patched method": "import learnblock.simulator.world as m\nm.World.advance = print",
    "a patched module": "import learnblock.simulator.world as m\nm.World = None",
    "a patched function of Python's": "import statistics\nstatistics.mean = max",
    "a patched built-in function": "import builtins\nbuiltins.divmod = max",
    "a thread": "import threading\n"
    "threading.Thread(target=threading.Event().wait, daemon=True).start()",
    "much memory": "x = b'1' * (2**28)",
    "an error": "raise ValueError",
}


@pytest.mark.parametrize("name", LEFT)
def test_a_process_in_which_a_run_left_something_makes_no_further_run(letting_in, name):
    first, second = lines(f"{PROCESS}{LEFT[name]}", letting_in)
    assert first != second


def test_a_program_that_patches_its_robot_has_the_same_result_the_second_time(letting_in):
    cheat = (
        "import learnblock.client.client as m\n"
        "print(getattr(m.Client, 'runs', 0))\n"
        "m.Client.runs = 1\n"
    )
    assert lines(cheat, letting_in) == [["0"], ["0"]]


def test_what_is_said_in_a_run_never_counts_for_the_next(letting_in):
    forged = (
        "import os\n"
        "for handle in range(3, 20):\n"
        "    try:\n"
        "        os.write(handle, b'\\x02\\0\\0\\0\\1x' * 2)\n"
        "    except OSError:\n"
        "        pass\n"
    )
    first, second = made([job(forged), job("print('honest')")], letting_in)
    assert first.report.ended == "killed"
    assert second.report.output == "honest\n"


def test_a_robot_from_elsewhere_may_keep_something_and_gets_a_process_for_each_run(kept):
    ours = job("robot.sleep(1)")
    [result] = made([ours], kept)
    assert len(children(kept)) == 1

    elsewhere = replace(ours, robot=replace(EBO, name="mine"))
    assert made([elsewhere], kept) == [result]
    assert children(kept) == []
