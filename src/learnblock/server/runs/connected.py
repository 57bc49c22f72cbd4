"""A page's connection to a real robot, as the event loop sees it."""

import asyncio
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import msgspec
from anyio import to_thread

from learnblock.robots import RobotEntry
from learnblock.robots.real import RealRobot
from learnblock.running.connection import RobotConnection
from learnblock.running.hands import ACTIONS, possible
from learnblock.server import messages
from learnblock.server.runs.escalation import happens
from learnblock.server.runs.viewers import Viewer

if TYPE_CHECKING:
    from learnblock.client import Client
    from learnblock.monitor import Monitor

#: Seconds between two reports of what the robot measures.
PERIOD = 0.1


class Connected:
    """A connection of a page to a robot, which it reports to the page.

    Args:
        page: the page.
        id: what the page calls the robot.
        robot: its kind.
        chosen: the settings that reach it.
        on_ended: called once the robot is free again.
    """

    def __init__(
        self,
        page: Viewer,
        id: str,  # noqa: A002 - as in the message
        robot: RobotEntry,
        chosen: Mapping[str, Any],
        on_ended: Callable[["Connected"], object],
    ) -> None:
        self.page = page
        self.id = id
        self.robot = robot
        self.chosen = chosen
        #: Set when the robot is free again, or was given up.
        self.over = asyncio.Event()
        self._on_ended = on_ended
        self._loop = asyncio.get_running_loop()
        self._connection = RobotConnection(robot, chosen, self._changed)
        self._reporting: asyncio.Task[None] | None = None
        self._last: messages.ToPage | None = None

    @property
    def closing(self) -> bool:
        """Whether the robot will be free soon."""
        return self._connection.closing

    @property
    def settings(self) -> Any:
        """The settings of the connected robot; None before it is connected."""
        client = self._connection.client
        return client.settings if isinstance(client, RealRobot) else None

    def start(self) -> None:
        """Begin to connect."""
        self._report()
        self._connection.start()

    def act(self, action: str) -> None:
        """Have the robot do one of its actions; ``stop`` halts it."""
        if action == "stop":
            self._connection.halt()
        elif self._connection.client and action in possible(self._connection.client):
            self._connection.order(action, ACTIONS[action])

    async def close(self, seconds: float) -> None:
        """Disconnect; return once the motors have stopped, or after this many seconds.

        A thread that hangs in its driver is left behind, and the page gets a message.
        """
        self.begin_to_close()
        if not await happens(self.over, seconds):
            self._connection.give_up()
            self._report()

    def begin_to_close(self) -> None:
        """Begin to disconnect; `over` is set once the motors have stopped."""
        self._connection.close()

    def _changed(self) -> None:
        self._loop.call_soon_threadsafe(self._report)

    def _report(self) -> None:
        self._send(self._state())
        if self._connection.ended.is_set():
            self._end()
        elif self._connection.monitor and self._reporting is None:
            self._reporting = asyncio.create_task(self._report_values(self._connection.monitor))

    def _end(self) -> None:
        if self._reporting:
            self._reporting.cancel()
        if not self.over.is_set():
            self.over.set()
            self._on_ended(self)

    def _state(self) -> messages.RobotConnected:
        connection = self._connection
        client = connection.client
        state = messages.RobotConnected(
            state="connecting", id=self.id, robot=self.robot.name, problem=connection.problem
        )
        if connection.ended.is_set():
            if connection.problem is None:
                return messages.RobotConnected("none")
            return msgspec.structs.replace(state, state="lost" if client else "failed")
        if client is None:
            return state
        return msgspec.structs.replace(
            state,
            state="connected",
            doing=connection.doing,
            actions=possible(client),
            corrects=isinstance(client, RealRobot) and client.calibration is not None,
        )

    async def _report_values(self, monitor: "Monitor") -> None:
        client = self._connection.client
        assert client  # noqa: S101 - a monitor has one
        while True:
            values = await to_thread.run_sync(_values, monitor, client)
            if values != self._last:
                self._last = values
                self._send(values)
            await asyncio.sleep(PERIOD)

    def _send(self, message: messages.ToPage) -> None:
        self.page.send(message)


def _values(monitor: "Monitor", client: "Client") -> messages.RobotValues:
    state, link, status = monitor.state(), monitor.link(), client.status()
    robot = state.robots[0]
    silence = client.readings.age() if status.silence is None else status.silence
    return messages.RobotValues(
        sensors=state.sensors,
        joints={key: round(angle, 1) for key, angle in robot.joints.items()},
        speed=robot.speed,
        heading=round(robot.pose[2], 1) if robot.pose else None,
        weak=link.state == "weak",
        quality=_rounded(link.quality),
        # In steps, because noise is not worth a message.
        silence=None if silence is None else round(silence * 100) * 10,
        round_trip=None if status.round_trip is None else round(status.round_trip * 1000),
        battery=_rounded(link.battery),
        charge=_charge(client, link.battery) if status.charge is None else status.charge,
        signal=status.signal,
    )


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, 1)


def _charge(client: "Client", battery: float | None) -> float | None:
    if battery is None or not isinstance(client, RealRobot) or client.battery_range is None:
        return None
    empty, full = client.battery_range
    return round(min(1.0, max(0.0, (battery - empty) / (full - empty))), 2)
