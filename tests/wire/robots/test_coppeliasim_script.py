"""Our scene script for CoppeliaSim, run by a real Lua against an API that records its calls.

The API's functions and constants are those of CoppeliaSim 4.6; one that is misspelt fails. What the
physics of CoppeliaSim does with the robot built here has not been tested.
"""

import itertools
import math
from importlib.resources import files

import numpy as np
import pytest

from learnblock.devices import Base, Display, DistanceSensors, GroundSensors, Gyroscope, LightSensor
from learnblock.robots.coppeliasim.script_scene import ScriptScene
from learnblock.robots.coppeliasim.settings import Settings

lupa = pytest.importorskip("lupa.lua54", reason="pip install lupa: it runs our scene script")

CONSTANTS = (
    "bullet_body_friction",
    "colorcomponent_emission",
    "handle_world",
    "joint_revolute",
    "joint_revolute_subtype",
    "jointdynctrl_velocity",
    "jointintparam_dynctrlmode",
    "jointmode_dynamic",
    "primitiveshape_cuboid",
    "primitiveshape_cylinder",
    "primitiveshape_spheroid",
    "proximitysensor_ray",
    "proximitysensor_ray_subtype",
    "shapeintparam_respondable",
    "shapeintparam_respondable_mask",
    "shapeintparam_static",
)


def turned(quaternion, vector):
    """A vector turned by a quaternion x, y, z, w."""
    axis, w = np.array(quaternion[:3]), quaternion[3]
    return vector + 2 * np.cross(axis, np.cross(axis, vector) + w * np.array(vector))


class Sim:
    """The objects of a scene, and the calls to each."""

    def __init__(self, lua, missing):
        self.lua = lua
        self.missing = missing
        self.time = 0.0
        self.handles = itertools.count(1)
        self.names = {"/LearnBlock": 0}
        self.poses = {0: (None, (0.5, -0.25, 0, 0, 0, math.sqrt(0.5), math.sqrt(0.5)))}
        self.velocities = {}
        self.colours = {}
        self.masses = {}
        self.frictions = {}
        self.echoes = {}
        self.brightnesses = {}

    def table(self):
        functions = {name: self.wrapped(function) for name, function in self.functions().items()}
        constants = {name: number for number, name in enumerate(CONSTANTS, start=100)}
        both = {**functions, **constants}
        table = self.lua.table_from(
            {name: given for name, given in both.items() if name not in self.missing}
        )
        guard = self.lua.eval(
            "function(sim) return setmetatable(sim,"
            " {__index = function(_, name)"
            " if not MISSING[name] then error('no sim.' .. name) end end}) end"
        )
        self.lua.globals().MISSING = self.lua.table_from(dict.fromkeys(self.missing, True))
        return guard(table)

    def functions(self):
        """CoppeliaSim's constants, by name."""
        return {
            "computeMassAndInertia": self.compute_mass_and_inertia,
            "createForceSensor": self.create,
            "createJoint": self.create,
            "createPrimitiveShape": self.create,
            "createProximitySensor": self.create,
            "createVisionSensor": self.create,
            "getObject": self.get_object,
            "getObjectPose": self.get_object_pose,
            "getObjectPosition": self.get_object_position,
            "getSystemTime": lambda: self.time,
            "readProximitySensor": self.read_proximity_sensor,
            "readVisionSensor": self.read_vision_sensor,
            "setEngineFloatParam": self.set_engine_float_param,
            "setFloatProperty": self.set_float_property,
            "setJointTargetForce": lambda *_: None,
            "setJointTargetVelocity": self.velocities.__setitem__,
            "setObjectAlias": self.set_object_alias,
            "setObjectInt32Param": lambda *_: None,
            "setObjectParent": lambda *_: None,
            "setObjectPose": self.set_object_pose,
            "setShapeColor": self.set_shape_color,
        }

    def wrapped(self, function):
        def call(*arguments):
            return function(*(from_lua(one) for one in arguments))

        return call

    def create(self, *_):
        handle = next(self.handles)
        self.poses[handle] = (None, (0, 0, 0, 0, 0, 0, 1))
        return handle

    def set_object_alias(self, handle, name):
        self.names[name] = handle

    def set_object_pose(self, handle, pose, relative):
        assert len(pose) == 7
        assert math.hypot(*pose[3:]) == pytest.approx(1)
        self.poses[handle] = (relative, tuple(pose))

    def get_object(self, path):
        if path not in self.names:
            raise ValueError(f"no object {path}")
        return self.names[path]

    def get_object_pose(self, handle, _relative):
        return self.lua.table_from(self.poses[handle][1])

    def get_object_position(self, handle, _relative):
        return self.lua.table_from(self.place(handle, (0, 0, 0)).tolist())

    def set_engine_float_param(self, _parameter, handle, value):
        self.frictions[handle] = value

    def set_float_property(self, handle, name, value):
        assert name == "bullet.friction"
        self.frictions[handle] = value

    def compute_mass_and_inertia(self, handle, density):
        self.masses[handle] = density
        return 1

    def set_shape_color(self, handle, name, _component, colour):
        self.colours[handle] = colour

    def read_proximity_sensor(self, handle):
        if handle not in self.echoes:
            return 0
        return 1, self.echoes[handle]

    def read_vision_sensor(self, handle):
        if handle not in self.brightnesses:
            return -1
        return 0, self.lua.table_from([0.0] * 10 + [self.brightnesses[handle]] + [0.0] * 4)

    # For the tests.

    def place(self, handle, point):
        """The position in the world of a point of an object."""
        while handle is not None:
            parent, pose = self.poses[handle]
            point = np.array(pose[:3]) + turned(pose[3:], point)
            handle = parent if parent in self.poses else None
        return np.array(point)

    def direction(self, name, vector):
        """A direction of an object, relative to the hull."""
        pose = self.poses[self.names[name]][1]
        return turned(pose[3:], vector)


