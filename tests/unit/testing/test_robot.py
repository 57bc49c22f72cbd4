from learnblock.devices import DEVICE_TYPES, Base, Bumper, DistanceSensors, Gyroscope
from learnblock.testing import FakeRobot


def test_a_fake_robot_has_a_device_of_every_type():
    with FakeRobot() as robot:
        assert {*DEVICE_TYPES.values()} == {type(device) for _, device in robot.devices()}


def test_a_fake_robot_can_have_few_devices():
    with FakeRobot(only=[Base, Gyroscope]) as robot:
        assert [("ROBOT", Base), ("Z_AXIS", Gyroscope)] == [
            (key, type(device)) for key, device in robot.devices()
        ]


def test_every_sensor_can_be_read():
    with FakeRobot() as robot:
        readings = {
            name: robot.read(kind, key)
            for name, kind in DEVICE_TYPES.items()
            for key, device in robot.devices()
            if type(device) is kind and hasattr(device, "read")
        }

    assert False is readings["Bumper"]
    assert [2000] == readings["DistanceSensors"]["back"]
    assert 9 == len(readings)


def test_a_reading_is_seen_although_no_time_passes():
    with FakeRobot() as robot:
        assert robot.read(Bumper) is False
        robot.set_reading(Bumper, True)

        assert robot.read(Bumper) is True


def test_a_reading_lasts_until_the_next_one_is_set():
    with FakeRobot() as robot:
        robot.set_reading(DistanceSensors, {"front": [50]})
        robot.sleep(1)

        assert robot.is_front_obstacle()


def test_stopping_is_recorded_as_a_command():
    robot = FakeRobot()
    robot.move_straight()
    robot.stop()

    assert [("Base.move", 40, 0), ("Base.move", 0, 0)] == robot.commands


def test_a_robot_avoids_a_wall():
    with FakeRobot() as robot:
        robot.move_straight(100)
        while not robot.is_front_obstacle():
            robot.sleep(0.1)
            robot.set_reading(DistanceSensors, {"front": [500 - robot.wheels.pose[0]]})
        robot.stop_bot()

        assert 300 <= robot.wheels.pose[0] <= 320
