"""The part of CoppeliaSim's API that drives one robot, a twin in our world.

The scene offers the robot in three ways: with the functions of our scene script under
``/LearnBlock``, with those of the paper's script under ``/Funciones``, and with joints and sensors
under ``/Robot``. CoppeliaSim uses metres, and radians counterclockwise.
"""

import math
from collections.abc import Callable, Mapping
from typing import Any

from learnblock.devices import NOTHING_SEEN
from learnblock.emulators.coppeliasim_scripts import OurScript, PaperScript
from learnblock.emulators.twin import Twin
from learnblock.wheels import body_speeds

STOPPED, PAUSED, RUNNING = 0, 8, 17
#: The constants of the API, with CoppeliaSim's values.
CONSTANTS: Mapping[str, int] = {
    "boolparam_realtime_simulation": 25,
    "handle_world": -1,
    "scripttype_simulation": 1,
    "simulation_advancing_running": RUNNING,
    "simulation_paused": PAUSED,
    "simulation_stopped": STOPPED,
}


class SceneError(Exception):
    """An error raised by an API function."""


class TwinScene:
    """The scene; its simulation is initially stopped.

    Args:
        twin: the simulated robot.
    """

    def __init__(self, twin: Twin) -> None:
        self._twin = twin
        with twin.body() as body:
            self._about = body.description
            self._sides = {
                side: range(len(readings))
                for side, readings in body.distances().items()
                if readings
            }
        self._state = STOPPED
        self._wheels = {"left": 0.0, "right": 0.0}
        self._handles = {path: 10 + number for number, path in enumerate(self._paths())}
        self.functions: Mapping[str, Callable[..., Any]] = {
            "callScriptFunction": self._call_script_function,
            "getObject": self._object,
            "getObjectMatrix": self._matrix,
            "getScript": lambda _kind, path: self._object(path),
            "getSimulationState": lambda: self._state,
            "getVisionSensorImg": self._image,
            "pauseSimulation": lambda: self._simulate(PAUSED),
            "readProximitySensor": self._proximity,
            "readVisionSensor": self._vision,
            "setBoolParam": self._set_bool_param,
            "setJointTargetVelocity": self._turn,
            "startSimulation": lambda: self._simulate(RUNNING),
            "stopSimulation": lambda: self._simulate(STOPPED),
        }
        self._ours = OurScript(twin, self._handles.get("/Robot/camera", -1))
        self._scripts: Mapping[str, Mapping[str, Callable[..., Any]]] = {
            "/LearnBlock": self._ours.functions,
            "/Funciones": PaperScript(twin).functions,
        }

    @property
    def parts(self) -> Mapping[str, Any]:
        """The settings for driving its robot by the names of its parts."""
        sensors = {
            side: tuple(f"/Robot/{side}{number}" for number in numbers)
            for side, numbers in self._sides.items()
        }
        grounds = {
            f"ground_{sensor.side}": f"/Robot/ground_{sensor.side}" for sensor in self._about.ground
        }
        return {
            "scene": "names",
            "left_wheel": "/Robot/left",
            "right_wheel": "/Robot/right",
            "wheel_radius": float(self._about.wheels.radius),
            **sensors,
            **grounds,
            **({"camera": "/Robot/camera"} if self._about.camera else {}),
        }

    def watch(self) -> None:
        """Run the script's watchdog."""
        self._ours.watch()

    # The API.

    def _paths(self) -> list[str]:
        parts = (value for value in self.parts.values() if not isinstance(value, float))
        paths = (path for value in parts for path in ([value] if isinstance(value, str) else value))
        return ["/LearnBlock", "/Funciones", *(path for path in paths if path.startswith("/"))]

    def _object(self, path: str) -> int:
        if path not in self._handles:
            raise SceneError(f"Object does not exist: {path}. (in function 'sim.getObject')")
        return self._handles[path]

    def _path(self, handle: int) -> str:
        for path, other in self._handles.items():
            if other == handle:
                return path
        raise SceneError(f"Object does not exist: {handle}.")

    def _set_bool_param(self, _parameter: int, value: object) -> None:
        """Accept the only parameter, real time, which is always on here."""
        if not isinstance(value, bool):
            raise SceneError("one of the function's argument type is not correct")

    def _simulate(self, state: int) -> None:
        self._state = state
        if state != RUNNING:
            self._ours.begin()

    def _call_script_function(self, function: str, handle: int, *arguments: Any) -> Any:
        if self._state == STOPPED:
            raise SceneError("the script is not initialized: the simulation is stopped")
        functions = self._scripts.get(self._path(handle), {})
        if function not in functions:
            raise SceneError(f"Failed calling script function '{function}'")
        return functions[function](*arguments)

    def _move(self, adv: float, rot: float) -> None:
        with self._twin.body() as body:
            body.drive(adv, rot)

    def _turn(self, handle: int, velocity: float) -> None:
        """Turn a wheel; the right joint is mounted the other way round, so it turns backwards."""
        side = self._path(handle).removeprefix("/Robot/")
        wheels = self._about.wheels
        self._wheels[side] = velocity * wheels.radius * (1 if side == "left" else -1)
        self._move(*body_speeds((self._wheels["left"], self._wheels["right"]), wheels.track))

    def _matrix(self, handle: int, _relative_to: int = -1) -> list[float]:
        """The matrix of a joint, with rows of x, y and z and the position in the last column.

        The axis, its third column, points left, and for the right joint right.
        """
        side = 1 if self._path(handle) == "/Robot/left" else -1
        x, y, angle = self._place()
        left = -math.sin(angle), math.cos(angle)
        reach = side * self._about.wheels.track / 2000
        height = self._about.wheels.radius / 1000
        return [
            *(math.cos(angle), 0.0, side * left[0], x + reach * left[0]),
            *(math.sin(angle), 0.0, side * left[1], y + reach * left[1]),
            *(0.0, -float(side), 0.0, height),
        ]

    def _place(self) -> tuple[float, float, float]:
        """The robot's x and y in m and its angle in radians counterclockwise."""
        with self._twin.body() as body:
            x, y, heading = body.pose
        return x / 1000, y / 1000, -math.radians(heading)

    def _proximity(self, handle: int) -> Any:
        side = self._path(handle).removeprefix("/Robot/").rstrip("0123456789")
        number = int(self._path(handle).removeprefix(f"/Robot/{side}"))
        with self._twin.body() as body:
            distance = body.distances()[side][number]
        if distance >= NOTHING_SEEN:
            return 0, 0.0, [0.0, 0.0, 0.0], -1, [0.0, 0.0, 0.0]
        return 1, distance / 1000, [0.0, 0.0, distance / 1000], 99, [0.0, 0.0, -1.0]

    def _vision(self, handle: int) -> Any:
        """A detection and 15 numbers, of which the eleventh is the average intensity."""
        side = self._path(handle).removeprefix("/Robot/ground_")
        with self._twin.body() as body:
            level = (body.ground()[side] or 0.0) / 100
        return -1, [level] * 15, []

    def _image(self, handle: int) -> Any:
        if self._path(handle) != "/Robot/camera":
            raise SceneError("Object is not a vision sensor.")
        with self._twin.body() as body:
            frame = body.frame()
        height, width = frame.shape[:2]
        # The lowest row comes first.
        return frame[::-1].tobytes(), [width, height]
