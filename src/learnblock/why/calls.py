"""The call graph of a run: the calls, their number, and their duration in the robot's time.

It has the layers of the paper's figure 8: the program, its functions, the skills, the generic
client, the device interfaces, and the driver's own functions. Only the last one differs between
robots.
"""

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property

from learnblock import devices
from learnblock.runtime.log.events import Op
from learnblock.why.history import CalledSkill, EventHistory, Frame

#: Classes that do not tell one robot from another; "" is that of a function outside any class.
_OF_ANY_ROBOT = frozenset({"", "Robot", "RobotBody"})


class Layer(IntEnum):
    """A row of the graph, from top to bottom."""

    PROGRAM = 0
    FUNCTIONS = 1
    SKILLS = 2
    CLIENT = 3
    DEVICES = 4
    DRIVER = 5


@dataclass(frozen=True, slots=True, order=True)
class Callee:
    """What was called.

    Args:
        layer: its row.
        name: its name there, such as ``move_straight`` or ``Base.move``.
    """

    layer: Layer
    name: str


@dataclass(frozen=True, slots=True)
class CallNode:
    """A function in the graph.

    Args:
        called: which.
        count: the number of its calls.
        seconds: the robot's time spent in it, and in what it called.
        share: that, as a part of the whole span, from 0 to 1.
    """

    called: Callee
    count: int
    seconds: float
    share: float


@dataclass(frozen=True, slots=True)
class Edge:
    """The calls of one function by another.

    Args:
        caller: the calling function.
        callee: the called function.
        count: their number.
        seconds: the robot's time spent in them.
        share: that, as a part of the whole span, from 0 to 1.
        first: the time of the first one, in s.
        last: the time of the last one.
        event: the number of the first one in the log.
    """

    caller: Callee
    callee: Callee
    count: int
    seconds: float
    share: float
    first: float
    last: float
    event: int


@dataclass(frozen=True)
class Calls:
    """The call graph of a span of a run.

    Args:
        robot: the robot's id.
        first: where the span begins, in s.
        last: where it ends.
        edges: the calls, in order of the first one.
    """

    robot: str
    first: float
    last: float
    edges: tuple[Edge, ...]

    @cached_property
    def nodes(self) -> tuple[CallNode, ...]:
        """The functions, by layer and in order of the first call."""
        counts: dict[Callee, int] = defaultdict(int)
        seconds: dict[Callee, float] = defaultdict(float)
        for edge in self.edges:
            counts[edge.callee] += edge.count
            # A function that calls itself spends its time once.
            seconds[edge.callee] += edge.seconds if edge.caller != edge.callee else 0.0
        span = self.last - self.first
        whole = CallNode(self.program, 1, round(span, 3), 1.0)
        others = (
            CallNode(called, count, round(seconds[called], 3), _share(seconds[called], span))
            for called, count in counts.items()
        )
        return (whole, *sorted(others, key=lambda node: node.called.layer))

    @property
    def program(self) -> Callee:
        """The program itself."""
        return self.edges[0].caller if self.edges else Callee(Layer.PROGRAM, "")


def calls(history: EventHistory, first: float = 0.0, last: float | None = None) -> Calls:
    """The call graph of a run.

    Args:
        history: the run.
        first: the beginning of the span, in s.
        last: its end; by default that of the run. In a span that ends before it begins, or begins
            after the run, nothing is called.
    """
    end = history.end if last is None else min(last, history.end)
    edges = _Counting(history, first, end).edges() if first <= end else ()
    return Calls(_robot(history), first, end, tuple(edges))


def _robot(history: EventHistory) -> str:
    return str(history.recorded.conditions.get("robot", ""))


def _share(seconds: float, span: float) -> float:
    return round(min(1.0, seconds / span), 4) if span > 0 else 0.0


@dataclass
class _Sum:
    """The calls of one edge so far."""

    event: int
    first: float
    last: float
    count: int = 0
    seconds: float = 0.0


