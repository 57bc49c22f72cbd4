"""A class is graded on a Dask cluster with the same results as on one computer."""

import hashlib
import json
import os
import re
import signal
import subprocess
import sys
from concurrent.futures import BrokenExecutor
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest
from distributed import Client

from gradings import GOOD, HEAD, LESSON, SHORT, START, handed_in, lesson, plan
from learnblock.errors import LearnBlockError
from learnblock.lessons.grading.executors import cluster, local
from learnblock.lessons.grading.grading import Grading
from learnblock.lessons.grading.journal import NAME as JOURNAL
from learnblock.lessons.grading.journal import opened_journal
from learnblock.lessons.grading.output import TABLE, write_results
from places import ROOT
from ports import free_ports
from waiting import wait_for

pytestmark = [pytest.mark.wire, pytest.mark.slow]
#: What Dask is told: no page of its own, and only this computer reaches it.
DASK = ("--host", "127.0.0.1", "--no-dashboard")


@contextmanager
def started(*command, **more):
    process = subprocess.Popen(
        [sys.executable, "-m", "distributed.cli." + command[0], *command[1:]],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
        **more,
    )
    try:
        yield process
    finally:
        end(process)


def end(process):
    if process.poll() is None:
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


@contextmanager
def scheduling(file, port=0):
    """Run a Dask scheduler on this computer, which writes its address to a file."""
    file.unlink(missing_ok=True)
    command = ("dask_scheduler", *DASK, "--port", str(port), "--scheduler-file", str(file))
    with started(*command) as process:
        wait_for(lambda: file.exists() and '"address"' in file.read_text(), "the scheduler")
        yield process


@pytest.fixture
def scheduler(tmp_path):
    """The file with the address of a Dask scheduler."""
    file = tmp_path / "scheduler.json"
    with scheduling(file):
        yield str(file)


def worker(file):
    command = ("--nthreads", "1", "--no-nanny", "--scheduler-file", file)
    return started("dask_worker", *DASK, *command)


def address(file):
    return json.loads(Path(file).read_text())["address"]


CLASS = handed_in(
    ana=GOOD,
    bo=SHORT,
    cleo=HEAD + "import math\nrobot.move_straight(60)\nrobot.sleep(math.pi)\n",
    dan="main:\n    print('hello')\nend\n",
)


def graded(workers, folder, seeds=3, each=lambda progress: None):
    """The hash of the table of a class that is graded."""
    with opened_journal(folder) as journal:
        grading = Grading(plan(CLASS, opened=lesson(), seeds=seeds), journal)
        for progress in grading.run(workers):
            each(progress)
        write_results(grading, folder, "en", lesson="drive")
    return hashlib.sha256((folder / TABLE).read_bytes()).hexdigest()


@pytest.mark.certain
def test_two_workers_make_the_same_table_also_if_one_of_them_is_killed(scheduler, tmp_path):
    here = graded(lambda: local(1), tmp_path / "here")
    with worker(scheduler) as doomed, worker(scheduler):
        there = address(scheduler)
        with Client(there, set_as_default=False) as client:
            client.wait_for_workers(2, timeout=60)
        assert graded(lambda: cluster(there), tmp_path / "both") == here

        def kill(progress):
            if progress.done == 3:
                end(doomed)

        assert graded(lambda: cluster(there), tmp_path / "one", each=kill) == here
        assert doomed.returncode == -signal.SIGKILL


def test_a_restarted_scheduler_makes_the_same_table(tmp_path):
    file, [port] = tmp_path / "scheduler.json", free_ports(1)
    here = graded(lambda: local(1), tmp_path / "here")
    with ExitStack() as stack:
        doomed = stack.enter_context(scheduling(file, port))
        stack.enter_context(worker(str(file)))

        def restart(progress):
            if progress.done == 3:
                end(doomed)
                stack.enter_context(scheduling(file, port))
                stack.enter_context(worker(str(file)))

        there = address(file)
        assert graded(lambda: cluster(there), tmp_path / "there", each=restart) == here
        assert doomed.returncode == -signal.SIGKILL


#: The command, which waits less long for a scheduler.
IMPATIENT = """
from learnblock.cli.entry import main
from learnblock.lessons.grading import executors

executors.PATIENCE = 3.0
main()
"""


@pytest.mark.certain
def test_a_lost_scheduler_is_reported_in_one_sentence_and_leaves_the_results_so_far(tmp_path):
    (tmp_path / "drive" / "programs").mkdir(parents=True)
    (tmp_path / "drive" / "lesson.toml").write_text(LESSON)
    (tmp_path / "drive" / "programs" / "start.bt").write_text(START)
    (tmp_path / "ana.bt").write_text(GOOD)
    file, journal = tmp_path / "scheduler.json", tmp_path / "out" / JOURNAL
    with scheduling(file) as doomed, worker(str(file)):
        options = ("--lesson", "drive", "--variants", "50", "--out", "out")
        command = (sys.executable, "-c", IMPATIENT, "grade", "ana.bt", *options)
        made = subprocess.Popen(
            [*command, "--scheduler", address(file)],
            cwd=tmp_path,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        try:
            wait_for(lambda: journal.exists() and b"\n" in journal.read_bytes(), "a result")
            end(doomed)
            _, said = made.communicate(timeout=50)
        finally:
            made.kill()
    _, written, reported = (line for line in said.splitlines() if line)
    assert written.endswith("results.html")
    assert "No Dask scheduler answers" in reported
    assert made.returncode != 0
    table = (tmp_path / "out" / TABLE).read_text("utf-8-sig").splitlines()
    assert len(table) == 1 + 51
    assert 0 < sum("not finished" not in row for row in table[1:]) < 51


@pytest.mark.certain
def test_a_result_that_is_lost_on_its_way_ends_the_piece(monkeypatch, scheduler):
    async def lost(*_, **__):
        raise OSError

    with worker(scheduler), cluster(address(scheduler)) as workers:
        assert workers.executor.submit(len, "abc").result(timeout=50) == 3
        monkeypatch.setattr(Client, "_gather", lost)
        with pytest.raises(BrokenExecutor):
            workers.executor.submit(len, "abc").result(timeout=50)


def test_a_cluster_without_a_scheduler_is_reported(monkeypatch):
    monkeypatch.setattr("learnblock.lessons.grading.executors.PATIENCE", 0.5)
    said = r"No Dask scheduler answers at tcp://127\.0\.0\.1:1"
    with pytest.raises(LearnBlockError, match=said), cluster("tcp://127.0.0.1:1"):
        pass


def test_the_commands_of_the_docs_grade_on_a_cluster(scheduler, tmp_path):
    page = (ROOT / "docs" / "grading.md").read_text("utf-8")
    there = re.search(r"tcp://[\d.:]+", page)[0]
    page = page.replace(there, address(scheduler)).replace("--nworkers 4", "--nworkers 1")
    [of_worker] = re.findall(r"^dask worker ([^#\n]*)", page, re.MULTILINE)
    [grade] = re.findall(r"^learnblock (grade .* --scheduler .*)", page, re.MULTILINE)
    (tmp_path / "class-4b").mkdir()
    (tmp_path / "class-4b" / "ana.bt").write_text(GOOD)
    # One run is enough.
    few = ("--variants", "0", "--robots", "sim-ebo")
    with started("dask_worker", *DASK, *of_worker.split()):
        made = subprocess.run(
            [sys.executable, "-m", "learnblock", *grade.split(), *few],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=False,
        )
    assert made.returncode == 0, made.stderr
    assert len((tmp_path / "results" / TABLE).read_text().splitlines()) == 2
