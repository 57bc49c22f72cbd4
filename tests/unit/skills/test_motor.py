import pytest

from learnblock.devices import JointMotor


@pytest.mark.parametrize(
    ("skill", "args", "command"),
    [
        ("look_floor", (), ("JointMotor:CAMERA.move", -30)),
        ("look_front", (), ("JointMotor:CAMERA.move", 0)),
        ("look_up", (), ("JointMotor:CAMERA.move", 30)),
        ("setAngleCamera", (12.5,), ("JointMotor:CAMERA.move", 12.5)),
        ("setAngleMotor", ("ARM", 45), ("JointMotor:ARM.move", 45)),
    ],
)
def test_a_joint_moves_to_its_angle(robot, skill, args, command):
    getattr(robot, skill)(*args)

    assert [command] == robot.commands


def test_the_camera_tilts_from_the_angle_of_the_last_command(robot):
    robot.up_camera(15)
    robot.up_camera()
    robot.down_camera(5)

    assert [angle for _, angle in robot.commands] == [15, 25, 20]


def test_the_camera_first_tilts_from_where_it_is(robot):
    robot.device(JointMotor, "CAMERA").functions["read"] = lambda: -20.0
    robot.up_camera(5)

    assert robot.commands == [("JointMotor:CAMERA.move", -15)]


def test_a_joint_that_the_robot_lacks_does_not_move(robot):
    robot.setAngleMotor("TAIL", 45)

    assert [] == robot.commands
