"""A real robot whose wheels are not as its driver believes: its twin finds it out from the log."""

import pytest

from emulated import settle
from learnblock.emulators import emulate
from learnblock.emulators.cozmo.machine import CozmoMachine
from learnblock.emulators.vehicle import Vehicle
from learnblock.why.drift import NOTICEABLE, drift
from learnblock.why.ghost import findings, unrecorded
from learnblock.why.prediction import predict
from logged_runs import logged_text
from twins_time import follow

#: Straight towards the wall of the world, and turns to both sides for some seconds.
DRIVING = """\
main:
    function.move_straight(100)
    function.sleep(6)
    function.stop_bot()
    function.sleep(0.5)
    function.set_move(0, 60)
    function.sleep({turning})
    function.set_move(0, -60)
    function.sleep({turning})
    function.stop_bot()
    function.sleep(0.5)
end
"""
#: Cozmo's turns are compared with those of its twin by time: a command that a busy machine delivers
#: 50 ms later than others is 1.7 % of two turns of 3 s. Others count their own turns.
TURNING = {"cozmo": 8}
#: A world with a wall 800 mm ahead.
WALL = """\
start = [{ x = 0, y = 0, heading = 0 }]

[[wall]]
points = [[800, -600], [800, 600]]
"""


@pytest.fixture
def run(tmp_path, monkeypatch):
    """Run a program on an emulated robot with some settings; return the prediction of its log."""
    world = tmp_path / "wall.toml"
    world.write_text(WALL)

    def run(name, **chosen):
        with emulate(name, str(world)) as emulation:
            if emulation.twin:
                follow(emulation.twin, monkeypatch)
            settle(name, {**emulation.settings, **chosen})
            driving = DRIVING.format(turning=TURNING.get(name, 3))
            logged = logged_text(tmp_path, driving, name, seconds=60)
        assert logged.report.error is None
        return predict(logged.recorded, str(world))

    return run


def codes(prediction):
    return [one.phrase.code for one in findings(prediction, drift(prediction))]


@pytest.mark.parametrize(
    ("name", "missing"),
    [
        ("ev3", []),
        ("cozmo", []),
        ("thymio", ["twin-way-not-measured", "twin-turn-not-measured"]),
    ],
)
def test_a_robot_without_a_fault_goes_where_its_twin_goes(run, name, missing):
    prediction = run(name)
    assert codes(prediction) == ["twin-together"]
    assert drift(prediction).better == {}
    assert [one.code for one in unrecorded(prediction, drift(prediction))] == missing


@pytest.mark.parametrize(("radius", "track"), [(1.04, 1.0), (1.0, 0.93), (0.95, 1.06)])
def test_wrong_sizes_of_an_ev3_are_found_with_the_numbers_to_put_there(run, radius, track):
    # The emulated wheels have 30 mm and 120 mm; the driver believes something else.
    wrong = {"wheel_radius": round(30 / radius, 3), "track": round(120 / track, 3)}
    found = drift(run("ev3", **wrong))
    right = {**found.settings, **found.better}
    assert right["wheel_radius"] == pytest.approx(30, rel=NOTICEABLE)
    assert right["track"] == pytest.approx(120, rel=NOTICEABLE)
    assert found.way.percent == pytest.approx(100 * (radius - 1), abs=1.5)
    assert found.turn.percent == pytest.approx(100 * (radius / track - 1), abs=1.5)


def test_a_cozmo_that_drives_too_little_leaves_the_way_of_its_twin(run, monkeypatch):
    drive = CozmoMachine._set_speeds
    monkeypatch.setattr(
        CozmoMachine,
        "_set_speeds",
        lambda self, left, right: drive(self, left * 0.93, right * 0.93),
    )
    prediction = run("cozmo")
    found = drift(prediction)
    assert found.way.percent == pytest.approx(-7, abs=1.5)
    assert found.turn.percent == pytest.approx(-7, abs=1.5)
    assert prediction.parting is not None
    assert {"twin-parted", "twin-drives", "twin-turns", "twin-no-setting"} <= {*codes(prediction)}


def test_weak_motors_are_no_matter_of_the_size_of_wheels(run, monkeypatch):
    turn = Vehicle.turn
    monkeypatch.setattr(
        Vehicle,
        "turn",
        lambda self, speeds: turn(self, {port: 0.85 * speed for port, speed in speeds.items()}),
    )
    prediction = run("ev3")
    assert codes(prediction) == ["twin-parted", "twin-wheels"]
    assert drift(prediction).better == {}
    assert drift(prediction).counted_way.percent == pytest.approx(-15, abs=2)
