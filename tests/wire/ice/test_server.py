"""Our servants, called by the real Ice."""

import json
import subprocess
import threading

import pytest

from ice_runtime import PYTHON, require_ice, written
from learnblock.errors import IceLinkError, IceRefusedError
from learnblock.ice import Adapter, Proxy, Servant
from learnblock.ice.robocomp import (
    BaseState,
    LaserConfData,
    LaserReading,
    Layout,
    MotorState,
    interfaces,
)
from learnblock.ice.robocomp.cameras import Registration
from learnblock.ice.robocomp.components import ComponentState, Parameter
from learnblock.ice.robocomp.recognition import FoundTag
from places import TESTS

CLIENTS = TESTS / "helpers" / "ice" / "clients.py"
STATE = BaseState(
    isMoving=True, x=1.5, z=-2.5, alpha=0.25, correctedX=3.5, correctedZ=4.5, correctedAlpha=0.5,
    advVx=5.5, advVz=6.5, rotV=-0.75,
)  # fmt: skip
CONFIGURATION = LaserConfData(maxRange=2000, angleRes=0.5, driver="VL53L0X", device="i2c")
MOTOR = MotorState(pos=0.25, vel=0.5, timeStamp="now", p=-5, isMoving=True, temperature=40)


class Everything:
    """One object with all interfaces."""

    def getBaseState(self):
        return STATE

    def getBasePose(self):
        return 1, -2, 0.5

    def setSpeedBase(self, adv, rot):
        raise IceRefusedError(f"{adv} {rot}", "::RoboCompGenericBase::HardwareFailedException")

    def stopBase(self):
        raise ZeroDivisionError("nobody foresaw this")

    def setOdometerPose(self, x, z, alpha):
        raise IceRefusedError("it is late", "::Somebody::ElsesException")

    def getLaserData(self):
        return [LaserReading(0.5, 300.0), LaserReading(1.0, 400.0)]

    def getLaserConfData(self):
        return CONFIGURATION

    def setPosition(self, goal):
        self.goal = goal

    def getMotorState(self, name):
        return MOTOR

    def getAllMotorState(self):
        return {"servo": MOTOR}

    def getData(self):
        return b"\x01\x02\x03", [1.5, 2.5], {}, STATE

    def getRegistration(self):
        return Registration.COLOR_IN_DEPTH

    def processimage(self, frame):
        return [FoundTag(8, frame.width, len(frame.image), "ebo")]

    def getState(self):
        return ComponentState.RUNNING

    def getParameterList(self):
        return {"ñ": Parameter(editable=True, value="1" * 300, type="string")}


@pytest.mark.parametrize("encoding", ["1.0", "1.1"])
@pytest.mark.parametrize("layout", Layout)
def test_the_real_ice_receives_what_our_servants_return(layout, encoding, tmp_path):
    require_ice()
    everything = Everything()
    servants = {
        identity: Servant(interface, everything)
        for identity, interface in interfaces(layout).items()
    }
    with Adapter() as adapter:
        plan = {
            "slices": str(written(tmp_path, layout)),
            "port": adapter.serve(servants),
            "encoding": encoding,
        }
        command = [PYTHON, str(CLIENTS), json.dumps(plan)]
        output = subprocess.run(command, capture_output=True, text=True, check=True, timeout=30)
    given = iter(json.loads(output.stdout))
    base = "::RoboCompDifferentialRobot::DifferentialRobot"
    motor = {name: getattr(MOTOR, name) for name in MOTOR.__dataclass_fields__}
    assert next(given) is True
    assert next(given) == [base, ["::Ice::Object", base], None]
    assert next(given) == ["ObjectNotExistException"]
    assert next(given) == ["FacetNotExistException"]
    assert next(given) == {name: getattr(STATE, name) for name in STATE.__dataclass_fields__}
    assert next(given) == [1, -2, 0.5]
    assert next(given) == ["::RoboCompGenericBase::HardwareFailedException", "1.0 2.0"]
    assert next(given) == ["UnknownException", "ZeroDivisionError: nobody foresaw this"]
    assert next(given) == ["OperationNotExistException"]
    assert next(given) == ["UnknownUserException", "::Somebody::ElsesException: it is late"]
    assert next(given) == [{"angle": 0.5, "dist": 300.0}, {"angle": 1.0, "dist": 400.0}]
    assert next(given) == {
        name: getattr(CONFIGURATION, name) for name in CONFIGURATION.__dataclass_fields__
    }
    assert next(given) is None
    assert (everything.goal.name, everything.goal.position, everything.goal.maxSpeed) == (
        "servo", 0.5, 2.0,
    )  # fmt: skip
    assert next(given) == motor
    assert next(given) == {"servo": motor}
    assert next(given) == [3, 6, [1.5, 2.5], 0.25]
    assert next(given) == "ColorInDepth"
    assert next(given) == [{"id": 8, "cx": 2, "cy": 6, "cameraId": "ebo"}]
    assert next(given) == "Running"
    assert next(given) == {"ñ": {"editable": True, "value": "1" * 300, "type": "string"}}
    assert next(given, "nothing more") == "nothing more"


def test_a_closed_adapter_says_goodbye_and_can_be_closed_again():
    known = interfaces(Layout.TOOL)["laser"]
    adapter = Adapter()
    port = adapter.serve({"laser": Servant(known, Everything())})
    with Proxy.parse(f"laser:tcp -h 127.0.0.1 -p {port}", known, 2) as proxy:
        proxy.ping()
        adapter.close()
        with pytest.raises(IceLinkError, match="No component is listening"):
            proxy.ping()
    adapter.close()
    assert not [one for one in threading.enumerate() if one.name == "ice"]


def test_a_wrong_result_of_a_servant_is_reported_as_a_failure():
    class Liar:
        def getLaserData(self):
            return "nothing"

    known = interfaces(Layout.TOOL)["laser"]
    with Adapter() as adapter:
        port = adapter.serve({"laser": Servant(known, Liar())})
        with (
            Proxy.parse(f"laser:tcp -h 127.0.0.1 -p {port}", known, 2) as proxy,
            pytest.raises(IceRefusedError, match="Exception: 'nothing' is not a valid sequence"),
        ):
            proxy.call("getLaserData")