def from_lua(value):
    """Lua's tables as lists or dicts, as they come over the wire."""
    if lupa.lua_type(value) != "table":
        return value
    keys = list(value)
    if keys == list(range(1, len(keys) + 1)):
        return [from_lua(value[key]) for key in keys]
    return {key: from_lua(value[key]) for key in keys}


class LuaRemote:
    """CoppeliaSim with our script in it, reached without a wire."""

    place = "CoppeliaSim"

    def __init__(self, functions):
        self._functions = functions

    def constant(self, *names):
        return 1

    def call(self, function, *arguments):
        if function == "getScript":
            return 7
        assert function == "callScriptFunction"
        name, handle, *given = arguments
        assert handle == 7
        return from_lua(self._functions[name](*given))


#: Functions that are missing in older or in newer versions.
OLD = ("setFloatProperty", "joint_revolute", "proximitysensor_ray")
NEW = (
    "setEngineFloatParam",
    "bullet_body_friction",
    "joint_revolute_subtype",
    "proximitysensor_ray_subtype",
)


@pytest.fixture
def sim():
    return Sim(lupa.LuaRuntime(unpack_returned_tuples=True), NEW)


@pytest.fixture
def script(sim):
    """The script's functions, once CoppeliaSim has started its simulation."""
    return begun(sim)


def begun(sim):
    functions = sim.lua.globals()
    sim.lua.execute("local sim = ...; package.preload.sim = function() return sim end", sim.table())
    sim.lua.execute(files("learnblock.robots.coppeliasim").joinpath("scene.lua").read_text())
    functions.sysCall_init()
    return functions


@pytest.fixture
def devices(script):
    scene = ScriptScene(LuaRemote(script), Settings())
    return {type(device): device for device, _ in scene.devices()}


def wheels(sim):
    """rad/s of the left and the right wheel."""
    return tuple(sim.velocities[sim.names[f"{side}Motor"]] for side in ("left", "right"))


def test_it_has_the_position_and_heading_of_the_dummy(devices):
    x, y, heading = devices[Base].functions["read"]()
    # The axle is 40 mm behind the middle of the hull; the dummy's x axis points ahead.
    assert (x, y) == pytest.approx((500, -290))
    assert heading == pytest.approx(-90)


def test_without_a_dummy_of_its_name_it_is_in_the_middle(sim, script):
    del sim.names["/LearnBlock"]
    script.sysCall_init()
    assert sim.place(sim.names["LearnBlockRobot"], (0, 0, 0)) == pytest.approx((0, 0, 0.07))


def test_forward_turns_both_wheels_forward(sim, devices):
    devices[Base].move(100, 0)
    assert wheels(sim) == pytest.approx((2.5, 2.5))


def test_the_left_wheel_is_faster_in_a_right_turn(sim, devices):
    devices[Base].move(0, 90)
    assert wheels(sim) == pytest.approx((2.7489, -2.7489), abs=1e-4)


def test_a_joint_that_turns_in_positive_direction_rolls_forward(sim, script):
    for side in ("left", "right"):
        assert sim.direction(f"{side}Motor", (0, 0, 1)) == pytest.approx((0, 1, 0))


def test_wheels_and_ball_just_touch_the_floor(sim, script):
    for name, radius in (("leftWheel", 0.04), ("rightWheel", 0.04), ("caster", 0.02)):
        assert sim.place(sim.names[name], (0, 0, 0))[2] == pytest.approx(radius)


