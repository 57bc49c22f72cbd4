"""Emulates CoppeliaSim: a server of its ZeroMQ remote API that moves a twin.

It uses protocol 2 of CoppeliaSim 4.6 and later: a REP socket with requests and replies in CBOR. A
request is ``{func, args, argsL, uuid, ver, lang, timeout}``, with the last three in the first
request only. A reply is ``{ret}``, ``{err}``, or ``{func: "_*wait*_"}`` for a client that must ask
again.
"""

import threading
from collections.abc import Mapping
from typing import Any

from learnblock.emulators.coppeliasim_scene import CONSTANTS, SceneError, TwinScene
from learnblock.emulators.twin import Twin
from learnblock.errors import EmulatorError
from learnblock.robots.real import require

#: Milliseconds between two checks of the watchdog.
_TICK = 50
#: Seconds of a simulation step, CoppeliaSim's default.
_STEP = 0.05

Request = Mapping[str, Any]


class Emulator:
    """An emulated CoppeliaSim; it listens as soon as it is made.

    Args:
        twin: the robot that it drives.
        port: the port on 127.0.0.1; a free one by default.

    Raises:
        MissingPackageError: the packages for the remote API are not installed.
        EmulatorError: the port is in use.
    """

    def __init__(self, twin: Twin, port: int = 0) -> None:
        self._cbor = require("cbor2", "coppeliasim")
        self._zmq = require("zmq", "coppeliasim")
        self._twin = twin
        self.scene = TwinScene(twin)
        #: The simulated time until which each client is waiting for a step.
        self._waiting: dict[object, float] = {}
        self._context = self._zmq.Context()
        self._socket = self._context.socket(self._zmq.REP)
        self._socket.linger = 0
        try:
            self._socket.bind(f"tcp://127.0.0.1:{port or '*'}")
        except self._zmq.ZMQError as error:
            self._context.destroy()
            raise EmulatorError("emulator-port-taken", port=str(port)) from error
        self.port = int(self._socket.last_endpoint.decode().rpartition(":")[2])
        self.settings: Mapping[str, Any] = {"address": "127.0.0.1", "port": self.port}
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._serve, name="coppeliasim", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Stop listening; calling it twice is harmless."""
        self._closed.set()
        self._thread.join()

    def answer(self, request: bytes) -> bytes:
        """The reply to any request, including an invalid one."""
        try:
            return self._encoded(self._answered(self._cbor.loads(request)))
        except Exception as error:  # noqa: BLE001 - a request may be invalid in any way
            return self._encoded({"err": f"{type(error).__name__}: {error}"})

    def _encoded(self, reply: Mapping[str, Any]) -> bytes:
        encoded: bytes = self._cbor.dumps(reply)
        return encoded

    def _serve(self) -> None:
        try:
            while not self._closed.is_set():
                if self._socket.poll(_TICK):
                    self._socket.send(self.answer(self._socket.recv()))
                self.scene.watch()
        finally:
            self._context.destroy()

    def _answered(self, request: Any) -> Mapping[str, Any]:
        if not isinstance(request, dict) or "uuid" not in request:
            # As the server answers clients of protocol 1.
            return {"success": False, "error": "the client's version does not match"}
        function, client = request.get("func"), request["uuid"]
        if function in ("_*executed*_", "sim.step"):
            return self._step(client)
        try:
            return {"ret": _listed(self._called(str(function), request.get("args") or []))}
        except SceneError as error:
            return {"err": f"{error}_=NL=_stack traceback:"}

    def _called(self, function: str, arguments: Any) -> Any:
        if function == "zmqRemoteApi.require":
            return None
        if function == "zmqRemoteApi.info":
            return self._info()
        called = self.scene.functions.get(function.removeprefix("sim."))
        if called is None or not function.startswith("sim."):
            raise SceneError(f"No such function: {function}")
        return called(*arguments)

    def _info(self) -> Mapping[str, Any]:
        functions: dict[str, Any] = {name: {"func": {}} for name in (*self.scene.functions, "step")}
        return {**functions, **{name: {"const": value} for name, value in CONSTANTS.items()}}

    def _step(self, client: object) -> Mapping[str, Any]:
        """Make a client wait until the world has advanced by a step."""
        until = self._waiting.setdefault(client, self._twin.time + _STEP)
        if self._twin.time < until:
            return {"func": "_*wait*_", "args": []}
        del self._waiting[client]
        return {"ret": []}


def _listed(value: Any) -> list[Any]:
    """The results of a Lua function: none, one or several."""
    if value is None:
        return []
    return list(value) if isinstance(value, tuple) else [value]
