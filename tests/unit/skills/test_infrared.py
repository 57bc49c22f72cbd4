from learnblock.devices import Infrared


def test_the_last_code_received_is_returned(robot):
    robot.set_reading(Infrared, 65)

    assert 65 == robot.get_IR()
    assert robot.is_this_code_IR(65)
    assert not robot.is_this_code_IR(64)


def test_before_any_code_there_is_none(robot):
    assert robot.get_IR() is None
    assert not robot.is_this_code_IR(0)


def test_a_code_is_sent(robot):
    robot.send_code_IR(12)

    assert [("Infrared.send", 12)] == robot.commands


def test_a_robot_that_only_receives_sends_nothing(robot):
    del robot.device(Infrared).functions["send"]
    robot.send_code_IR(12)

    assert [] == robot.commands
