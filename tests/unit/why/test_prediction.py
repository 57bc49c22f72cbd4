"""A log of a real robot, made from the run of a twin, compared with its twin."""

from dataclasses import replace

import pytest

from learnblock.errors import LearnBlockError
from learnblock.why.drift import drift
from learnblock.why.ghost import findings, unrecorded
from learnblock.why.prediction import predict
from logged_runs import logged_text

DRIVING = """\
main:
    function.move_straight(100)
    function.sleep(4)
    function.stop_bot()
    function.turn_right(45)
    function.sleep(4)
    function.stop_bot()
    function.sleep(0.5)
end
"""
SIZES = {"distance": "wheel_radius", "angle": "track"}


@pytest.fixture(scope="module")
def simulated(tmp_path_factory):
    """The log of a twin's run."""
    return logged_text(tmp_path_factory.mktemp("twin"), DRIVING, "sim-ev3", world="empty").recorded


@pytest.fixture
def real(simulated):
    """Make a log like that of an EV3, which drives and turns as many times too far."""

    def real(far=1.0, turned=1.0, gyroscope=1.0, *, reports=True):
        robot = {"drivers": {}}
        robot["calibration"] = {**SIZES, "sizes": {"wheel_radius": 30.0, "track": 120.0}}
        lines = [{"robot": robot}]
        for line in simulated.lines:
            if "run" in line:
                lines.append({"run": {**line["run"], "robot": "ev3"}})
            elif "pose" in line:
                x, y, heading = line["pose"]
                if reports:
                    lines.append({"t": line["t"], "odometry": [x * far, y * far, heading * turned]})
                value = heading * turned * gyroscope
                lines.append({"t": line["t"], "sensed": "Gyroscope:Z_AXIS", "value": value})
            elif "robot" not in line:
                lines.append(line)
        return replace(simulated, lines=tuple(lines))

    return real


def codes(recorded):
    prediction = predict(recorded)
    return [one.phrase.code for one in findings(prediction, drift(prediction))]


def test_the_same_way_is_no_difference(real):
    assert codes(real()) == ["twin-together"]


def test_the_time_and_the_place_of_the_first_difference_are_said(real):
    parting = predict(real(far=1.2)).parting
    # It is 20 mm/s faster, and its twin may be 0.1 s later: 10 mm.
    assert parting.time == pytest.approx(2.1, abs=0.15)
    assert parting.distance == pytest.approx(30, abs=3)
    assert parting.pose[0] == pytest.approx(245, abs=15)


def test_wheels_that_do_not_obey_are_no_matter_of_calibration(real):
    assert codes(real(far=1.2)) == ["twin-parted", "twin-wheels"]


def test_a_gyroscope_that_turns_further_than_the_wheels_corrects_the_track(real):
    found = drift(predict(real(gyroscope=1.05)))
    assert found.turn.percent == pytest.approx(5, abs=0.2)
    assert found.better == {"track": pytest.approx(120 / 1.05, abs=0.2)}


def test_without_a_report_of_its_pose_it_says_so(real):
    prediction = predict(real(reports=False))
    assert "twin-no-odometry" in [one.code for one in unrecorded(prediction, drift(prediction))]
    assert findings(prediction, drift(prediction)) == ()


def test_a_simulated_robot_has_no_twin(simulated):
    with pytest.raises(LearnBlockError, match="only with a real robot"):
        predict(simulated)
