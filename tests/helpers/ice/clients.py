"""A client on the real Ice runtime; run by the system's Python, which has it.

    /usr/bin/python3 clients.py '{"slices": "all.ice", "port": 4061, "encoding": "1.1"}'

It calls the objects, which all listen at one port, and prints their results as a line of JSON.
"""

import json
import sys

import Ice

PLAN = json.loads(sys.argv[1])
Ice.loadSlice(PLAN["slices"])

import RoboCompApriltag  # noqa: E402 - made by what was loaded
import RoboCompCommonBehavior  # noqa: E402
import RoboCompDifferentialRobot  # noqa: E402
import RoboCompJointMotor  # noqa: E402
import RoboCompLaser  # noqa: E402
import RoboCompRGBD  # noqa: E402


def failure(call):
    """The error of a call."""
    try:
        call()
    except Ice.UserException as error:
        return [error.ice_id(), error.what]
    except Ice.UnknownException as error:
        return [type(error).__name__, error.unknown]
    except Ice.Exception as error:
        return [type(error).__name__]


def given(ice):
    """The results of the objects."""

    def reach(identity, kind):
        text = f"{identity} -e {PLAN['encoding']}:tcp -h 127.0.0.1 -p {PLAN['port']}"
        return kind.checkedCast(ice.stringToProxy(text))

    base = reach("differentialrobot", RoboCompDifferentialRobot.DifferentialRobotPrx)
    laser = reach("laser", RoboCompLaser.LaserPrx)
    joints = reach("jointmotor", RoboCompJointMotor.JointMotorPrx)
    eyes = reach("rgbd", RoboCompRGBD.RGBDPrx)
    tags = reach("apriltag", RoboCompApriltag.ApriltagPrx)
    behaviour = reach("commonbehavior", RoboCompCommonBehavior.CommonBehaviorPrx)
    wrong = reach("laser", RoboCompJointMotor.JointMotorPrx)
    nobody = ice.stringToProxy(f"nobody:tcp -h 127.0.0.1 -p {PLAN['port']}")

    yield wrong is None
    yield [base.ice_id(), base.ice_ids(), base.ice_ping()]
    yield failure(nobody.ice_ping)
    yield failure(lambda: laser.ice_facet("old").ice_ping())
    yield vars(base.getBaseState())
    yield base.getBasePose()
    yield failure(lambda: base.setSpeedBase(1.0, 2.0))
    yield failure(base.stopBase)
    yield failure(base.resetOdometer)
    yield failure(lambda: base.setOdometerPose(1, 2, 0.5))
    yield [vars(value) for value in laser.getLaserData()]
    yield vars(laser.getLaserConfData())
    goal = RoboCompJointMotor.MotorGoalPosition(name="servo", position=0.5, maxSpeed=2.0)
    yield joints.setPosition(goal)
    yield vars(joints.getMotorState("servo"))
    yield {name: vars(value) for name, value in joints.getAllMotorState().items()}
    colours, depths, _, state = eyes.getData()
    yield [len(colours), sum(colours), list(depths), state.alpha]
    yield str(eyes.getRegistration())
    picture = RoboCompApriltag.TImage(width=2, height=1, depth=3, image=bytes(6))
    yield [vars(value) for value in tags.processimage(picture)]
    yield str(behaviour.getState())
    yield {name: vars(value) for name, value in behaviour.getParameterList().items()}


with Ice.initialize() as ice:
    print(json.dumps(list(given(ice))))
