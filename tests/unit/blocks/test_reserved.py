from learnblock.blocks import builtin
from learnblock.blocks.reserved import RESERVED
from learnblock.robots.real import RealRobot
from learnblock.robots.sim_ebo import Robot
from learnblock.runtime.remote import RemoteRobot


def public(names):
    return {name for name in names if not name.startswith("_")}


def test_other_attributes_of_robots_are_reserved():
    with Robot(world="empty") as robot:
        own = public(vars(robot)) - builtin().keys()
    of_classes = {name for kind in (Robot, RealRobot, RemoteRobot) for name in public(dir(kind))}

    # Only instances of some robots have settings, their type and a seed.
    assert own | of_classes | {"settings", "settings_type", "seed"} == RESERVED
    assert not RESERVED & builtin().keys()
