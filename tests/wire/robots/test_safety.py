"""However a program ends, its robot has stopped half a second later.

Through each real driver and its wire, to an emulator whose twin is watched.
"""

import os
import signal
import subprocess
import sys

import pytest

from emulated import reachable
from learnblock.emulators import TWINS
from twins import let_pass, stands_after
from waiting import wait_for

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")

#: Seconds within which the motors must stop; mm that count as standing still.
LIMIT, STILL = 0.5, 1.0

PROGRAM = """
from learnblock.robots.{module} import Robot

robot = Robot()
robot.set_move(60, 0)
robot.sleep(0.5)
print("going", flush=True)
{ending}
"""

ENDINGS = {
    "comes to its end": "pass",
    "raises": "1 / 0",
    "leaves without a word": "import os\nos._exit(3)",
    "kills itself": "import os, signal\nos.kill(os.getpid(), signal.SIGKILL)",
}
LONG = "robot.sleep(60)"


@pytest.fixture(params=sorted(TWINS))
def emulation(request):
    """A robot at the other end of its wire, which programs reach through the user's settings."""
    with reachable(request.param) as twin:
        yield request.param, twin


@pytest.fixture
def begin(tmp_path):
    """Run a program; yield its process once the robot is moving."""
    begun = []

    def begin(name, ending, *, hosted=True):
        program = tmp_path / "program.py"
        program.write_text(PROGRAM.format(module=name.replace("-", "_"), ending=ending))
        command = ["-m", "learnblock", "run", program] if hosted else [program]
        process = subprocess.Popen(
            [sys.executable, *command],
            stdout=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )
        begun.append(process)
        said = iter(process.stdout.readline, "")
        assert "going\n" in said, "the program never got under way"
        return process

    yield begin
    for process in begun:
        process.kill()
        process.wait()
        process.stdout.close()


def assert_stands(twin):
    """Check that it was driving until now and stops in time."""
    now = twin.time
    let_pass(twin, LIMIT + 0.5)
    # On a busy machine, a program that ends by itself may have ended some time before.
    assert driven(twin, now, within=2.0) > 5, "it did not drive"
    after = [x for time, (x, _, _) in twin.path if time >= now + LIMIT]
    assert max(after) - min(after) < STILL, f"it went on driving: {after}"


def driven(twin, now, within=0.4):
    """mm that it has driven in these seconds before."""
    places = [x for time, (x, _, _) in twin.path if now - within < time <= now]
    return places[-1] - places[0]


# The host then does the same for every robot.
@pytest.mark.parametrize("emulation", ["cozmo"], indirect=True)
@pytest.mark.parametrize("ending", ENDINGS)
def test_it_stops_when_its_program(emulation, begin, ending):
    name, twin = emulation
    process = begin(name, ENDINGS[ending])
    assert_stands(twin)
    process.wait()
    wait_for(lambda: is_alone(process), "none of its processes is left")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
@pytest.mark.parametrize("hosted", [True, False], ids=["learnblock run", "python"])
def test_it_stops_when_its_runner_gets_a_signal(emulation, begin, number, hosted):
    name, twin = emulation
    process = begin(name, LONG, hosted=hosted)
    wait_for(lambda: driven(twin, twin.time) > 5, "it drives")
    process.send_signal(number)
    assert_stands(twin)
    process.wait()
    wait_for(lambda: is_alone(process), "none of its processes is left")


@pytest.mark.parametrize("hosted", [True, False], ids=["learnblock run", "python"])
def test_it_stops_when_its_runner_freezes(emulation, begin, hosted):
    name, twin = emulation
    process = begin(name, LONG, hosted=hosted)
    wait_for(lambda: driven(twin, twin.time) > 5, "it drives")
    process.send_signal(signal.SIGSTOP)
    # Half a second, plus some time for a busy machine.
    assert stands_after(twin) < LIMIT + 0.5


def is_alone(process):
    """Whether none of its processes is left."""
    try:
        os.killpg(process.pid, 0)
    except ProcessLookupError:
        return True
    return False
