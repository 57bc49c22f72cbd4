"""Our proxies, answered by the real Ice."""

import pytest

from ice_runtime import components
from learnblock.errors import IceEncodingError, IceRefusedError
from learnblock.ice import Proxy
from learnblock.ice.robocomp import (
    BaseState,
    Image,
    LaserConfData,
    LaserReading,
    Layout,
    MotorGoalPosition,
    MotorState,
    interfaces,
)
from learnblock.ice.robocomp.cameras import ColorRGB, PointXYZ, Registration
from learnblock.ice.robocomp.components import ComponentState
from learnblock.ice.robocomp.joints import BusParams, MotorGoalVelocity, MotorParams
from learnblock.ice.robocomp.recognition import FoundTag, Picture

STATE = BaseState(isMoving=True, x=1.5, z=-2.5, alpha=0.25, correctedX=3.5, rotV=-0.75)
OBJECTS = {
    "differentialrobot": {
        "state": {"isMoving": True, "x": 1.5, "z": -2.5, "alpha": 0.25, "correctedX": 3.5,
                  "rotV": -0.75}
    },
    "laser": {"dist": [300.0, 400.5], "driver": "Gazebo", "device": "left"},
    "jointmotor": {"handler": "dynamixel", "stamp": "now"},
    "display": {},
    "emotionalmotor": {},
    "rgbd": {"rows": 3, "columns": 4},
    "apriltag": {},
    "commonbehavior": {},
}  # fmt: skip


@pytest.fixture(scope="module", params=list(Layout))
def robot(request, tmp_path_factory):
    """Components in a layout, and proxies to them."""
    layout = request.param
    with components(tmp_path_factory.mktemp("ice"), layout, *OBJECTS.items()) as running:
        proxies = {
            name: Proxy.parse(f"{name}:tcp -h 127.0.0.1 -p {port}", interfaces(layout)[name], 5)
            for name, port in zip(OBJECTS, running.ports, strict=True)
        }
        yield layout, running, proxies
        for proxy in proxies.values():
            proxy.close()


def test_every_object_reports_its_type(robot):
    _, _, proxies = robot
    for proxy in proxies.values():
        proxy.check()
        proxy.ping()
        assert proxy.ids() == proxy.interface.type_ids


def test_an_object_of_another_type_is_reported(robot):
    _, running, _ = robot
    known = interfaces(Layout.TOOL)["display"]
    with (
        Proxy.parse(f"laser:tcp -h 127.0.0.1 -p {running.ports[1]}", known, 5) as proxy,
        pytest.raises(IceRefusedError, match="not have the interface ::RoboCompDisplay::Display"),
    ):
        proxy.check()


def test_a_base_is_driven_and_read(robot):
    _, running, proxies = robot
    base = proxies["differentialrobot"]
    assert base.call("setSpeedBase", 100.5, -0.5) is None
    assert running.told() == ["setSpeedBase", 100.5, -0.5]
    assert base.call("getBaseState") == STATE
    assert base.call("getBasePose") == (1, -2, 0.5)
    base.call("setOdometer", STATE)
    name, told = running.told()
    assert (name, BaseState(**told)) == ("setOdometer", STATE)
    base.call("setOdometerPose", 3, -4, 0.5)
    assert running.told() == ["setOdometerPose", 3, -4, 0.5]


def test_lasers_are_read(robot):
    _, _, proxies = robot
    readings = (LaserReading(0.0, 300.0), LaserReading(0.5, 400.5))
    assert proxies["laser"].call("getLaserData") == readings
    assert proxies["laser"].call("getLaserAndBStateData") == (BaseState(x=7.0), readings)
    assert proxies["laser"].call("getLaserConfData") == LaserConfData(
        maxRange=2000, angleIni=-1.5, driver="Gazebo", device="left"
    )


def test_joints_are_moved_and_read(robot):
    _, running, proxies = robot
    joints = proxies["jointmotor"]
    joints.call("setPosition", MotorGoalPosition("servo", 0.5, 2.0))
    assert running.told() == ["setPosition", "servo", 0.5, 2.0]
    joints.call("setSyncPosition", [MotorGoalPosition("servo", 0.25, 1.0)])
    assert running.told() == ["setSyncPosition", [["servo", 0.25, 1.0]]]
    joints.call("setVelocity", MotorGoalVelocity("servo", 0.75, 0.5))
    assert running.told() == ["setVelocity", "servo", 0.75, 0.5]
    state = MotorState(pos=0.5, p=-5, isMoving=True, temperature=40, timeStamp="now")
    assert joints.call("getMotorState", "servo") == state
    assert joints.call("getMotorStateMap", ["servo"]) == {"servo": state}
    assert joints.call("getAllMotorState") == {"servo": state}
    params = MotorParams("servo", 200, minPos=-1.0, invertedSign=True, unitsRange=2.5)
    assert joints.call("getMotorParams", "servo") == params
    assert joints.call("getAllMotorParams") == (params,)
    assert joints.call("getBusParams") == BusParams("dynamixel", numMotors=3, basicPeriod=20)


def test_faces_are_shown(robot):
    layout, running, proxies = robot
    proxies["display"].call("setImage", Image(2, 1, 3, b"\1\2\3\4\5\6"))
    assert running.told() == ["setImage", 2, 1, 3, 6, 21]
    face = proxies["emotionalmotor"]
    names = [one.name for one in face.interface.operations if one.name.startswith("express")]
    assert ("expressNeutral" in names) is (layout is not Layout.SINCE_2020)
    for name in names:
        face.call(name)
        assert running.told() == [name]


