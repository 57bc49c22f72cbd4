"""The operations that a driver calls by name, for each function of its devices."""

from learnblock.client.operations import Operations


def test_each_operation_is_found_once_for_the_function_that_needs_it():
    operations = Operations()
    found = []
    operations.found = lambda *pair: found.append(pair)

    def move(speed):
        operations.note("differentialrobot.setSpeedBase")
        return speed

    assert [operations.serve("Base:ROBOT.move", move, speed) for speed in (1, 2)] == [1, 2]
    assert found == [("Base:ROBOT.move", "differentialrobot.setSpeedBase")]


def test_what_no_device_needs_is_not_found():
    operations = Operations()
    found = []
    operations.found = lambda *pair: found.append(pair)
    operations.note("laser.ice_ping")
    assert found == []
