import pytest

from learnblock.blocks import BlockConfiguration
from learnblock.senses import equipment

TURN = BlockConfiguration("motor", "Base", "turn", needs=("Base", "JointMotor:CAMERA"))


@pytest.mark.parametrize(
    ("devices", "lacking"),
    [
        (set(), ("Base", "JointMotor:CAMERA")),
        ({"Base:ROBOT", "JointMotor:CAMERA"}, ()),
        ({"Base:LEFT", "JointMotor:ARM"}, ("JointMotor:CAMERA",)),
    ],
)
def test_a_block_lacks_the_devices_it_needs_and_the_robot_does_not_have(devices, lacking):
    assert lacking == TURN.lacks(equipment(devices, None))


@pytest.mark.parametrize(
    ("shapes", "is_value"), [(("blockVertical",), False), (("blockLeft", "blockBoth"), True)]
)
def test_a_block_is_either_a_value_or_a_statement(shapes, is_value):
    assert is_value is BlockConfiguration("motor", "Base", "turn", shapes=shapes).returns_value
