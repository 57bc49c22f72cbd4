"""A simulated robot in real time."""

import pytest

from learnblock.emulators import emulate
from learnblock.emulators.twin import Twin
from learnblock.errors import LearnBlockError, UnknownNameError
from twins import let_pass


def test_a_twin_drives_without_further_calls():
    with Twin("sim-cozmo", "empty", speed=100) as twin:
        with twin.body() as body:
            start = body.pose
            body.drive(50, 0)
        let_pass(twin, 2)
        with twin.body() as body:
            assert body.pose[0] > start[0] + 50
    assert [round(time, 1) for time, _ in twin.path[:3]] == [0.1, 0.2, 0.3]


def test_a_closed_twin_does_not_move_and_can_be_closed_again():
    with Twin("sim-ebo", speed=100) as twin:
        pass
    time = twin.time
    twin.close()
    assert twin.time == time


def test_only_simulated_robots_have_twins(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    (tmp_path / "robots").mkdir()
    (tmp_path / "robots" / "mine.py").write_text(
        "from learnblock.testing import FakeRobot as Robot\n"
    )
    with pytest.raises(LearnBlockError, match="'mine' is not a simulated robot"):
        Twin("mine")


def test_a_robot_without_emulator_is_reported():
    with pytest.raises(UnknownNameError, match="There is no emulator 'toaster'"):
        emulate("toaster")
