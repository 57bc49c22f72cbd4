import os
import subprocess
import sys
from pathlib import Path

import pytest

from learnblock.runtime.limits import Limits
from learnblock.runtime.messages import Contained, Ended, Printed, Setup
from learnblock.runtime.process import ProcessWorker, one_processor
from learnblock.runtime.standby import Standby

pytestmark = pytest.mark.realtime


def setup(source):
    return Setup(source, "program.py", "", (), (), None, Limits())


def test_a_process_on_standby_runs_the_program_that_it_is_given():
    with Standby() as standby:
        worker = ProcessWorker(standby)
        worker.link.send(setup("print('hello')"))
        heard = [worker.link.receive(10) for _ in range(3)]
        assert heard == [Contained(), Printed("hello\n"), Ended()]
        assert worker.process == standby.process.pid


def test_a_process_on_standby_ends_with_its_context_and_leaves_no_folder():
    with Standby() as standby:
        folder = Path(standby.scratch.path)
        assert folder.is_dir()
    assert standby.process.returncode is not None
    assert not folder.exists()


def test_a_worker_ends_its_process_before_the_context_does():
    with Standby() as standby:
        ProcessWorker(standby).kill()
        assert standby.process.returncode is not None


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux chooses processors")
def test_a_process_on_standby_joins_its_host_on_one_processor():
    with Standby() as standby, one_processor():
        worker = ProcessWorker(standby)
        assert os.sched_getaffinity(worker.process) == os.sched_getaffinity(0)
        assert len(os.sched_getaffinity(worker.process)) == 1


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux chooses processors")
def test_a_process_on_standby_that_has_died_ends_the_run_and_not_its_host():
    with Standby() as standby:
        standby.process.kill()
        standby.process.wait()
        worker = ProcessWorker(standby)
        with pytest.raises(EOFError):
            worker.link.receive(10)


def loaded(module):
    """The modules that a new process has loaded with one of ours."""
    program = f"import sys, {module}; print(*sys.modules)"
    command = [sys.executable, "-c", program]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return set(done.stdout.split())


@pytest.mark.parametrize("module", ["learnblock.runtime.standby", "learnblock.runtime.child"])
def test_the_process_of_a_program_starts_without_the_language_and_the_host(module):
    slow = {"learnblock.language", "learnblock.running", "learnblock.runtime.run", "click", "numpy"}
    assert not (slow | {"learnblock.runtime.trace"}) & loaded(module)


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux has these modules")
def test_a_process_on_standby_has_loaded_all_that_contains_its_program(tmp_path):
    program = (
        "import sys\n"
        "from learnblock.runtime.containment.fence import contain, prepare\n"
        "from learnblock.runtime.limits import Limits\n"
        "from learnblock.runtime.messages import Setup\n"
        "prepare()\n"
        "before = set(sys.modules)\n"
        "contain(Setup('', 'program.py', '/', (), (), None, Limits()))\n"
        "print([name for name in sys.modules if name not in before and 'learnblock' in name])\n"
    )
    variables = {**os.environ, "TMPDIR": str(tmp_path)}
    done = subprocess.run(
        [sys.executable, "-c", program], env=variables, capture_output=True, text=True, check=True
    )
    assert done.stdout == "[]\n"
