"""A robot's components on the real Ice runtime; run by the system's Python, which has it.

    /usr/bin/python3 servants.py '{"slices": "all.ice", "objects": [["laser", {"dist": [1, 2]}]]}'

Every object listens on its own free port; the first line of output contains the ports, and each
further line is a command that an object received.
"""

import json
import sys
import time

import Ice

PLAN = json.loads(sys.argv[1])
Ice.loadSlice(PLAN["slices"])

import RoboCompApriltag  # noqa: E402 - made by what was loaded
import RoboCompCommonBehavior  # noqa: E402
import RoboCompDifferentialRobot  # noqa: E402
import RoboCompDisplay  # noqa: E402
import RoboCompEmotionalMotor  # noqa: E402
import RoboCompEmotionRecognition  # noqa: E402
import RoboCompGenericBase  # noqa: E402
import RoboCompJointMotor  # noqa: E402
import RoboCompLaser  # noqa: E402
import RoboCompRGBD  # noqa: E402

STATE = RoboCompGenericBase.TBaseState
MOTOR = RoboCompJointMotor.MotorState


def told(*what):
    """Report a command that an object received."""
    if not PLAN.get("quiet"):
        print(json.dumps(what), flush=True)


class Base(RoboCompDifferentialRobot.DifferentialRobot):
    def __init__(self, state=None, broken=False):
        self.state = STATE(**(state or {}))
        self.broken = broken

    def getBaseState(self, current):
        return self.state

    def getBasePose(self, current):
        return 1, -2, 0.5

    def setSpeedBase(self, adv, rot, current):
        if self.broken:
            raise RoboCompGenericBase.HardwareFailedException("the battery is empty")
        told("setSpeedBase", adv, rot)

    def setOdometer(self, state, current):
        told("setOdometer", vars(state))

    def setOdometerPose(self, x, z, alpha, current):
        told("setOdometerPose", x, z, alpha)

    def stopBase(self, current):
        raise ZeroDivisionError("nobody foresaw this")


class Laser(RoboCompLaser.Laser):
    def __init__(self, dist=(), driver="", device="", silent=False):
        self.dist = dist
        self.silent = silent
        self.driver, self.device = driver, device

    def getLaserData(self, current):
        return [RoboCompLaser.TData(0.5 * i, mm) for i, mm in enumerate(self.dist)]

    def getLaserAndBStateData(self, current):
        return self.getLaserData(current), STATE(x=7.0)

    def getLaserConfData(self, current):
        if self.silent:
            return RoboCompLaser.LaserConfData()
        return RoboCompLaser.LaserConfData(
            maxRange=2000, angleIni=-1.5, driver=self.driver, device=self.device
        )


class Joints(RoboCompJointMotor.JointMotor):
    def __init__(self, known=("servo",), handler="", stamp="", silent=False):
        self.silent = silent
        self.known = known
        self.handler = handler
        self.stamp = stamp
        self.pos = 0.0

    def _check(self, name):
        if name not in self.known:
            raise RoboCompJointMotor.UnknownMotorException(name)

    def setPosition(self, goal, current):
        told("setPosition", goal.name, goal.position, goal.maxSpeed)
        self._check(goal.name)
        self.pos = goal.position

    def setSyncPosition(self, goals, current):
        for goal in goals:
            self._check(goal.name)
        told("setSyncPosition", [[goal.name, goal.position, goal.maxSpeed] for goal in goals])

    def setVelocity(self, goal, current):
        told("setVelocity", goal.name, goal.velocity, goal.maxAcc)

    def getMotorState(self, name, current):
        self._check(name)
        return MOTOR(pos=self.pos, p=-5, isMoving=True, temperature=40, timeStamp=self.stamp)

    def getMotorStateMap(self, names, current):
        return {name: self.getMotorState(name, current) for name in names}

    def getAllMotorState(self, current):
        return self.getMotorStateMap(self.known, current)

    def getMotorParams(self, name, current):
        return RoboCompJointMotor.MotorParams(
            name=name, busId=200, minPos=-1.0, invertedSign=True, unitsRange=2.5
        )

    def getAllMotorParams(self, current):
        return [self.getMotorParams(name, current) for name in self.known]

    def getBusParams(self, current):
        if self.silent:
            return RoboCompJointMotor.BusParams()
        return RoboCompJointMotor.BusParams(handler=self.handler, numMotors=3, basicPeriod=20)


class Screen(RoboCompDisplay.Display):
    def setImage(self, image, current):
        told("setImage", image.width, image.height, image.depth, len(image.Img), sum(image.Img))

    def setImageFromFile(self, path, current):
        raise RoboCompDisplay.HardwareFailedException("no such file: " + path)