class _Counting:
    """Counts the calls in a span.

    Args:
        history: the run.
        first: the beginning of the span, in s.
        last: its end.
    """

    def __init__(self, history: EventHistory, first: float, last: float) -> None:
        self._history = history
        self._first, self._last = first, last
        self._sums: dict[tuple[Callee, Callee], _Sum] = {}
        self._drivers: dict[str, str] = history.recorded.robot.get("drivers", {})
        self._robot = _robot(history)
        #: What the driver calls on a robot whose operations have names, by function of a device.
        self._operations: dict[str, list[str]] = defaultdict(list)
        for line in history.recorded.lines:
            if "operation" in line:
                self._operations[line["of"]].append(line["operation"])
        self._count()

    def edges(self) -> Iterator[Edge]:
        for (caller, callee), total in self._sums.items():
            seconds = round(total.seconds, 3)
            share = _share(seconds, self._last - self._first)
            yield Edge(
                caller, callee, total.count, seconds, share, total.first, total.last, total.event
            )

    def _count(self) -> None:
        history = self._history
        for event, ahead in enumerate(history.events):
            if ahead[0] == Op.ENTER:
                self._count_function(event)
            elif ahead[0] == Op.SKILL:
                self._count_skill(event, history.skills[event])
            elif ahead[0] in (Op.COMMAND, Op.READING):
                self._count_device(event, history.skills.get(event))

    def _count_function(self, event: int) -> None:
        frame = self._history.frames[event]
        self._add(self._called(frame.caller), self._called(frame), event, frame.left)

    def _count_skill(self, event: int, use: CalledSkill) -> None:
        caller = _skill(use.within) if use.within else self._called(use.frame)
        self._add(caller, _skill(use), event, use.ended)

    def _count_device(self, event: int, use: CalledSkill | None) -> None:
        history = self._history
        op, device, *more = history.events[event]
        function = more[0] if op == Op.COMMAND else _question(device)
        caller = _skill(use) if use else self._called(history.frames[event])
        kind = device.partition(":")[0]
        client = Callee(Layer.CLIENT, f"{_access(kind, function)}({kind})")
        interface = Callee(Layer.DEVICES, f"{kind}.{function}")
        self._add(caller, client, event, event)
        self._add(client, interface, event, event)
        for name in self._driver_functions(f"{device}.{function}"):
            self._add(interface, Callee(Layer.DRIVER, name), event, event)

    def _driver_functions(self, of: str) -> list[str]:
        """What a function of a device calls on the robot."""
        if of in self._operations:
            return self._operations[of]
        return [_of_robot(self._drivers[of], self._robot)] if of in self._drivers else []

    def _called(self, frame: Frame | None) -> Callee:
        if frame is None or frame.node < 0:
            return Callee(Layer.PROGRAM, self._history.program.name)
        return Callee(Layer.FUNCTIONS, self._history.nodes[frame.node].name)

    def _add(self, caller: Callee, callee: Callee, start: int, end: int) -> None:
        history = self._history
        began = history.time(start)
        over = history.time(end) if end >= 0 else history.end
        if over < self._first or began > self._last:
            return
        times = history.times[start]
        total = self._sums.setdefault((caller, callee), _Sum(start, began, began))
        total.count += times
        total.seconds += times * (min(over, self._last) - max(began, self._first))
        total.last = began


def _skill(use: CalledSkill) -> Callee:
    return Callee(Layer.SKILLS, use.name)


def _question(device: str) -> str:
    return "detect" if device.startswith("Camera:") else "read"


def _access(kind: str, function: str) -> str:
    """The method of the generic client through which a function of a device is called."""
    is_sensor = issubclass(getattr(devices, kind, devices.Device), devices.Sensor)
    return function if is_sensor and function in ("read", "detect") else "device"


def _of_robot(function: str, robot: str) -> str:
    """The name of a driver's function, unique among all robots, such as ``ev3._drive``.

    Every driver has a class `Robot`, and every twin a `RobotBody`: only the robot tells whose
    function it is. A class of another name is the driver's own.
    """
    owner, _, name = function.rpartition(".")
    return f"{robot}.{name}" if owner in _OF_ANY_ROBOT else function
