import pytest


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


def test_a_joint_that_the_robot_lacks_does_not_move(robot):
    robot.setAngleMotor("TAIL", 45)

    assert [] == robot.commands