class Face(RoboCompEmotionalMotor.EmotionalMotor):
    def talking(self, talks, current):
        told("talking", talks)


def express(name):
    def method(self, current):
        told(name)

    return method


for emotion in ["Joy", "Sadness", "Surprise", "Fear", "Anger", "Disgust", "Neutral"]:
    setattr(Face, "express" + emotion, express("express" + emotion))


class Eyes(RoboCompRGBD.RGBD):
    def __init__(self, rows=240, columns=320, depths=None):
        # The red of a pixel is its row, its green its column, its blue 7.
        self.color = bytes(
            level % 256
            for row in range(rows)
            for column in range(columns)
            for level in (row, column, 7)
        )
        count = rows * columns if depths is None else depths
        self.depth = [float(i % 100) for i in range(count)]
        self.registration = RoboCompRGBD.Registration.DepthInColor

    def getRGBDParams(self, current):
        camera = RoboCompRGBD.CameraParameters(focal=525, width=240, height=320, FPS=30)
        return RoboCompRGBD.TRGBDParams(color=camera, depth=camera, driver="PrimeSense")

    def setRegistration(self, value, current):
        self.registration = value

    def getRegistration(self, current):
        return self.registration

    def getData(self, current):
        return self.color, self.depth, {"servo": MOTOR(pos=0.25)}, STATE(alpha=0.5)

    def getImage(self, current):
        pixel = RoboCompRGBD.ColorRGB(1, 2, 3)
        point = RoboCompRGBD.PointXYZ(1.0, 2.0, 3.0, 4.0)
        return [pixel], [5.0, 6.0], [point, point], {}, STATE()


class Tags(RoboCompApriltag.Apriltag):
    """Finds one tag: always the same, or the dark square in the picture if it reads pictures.

    Args:
        order: the number that it reads as the rows, ``rows`` or ``columns``.
        number: the number of the tag that it reports for every dark square.
        wait: seconds until it replies.
    """

    def __init__(self, order="", number=7, wait=0):
        self.order, self.number, self.wait = order, number, wait

    def processimage(self, frame, current):
        told("processimage", frame.width, frame.height, frame.depth, len(frame.image))
        time.sleep(self.wait)
        if not self.order:
            return [RoboCompApriltag.tag(8, 160, 120, "ebo")]
        columns = frame.height if self.order == "rows" else frame.width
        return [
            RoboCompApriltag.tag(self.number, *place, "") for place in dark_square(frame, columns)
        ]


def dark_square(frame, columns):
    """Return the centre of all dark pixels, if they fill the width and height of a square."""
    dark = [place for place, level in enumerate(frame.image[::3]) if level < 100]
    across, down = [place % columns for place in dark], [place // columns for place in dark]
    if dark and abs(max(across) - min(across) - max(down) + min(down)) < 3:
        yield (max(across) + min(across)) // 2, (max(down) + min(down)) // 2


class Feelings(RoboCompEmotionRecognition.EmotionRecognition):
    def __init__(self, found=()):
        self.found = found

    def processimage(self, frame, current):
        told("processimage", frame.width, frame.height, frame.depth, sum(frame.image))
        return [RoboCompEmotionRecognition.SEmotion(*one) for one in self.found]


class Behaviour(RoboCompCommonBehavior.CommonBehavior):
    def getPeriod(self, current):
        return 100

    def getParameterList(self, current):
        return {"ñ": RoboCompCommonBehavior.Parameter(True, "1" * 300, "string")}

    def getState(self, current):
        return RoboCompCommonBehavior.State.Running


KINDS = {
    "apriltag": Tags, "commonbehavior": Behaviour, "differentialrobot": Base, "display": Screen,
    "emotionalmotor": Face, "emotionrecognition": Feelings, "jointmotor": Joints,
    "laser": Laser, "rgbd": Eyes,
}  # fmt: skip


def main():
    with Ice.initialize(
        ["--Ice.Warn.Dispatch=0", "--Ice.Warn.Connections=0", *PLAN.get("ice", ())]
    ) as ice:
        ports = []
        for number, (identity, options) in enumerate(PLAN["objects"]):
            port = options.pop("port", 0)
            endpoint = f"tcp -h 127.0.0.1 -p {port}"
            adapter = ice.createObjectAdapterWithEndpoints(f"a{number}", endpoint)
            adapter.add(KINDS[identity](**options), ice.stringToIdentity(identity))
            adapter.activate()
            ports.append(adapter.getEndpoints()[0].getInfo().port)
        print(json.dumps(ports), flush=True)
        # The parent process closes our input when the test has ended.
        sys.stdin.read()


main()