def test_a_camera_of_colours_and_distances_is_read(robot):
    _, _, proxies = robot
    colours, depths, joints, state = proxies["rgbd"].call("getData")
    expected = bytes(level for row in range(3) for column in range(4) for level in (row, column, 7))
    assert colours == expected
    assert list(depths) == [float(number) for number in range(12)]
    assert joints == {"servo": MotorState(pos=0.25)}
    assert state == BaseState(alpha=0.5)
    pixels, depths, points, joints, state = proxies["rgbd"].call("getImage")
    assert (pixels, list(depths), joints) == ((ColorRGB(1, 2, 3),), [5.0, 6.0], {})
    assert points == (PointXYZ(1.0, 2.0, 3.0, 4.0),) * 2
    params = proxies["rgbd"].call("getRGBDParams")
    assert (params.color.width, params.depth.height, params.driver) == (240, 320, "PrimeSense")
    proxies["rgbd"].call("setRegistration", Registration.COLOR_IN_DEPTH)
    assert proxies["rgbd"].call("getRegistration") is Registration.COLOR_IN_DEPTH


def test_components_are_read(robot):
    _, running, proxies = robot
    picture = Picture(width=240, height=320, depth=3, image=bytes(240 * 320 * 3))
    assert proxies["apriltag"].call("processimage", picture) == (FoundTag(8, 160, 120, "ebo"),)
    assert running.told() == ["processimage", 240, 320, 3, 230400]
    assert proxies["commonbehavior"].call("getPeriod") == 100
    assert proxies["commonbehavior"].call("getState") is ComponentState.RUNNING
    assert proxies["commonbehavior"].call("getParameterList")["ñ"].value == "1" * 300


@pytest.mark.parametrize(
    ("component", "call", "kind", "sentence"),
    [
        ("jointmotor", ("getMotorState", "arm"), "::RoboCompJointMotor::UnknownMotorException",
         "^arm$"),
        ("display", ("setImageFromFile", "x"), "::RoboCompDisplay::HardwareFailedException",
         "no such file: x"),
        ("differentialrobot", ("stopBase",), "UnknownException",
         "^ZeroDivisionError: nobody foresaw this$"),
        ("rgbd", ("getXYZ",), "OperationNotExistException", "'rgbd' has no operation 'getXYZ'"),
        ("laser", ("fly",), "OperationNotExistException", "Laser' has no operation 'fly'"),
    ],
)  # fmt: skip
def test_a_refusal_gives_its_reason(robot, component, call, kind, sentence):
    _, _, proxies = robot
    with pytest.raises(IceRefusedError, match=sentence) as caught:
        proxies[component].call(*call)
    assert caught.value.kind == kind


def test_a_missing_object_is_reported(robot):
    layout, running, _ = robot
    known = interfaces(layout)["laser"]
    with (
        Proxy.parse(f"lasser:tcp -h 127.0.0.1 -p {running.ports[1]}", known, 5) as proxy,
        pytest.raises(IceRefusedError, match="'lasser' has no operation 'ice_isA'"),
    ):
        proxy.check()


@pytest.mark.parametrize(
    ("values", "sentence"),
    [
        ((1.0,), "2 values are expected, not 1"),
        ((1.0, 2.0, 3.0), "2 values are expected, not 3"),
        (("fast", 0.0), "'fast' is not a valid float"),
    ],
)
def test_invalid_arguments_of_an_operation_are_rejected_by_the_client(robot, values, sentence):
    _, _, proxies = robot
    with pytest.raises(IceEncodingError, match=sentence):
        proxies["differentialrobot"].call("setSpeedBase", *values)


@pytest.mark.parametrize("told", list(Layout))
def test_a_goal_in_another_order_is_refused_unread(robot, told):
    layout, running, _ = robot
    known = interfaces(told)["jointmotor"]
    text = f"jointmotor:tcp -h 127.0.0.1 -p {running.ports[2]}"
    alike = (told is Layout.ROBOT) is (layout is Layout.ROBOT)
    with Proxy.parse(text, known, 5) as joints:
        if alike:
            joints.call("setPosition", MotorGoalPosition("servo", 0.5, 2.0))
            assert running.told() == ["setPosition", "servo", 0.5, 2.0]
            return
        with pytest.raises(IceRefusedError) as caught:
            joints.call("setPosition", MotorGoalPosition("servo", 0.5, 2.0))
    assert caught.value.kind == "UnknownLocalException"


@pytest.mark.parametrize(
    "text",
    ["", "base", "base:udp -p 5", "base:tcp -p", "base:tcp -p 0", "base:tcp -p 65536",
     "base:tcp -h localhost", "a b:tcp -p 5", "base:tcpp -p 5"],
)  # fmt: skip
def test_a_text_that_is_not_a_proxy_is_rejected(text):
    with pytest.raises(IceEncodingError, match=r"is not a proxy\. Write it like this: base:tcp"):
        Proxy.parse(text, interfaces(Layout.TOOL)["laser"])


def test_a_proxys_text_contains_its_address():
    proxy = Proxy.parse("base : tcp  -p 5 -h 10.0.0.1 -t 500", interfaces(Layout.TOOL)["laser"])
    assert (proxy.identity, proxy.endpoint.host, proxy.endpoint.port) == ("base", "10.0.0.1", 5)
    assert repr(proxy) == "<Proxy base:tcp -h 10.0.0.1 -p 5>"