@pytest.mark.parametrize("missing", [OLD, NEW], ids=["old", "new"])
def test_the_ball_slides_and_the_wheels_grip_in_every_version(missing):
    sim = Sim(lupa.LuaRuntime(unpack_returned_tuples=True), missing)
    begun(sim)
    assert sim.frictions[sim.names["caster"]] == 0
    assert sim.frictions[sim.names["leftWheel"]] == sim.frictions[sim.names["rightWheel"]] == 1
    assert all(density > 0 for density in sim.masses.values())


@pytest.mark.parametrize(
    ("name", "degrees"),
    [
        ("front1", -20),
        ("front2", 0),
        ("front3", 20),
        ("left1", -60),
        ("right1", 60),
        ("back1", 180),
    ],
)
def test_a_distance_sensor_points_in_the_given_direction(sim, script, name, degrees):
    angle = math.radians(degrees)
    expected = (math.cos(angle), -math.sin(angle), 0)
    assert sim.direction(name, (0, 0, 1)) == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("name", ["front1", "front2", "front3", "left1", "right1", "back1"])
def test_no_distance_sensor_sees_the_robot_itself(sim, script, name):
    x, y, _ = sim.poses[sim.names[name]][1][:3]
    assert abs(x) > 0.0955 or abs(y) > 0.055
    assert not (abs(x + 0.04) < 0.04 and 0.06 < abs(y) < 0.08)


def test_the_camera_points_ahead_and_is_upright(sim, script):
    assert sim.direction("camera", (0, 0, 1)) == pytest.approx((1, 0, 0))
    assert sim.direction("camera", (0, 1, 0)) == pytest.approx((0, 0, 1))


@pytest.mark.parametrize(("side", "y"), [("left", 0.015), ("central", 0), ("right", -0.015)])
def test_a_ground_sensor_points_down_on_its_side(sim, script, side, y):
    assert sim.direction(f"ground{side}", (0, 0, 1)) == pytest.approx((0, 0, -1))
    assert sim.poses[sim.names[f"ground{side}"]][1][1] == pytest.approx(y)


def test_readings_come_in_our_units(sim, devices):
    sim.echoes = {sim.names["front2"]: 0.25, sim.names["back1"]: 0.5}
    grounds = {"left": 0.1, "central": 0.5, "right": 1.0}
    sim.brightnesses = {sim.names[f"ground{side}"]: level for side, level in grounds.items()}
    sim.brightnesses[sim.names["camera"]] = 0.5
    seen = devices[DistanceSensors].read()
    assert seen == {"front": [2000, 250, 2000], "left": [2000], "right": [2000], "back": [500]}
    assert devices[GroundSensors].read() == {"left": 10, "central": 50, "right": 100}
    assert devices[LightSensor].read() == pytest.approx(511.5)


def test_before_the_first_step_everything_is_dark_and_far(devices):
    assert devices[GroundSensors].read() == {"left": 0, "central": 0, "right": 0}
    assert devices[DistanceSensors].read()["front"] == [2000, 2000, 2000]


def test_its_gyroscope_turns_with_the_hull(sim, devices):
    hull = sim.names["LearnBlockRobot"]
    relative, pose = sim.poses[hull]
    sim.poses[hull] = (relative, (*pose[:3], 0, 0, 0, 1))
    # It faced along y and now faces along x, a quarter turn to the right.
    assert devices[Gyroscope].read() == pytest.approx(90)


def test_a_face_shows_every_emotion(sim, devices):
    for emotion in ("joy", "sadness", "anger", "fear", "surprise", "disgust"):
        devices[Display].show_emotion(emotion)
        assert max(sim.colours[sim.names["face"]]) > 0.5
    devices[Display].show_emotion("neutral")
    assert sim.colours[sim.names["face"]] == [0, 0, 0]


def test_the_motors_stop_when_no_message_arrives_for_a_while(sim, script, devices):
    devices[Base].move(100, 0)
    sim.time = 0.34
    script.sysCall_actuation()
    assert wheels(sim) == pytest.approx((2.5, 2.5))
    sim.time = 0.36
    script.sysCall_actuation()
    assert wheels(sim) == (0, 0)


def test_a_program_that_sends_again_continues_driving(sim, script, devices):
    devices[Base].move(100, 0)
    sim.time = 5
    script.sysCall_actuation()
    devices[DistanceSensors].read()
    script.sysCall_actuation()
    assert wheels(sim) == pytest.approx((2.5, 2.5))


def test_a_new_program_starts_with_the_robot_stopped(sim, script, devices):
    devices[Base].move(100, 0)
    ScriptScene(LuaRemote(script), Settings())
    script.sysCall_actuation()
    assert wheels(sim) == (0, 0)


def test_a_reading_resets_the_watchdog(sim, script, devices):
    devices[Base].move(100, 0)
    sim.time = 0.3
    devices[DistanceSensors].read()
    sim.time = 0.6
    script.sysCall_actuation()
    assert wheels(sim) == pytest.approx((2.5, 2.5))
