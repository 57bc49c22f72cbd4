"""The log of a robot in a kernel, about which one can ask."""

import builtins
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from types import MethodType

from learnblock.client import Client
from learnblock.devices import Pose, Sensor
from learnblock.notebook.cell_program import CellProgram
from learnblock.notebook.ways import CellWay
from learnblock.robots.simulated.way import DrivenWay
from learnblock.runtime.lockstep import LockStepClock
from learnblock.runtime.log.blocks import EventBlock
from learnblock.runtime.log.keeping import RunLog, header
from learnblock.runtime.log.noted_calls import noted_function, noted_skill
from learnblock.runtime.log.noting import Noting
from learnblock.runtime.program import Program
from learnblock.runtime.recorder import Recorder, record
from learnblock.runtime.trace import Trace
from learnblock.why import Recorded

#: The file of a kernel's code: each cell has another one, so variables are known as they were set.
_NO_FILE = ""


@dataclass(frozen=True)
class KeptLog:
    """A log to which nothing is added.

    Args:
        blocks: what it has, oldest first.
        complete_since: the oldest detail that it still has, in ticks.
    """

    blocks: tuple[EventBlock, ...]
    complete_since: int


class RobotLog:
    """What a robot does from now on, and what the cells that make it do so decide.

    Args:
        robot: a robot that has just been connected.
        way: its way, which goes on.

    Attributes:
        robot: the robot's name, such as ``sim-ebo``.
    """

    def __init__(self, robot: Client, way: CellWay) -> None:
        self.robot = str(robot.conditions()["robot"])
        self._log = RunLog(Program("notebook", "", ""))
        self._noting = Noting(self._log.noted, _NO_FILE)
        recorder = record(robot, "", Trace(log=self._log), recorder_type=_KernelRecorder)
        if isinstance(recorder, _KernelRecorder):
            recorder.way = way.driven
        robot.observer = _Observer(recorder, self._noting)
        _note_devices(robot, self._noting)
        _note_skills(robot, self._noting)
        if isinstance(robot.clock, LockStepClock):
            robot.clock.note_waits(partial(_wait, self._noting))
        # Of several robots, the cells are those of the last one.
        self._noting.install(vars(builtins))
        self._noting.use_clock(robot.clock)

    def recorded(self, cells: CellProgram) -> Recorded:
        """What has happened so far.

        Args:
            cells: the cells that have run.
        """
        return Recorded.of(self.kept(cells).blocks)

    def kept(self, cells: CellProgram) -> KeptLog:
        """The log so far, as that of a program.

        Args:
            cells: the cells that have run.
        """
        self._noting.flush()
        # The log's own first block knows no program.
        blocks = header(cells.program, cells.nodes), *self._log.blocks[1:]
        return KeptLog(blocks, self._log.complete_since)


class _KernelRecorder(Recorder):
    """A recorder of a robot that may drive for days."""

    way: DrivenWay | None = None

    def pose(self, time: float, pose: Pose) -> None:
        super().pose(time, pose)
        # The log has them, and nothing else is reported here.
        self.path.clear()
        self.marks.clear()
        if self.way:
            self.way.pose(time, pose)


class _Observer:
    """Records what cells do with their robot."""

    def __init__(self, recorder: Recorder, noting: Noting) -> None:
        self._noting = noting
        self.called = recorder.called
        self._missing = recorder.missing

    def missing(self, skill: str, device: str) -> None:
        self._missing(skill, device)
        self._noting.missing(skill, device)


def _note_devices(robot: Client, noting: Noting) -> None:
    for key, device in robot.devices():
        kind = f"{type(device).__name__}:{key}"
        for name, function in device.functions.items():
            device.functions[name] = noted_function(noting, kind, name, function)
        if isinstance(device, Sensor):
            device.read = device.functions["read"]


def _note_skills(robot: Client, noting: Noting) -> None:
    for name, method in [*vars(robot).items()]:
        if isinstance(method, MethodType) and method.__self__ is robot:
            setattr(robot, name, noted_skill(noting, name, method))


def _wait(noting: Noting, wait: Callable[[int], int], steps: int) -> int:
    noting.wait(steps)
    woke = wait(steps)
    noting.woke(woke)
    return woke
