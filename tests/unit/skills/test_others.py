import pytest

from learnblock.errors import DeviceValueError


def test_waiting_takes_the_robot_s_time(robot):
    robot.sleep()
    robot.sleep(2.5)

    assert 3.5 == robot.clock.time()


def test_the_elapsed_time_counts_from_the_start(robot):
    robot.sleep(5)

    assert robot.elapsedTime(4.9)
    assert not robot.elapsedTime(5)
    with pytest.raises(TypeError):
        robot.elapsedTime()


def test_a_time_that_is_not_a_number_is_refused_by_name(robot):
    with pytest.raises(DeviceValueError, match="'seconds' must be a number, not 'long'"):
        robot.sleep("long")


def test_the_timer_counts_from_its_last_start(robot):
    robot.sleep(2)
    assert robot.get_timer() == 2
    robot.reset_timer()
    robot.sleep(1.5)
    assert robot.get_timer() == 1.5
