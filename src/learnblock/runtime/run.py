"""One program on one robot: what its child asks for, and how it ends."""

import signal
import threading
from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from dataclasses import replace
from functools import partial
from time import monotonic
from typing import Any, Protocol

from learnblock import skills
from learnblock.client import Client
from learnblock.devices import Base, Device, Sensor
from learnblock.errors import LearnBlockError, RobotConnectionError, RobotStoppedError
from learnblock.runtime import messages
from learnblock.runtime.brake import Brake
from learnblock.runtime.debugger import Debugger, Holdable
from learnblock.runtime.ending import Ending, How
from learnblock.runtime.limits import MEGABYTE, Limits
from learnblock.runtime.messages import Fault
from learnblock.runtime.pacing import Pacing
from learnblock.runtime.process import ProcessWorker, Worker
from learnblock.runtime.program import Program
from learnblock.runtime.status import State, Status
from learnblock.runtime.trace import Recorder
from learnblock.runtime.watcher import Watcher

#: How long, in seconds of the wall clock, a silent program waits to be looked after.
TICK = 0.05
#: Variables are told no more often than every so many seconds of the wall clock, and a program that
#: waits for its world is given so many to tell them.
VARIABLES_PERIOD = 0.2
VARIABLES_PATIENCE = 0.2
#: How long a program that is told to stop may take for its own `finally`.
GRACE = 0.4

MakeRobot = Callable[[str, dict[str, Any]], Client]


class Simulation(Protocol):
    """A simulated world as the host needs it."""

    dt: float
    seed: int
    pacing: Pacing
    #: Held during each step and each call of a device: others may look at the world meanwhile.
    lock: AbstractContextManager[object]

    @property
    def steps(self) -> int:
        """The steps made so far."""

    def advance(self, step: int) -> None:
        """Make steps until `steps` is `step`."""


class Run:
    """One program on one robot.

    Args:
        program: what to run.
        make_robot: makes the robot of a module with the arguments the program gave.
        recorder: makes the recorder, which watches the robot, once there is one.
        watcher: is told what happens.
        debugger: holds the program at lines; without one it runs undisturbed.
        limits: what the program may use.
        worker: makes what runs the program.
    """

    def __init__(
        self,
        program: Program,
        make_robot: MakeRobot,
        recorder: Callable[[Client], Recorder],
        *,
        watcher: Watcher | None = None,
        debugger: Debugger | None = None,
        limits: Limits | None = None,
        worker: Callable[[], Worker] = ProcessWorker,
        robots: tuple[str, ...] = (),
    ) -> None:
        self.program = program
        self.ending: Ending | None = None
        self.client: Client | None = None
        self.recorder: Recorder | None = None
        #: The step at which it goes on, while it waits for its world.
        self.wake: int | None = None
        #: The devices whose readings it then wants.
        self._reads: tuple[int, ...] = ()
        #: Whether it waits for something else that we have to say.
        self._waits = False
        #: How it is to end, once that has been asked for.
        self.stopping: Ending | None = None
        self._make_robot = make_robot
        self._make_recorder = recorder
        self.watcher = watcher or Watcher()
        self._debugger = debugger
        self._limits = limits or Limits()
        self._make_worker = worker
        self._robots = robots
        self._functions: list[dict[str, Callable[..., Any]]] = []
        #: Seconds of a real robot's time after which the run ends; None for no limit.
        self.seconds: float | None = None
        #: Whether the watcher is told the variables some times a second; may be set by any thread.
        self.tells_variables = False
        self._asked_variables = False
        self._last_variables = 0.0
        self._simulation: Simulation | None = None
        self._connecting = threading.Lock()
        self._speed: tuple[float | None] | None = None
        self._heard = False
        self._status = Status(self.watcher.state)
        self._control = messages.Control()
        if debugger:
            self._control = debugger.control
            debugger.report_to(self._status)
        self._not_stopped = ""
        self._printed = 0
        self._last_call = self._last_look = 0.0

    @property
    def simulation(self) -> Simulation | None:
        """The world of a simulated robot; None on a real one, and before there is a robot."""
        return self._simulation

    @property
    def _exclusive(self) -> AbstractContextManager[object]:
        """Within it nobody else touches the world of a simulated robot."""
        return self._simulation.lock if self._simulation else nullcontext()

    @property
    def _awaits_us(self) -> bool:
        """Whether the program waits for an answer: that its time has come, or its line."""
        return self.wake is not None or self._waits

    def start(self) -> None:
        """Start the program; it goes nowhere until served."""
        self._status.enter(State.STARTING)
        # First: it takes its time to begin, in which we look for the skills.
        self._worker = self._make_worker()
        self._link = self._worker.link
        self._link.send(
            messages.Setup(
                source=self.program.python,
                filename=self.program.name,
                folder=self.program.folder,
                skills=_skills(self.program.names),
                robots=self._robots,
                debug=self._control if self._debugger else None,
                limits=self._limits,
            )
        )

    def serve(self) -> None:
        """Do what the program asks until it waits for its world's time, or ends."""
        self._last_call = monotonic()
        with self._ending_in_words():
            while self.wake is None and self.ending is None:
                message = self._next()
                if message is not None:
                    self._handle(message)

    def release(self) -> None:
        """Wake the program at its world's present step; it then wants to be served."""
        assert self.simulation is not None  # noqa: S101 - only a simulated program parks
        self.wake = None
        with self._ending_in_words():
            try:
                readings = [self._call(messages.Ask(index, "read", ())) for index in self._reads]
            except LearnBlockError as error:
                self._send(_failure(error))
            else:
                self._answer((self.simulation.steps, readings))

    def look(self) -> None:
        """See to those who watch and control, while the program waits for its world."""
        self.watcher.tick()
        with self._ending_in_words():
            self._tell_control()
            if self._wants_variables():
                self._ask_variables()
                self._await_variables()

    def set_speed(self, factor: float | None) -> None:
        """How fast the world runs, times real time, None for as fast as it goes; from any thread.

        Before there is a world, it is how fast that one will.
        """
        with self._connecting:
            self._speed = (factor,)
            if self._simulation:
                self._simulation.pacing.set_factor(factor)

    def stop(self, ending: Ending) -> None:
        """Ask for the end; it may be called from any thread, and returns at once."""
        self.stopping = self.stopping or ending
        if self._debugger:
            self._debugger.end()
        if self.simulation:
            self.simulation.pacing.end()
        self.watcher.cancel_input()

    def end(self) -> None:
        """End it now if it has not ended by itself; nothing of it is left then."""
        if self.ending is None and hasattr(self, "_worker"):
            self._dismiss(self.stopping or Ending(How.STOPPED, "the program was stopped"))

    @contextmanager
    def _ending_in_words(self) -> Iterator[None]:
        """Whatever goes wrong within it ends the run with a sentence."""
        try:
            yield
        except EOFError:
            self._finish(self.stopping or self._death())
        except LearnBlockError as error:
            self._finish(Ending(How.ERROR, str(error)))

    # Sending.

    def _send(self, message: messages.Message) -> None:
        self._tell_control()
        self._link.send(message)

    def _answer(self, value: Any) -> None:
        self._send(messages.Answer(value))

    def _tell_control(self) -> None:
        """Tell the program where it is to be held, if that has changed."""
        if self._debugger and self._debugger.control is not self._control:
            self._control = self._debugger.control
            self._mention(self._control)

    def _mention(self, message: messages.Message) -> None:
        """Say what the program may hear at any time."""
        # It may have ended meanwhile: how, is what we hear next.
        with suppress(EOFError):
            self._link.send(message)

    def _wants_variables(self) -> bool:
        return self.tells_variables and monotonic() - self._last_variables > VARIABLES_PERIOD

    def _ask_variables(self) -> None:
        self._last_variables = monotonic()
        if not self._asked_variables:
            self._asked_variables = True
            self._mention(messages.ShowVariables())

    def _await_variables(self) -> None:
        deadline = monotonic() + VARIABLES_PATIENCE
        while self._asked_variables and (left := deadline - monotonic()) > 0:
            message = self._link.receive(left)
            if message is not None:
                self._handle(message)

    # Receiving.

    def _next(self) -> Any:
        if self.stopping:
            self._dismiss(self.stopping)
            return None
        self._tell_control()
        message = self._link.receive(TICK)
        if message is None:
            self.watcher.tick()
            if self._worker.wait(0) is not None:
                message = self._last_words()
        elif not self._heard:
            self._heard = True
            self._status.enter(State.RUNNING)
        if monotonic() - self._last_look > TICK:
            self._look_after_time()
            if self._wants_variables():
                self._ask_variables()
        return message

    def _last_words(self) -> Any:
        """What the program still said between our last look and its end."""
        message = self._link.receive_now()
        if message is None:
            raise EOFError("the program's process is gone")
        return message

    def _handle(self, message: Any) -> None:
        _HANDLERS[type(message)](self, message)

    def _look_after_time(self) -> None:
        self._last_look = monotonic()
        silent = self._last_look - self._last_call
        if self.client is None:
            self._look_after_preparation(silent)
        elif self.simulation is None:
            # On a real robot thinking long is no fault, but its time goes on.
            if not self.client.stopped:
                self.client.check_link()
            self._look_after_limit(self.client)
        elif silent > self._limits.silence:
            self._end_soon(
                How.NO_CALL,
                f"the program made no call to the robot for {self._limits.silence:g} s and was"
                " stopped: does a loop in it lack a `sleep`?",
            )

    def _look_after_preparation(self, silent: float) -> None:
        if silent > self._limits.preparation:
            self._end_soon(
                How.NO_CALL,
                f"the program had not made its robot after {self._limits.preparation:g} s and was"
                " stopped: does it come to its `Robot()`?",
            )

    def _look_after_limit(self, client: Client) -> None:
        if self.seconds is not None and client.clock.time() >= self.seconds:
            self.stopping = self.stopping or Ending.time_is_up(self.seconds)

    def _end_soon(self, how: How, sentence: str) -> None:
        self.stopping = self.stopping or Ending(how, sentence)

    def _dismiss(self, ending: Ending) -> None:
        """Have the program end itself, and kill it if it does not."""
        if self.simulation is None:
            # A real robot would drive on while its program says its last words.
            self._stop_robot()
        try:
            if self._awaits_us:
                self._link.send(messages.Stop(ending.sentence))
            else:
                self._worker.interrupt()
            ending = self._drain(ending)
        except (EOFError, LearnBlockError):
            # It died first, or speaks nonsense; either way it is over.
            pass
        finally:
            self._finish(ending)

    def _drain(self, ending: Ending) -> Ending:
        """Hear what it did before it was told, and how it ends; what it still asks is refused."""
        deadline = monotonic() + GRACE
        told = self._awaits_us
        while (left := deadline - monotonic()) > 0:
            match self._link.receive(left):
                case messages.Ended(lines=lines):
                    return replace(ending, line=lines[-1] if lines else ending.line)
                case messages.Interrupted(line, file, file_line):
                    told = True
                    ending = replace(ending, line=line, file=file, file_line=file_line)
                case messages.Ask() | messages.Sleep() | messages.Input() | messages.Line():
                    self._link.send(messages.Stop(ending.sentence))
                case messages.Connect() | messages.Disconnect() | None:
                    continue
                case event if not told:
                    self._handle(event)
        return ending

    def _death(self) -> Ending:
        status = self._worker.wait(GRACE)
        if status is None:
            return Ending(How.KILLED, "the program cut its link to the robot and was killed")
        if status < 0:
            return Ending(How.KILLED, self._cause(-status))
        return Ending(How.KILLED, f"the program's process ended by itself with status {status}")

    def _cause(self, number: int) -> str:
        if number == getattr(signal, "SIGXCPU", None):
            return f"the program used more than {self._limits.cpu} s of processor time"
        try:
            name = signal.Signals(number).name
        except ValueError:
            # A real-time signal: most of these have no name.
            name = str(number)
        return f"the program was killed by the signal {name}"

    def _finish(self, ending: Ending) -> None:
        """The robot first: its motors stop whatever becomes of the program."""
        self.wake = None
        self._stop_robot()
        self._worker.kill()
        if self._not_stopped and ending.well:
            ending = Ending(How.ERROR, self._not_stopped)
        self.ending = ending
        if self.recorder:
            self.recorder.end(ending.how)
        self._status.enter(State.ENDED)

    def _stop_robot(self) -> None:
        if self.client:
            try:
                with self._exclusive:
                    self.client.stop()
            except Exception as error:  # noqa: BLE001 - a driver may raise whatever it likes
                self._not_stopped = f"the robot could not be stopped: {_told(error)}"

    # One method for each message of the child.

    def _on_connect(self, message: messages.Connect) -> None:
        if self.client and not self.client.stopped:
            raise LearnBlockError("the program asked for a second robot before it let go of one")
        try:
            self.client = self._make_robot(message.module, message.arguments)
        except Exception as error:  # noqa: BLE001 - a driver may raise whatever it likes
            self._send(_failure(error))
            return
        self._enter_world(self.client)
        self.recorder = self._make_recorder(self.client)
        # Only now: the recorder has put itself between the devices and their functions.
        self._functions = [
            _functions(self.client, key, device) for key, device in self.client.devices()
        ]
        self._send(self._offer(self.client))
        self._last_call = monotonic()

    def _enter_world(self, client: Client) -> None:
        with self._connecting:
            self._simulation = vars(client).get("simulation")
            if self._simulation and self._speed:
                self._simulation.pacing.set_factor(*self._speed)
            if self._debugger:
                self._debugger.govern(self._held_with(client))

    def _held_with(self, client: Client) -> Holdable:
        if self._simulation:
            return self._simulation.pacing
        return Brake([device for _, device in client.devices() if isinstance(device, Base)])

    def _offer(self, client: Client) -> messages.Connected:
        devices = tuple(
            messages.DeviceOffer(type(device).__name__, key, tuple(device.functions))
            for key, device in client.devices()
        )
        simulation = self.simulation
        if simulation is None:
            return messages.Connected(devices, None, 0.0, None)
        return messages.Connected(devices, simulation.steps, simulation.dt, simulation.seed)

    def _on_ask(self, message: messages.Ask) -> None:
        try:
            self._answer(self._call(message))
        except LearnBlockError as error:
            self._send(_failure(error))
        self._last_call = monotonic()

    def _on_tell(self, message: messages.Tell) -> None:
        self._call(message)
        self._last_call = monotonic()

    def _call(self, message: messages.Ask | messages.Tell) -> Any:
        if self.client and self.client.stopped:
            # Only through a device the program has kept: the client in the child refuses the rest.
            raise RobotStoppedError(
                "the robot has been stopped: nothing can be asked of it any more"
            )
        try:
            with self._exclusive:
                return self._functions[message.device][message.function](*message.args)
        except LearnBlockError:
            raise
        except Exception as error:
            # A driver is someone else's code: whatever it raises, the run ends with a sentence.
            raise RobotConnectionError(
                f"the robot failed to {message.function}: {type(error).__name__}: {error}"
            ) from error

    def _on_sleep(self, message: messages.Sleep) -> None:
        if self.simulation is None:
            raise LearnBlockError("only the program of a simulated robot waits for its world")
        self.wake = self.simulation.steps + max(1, message.steps)
        self._reads = message.reads

    def _on_disconnect(self, message: messages.Disconnect) -> None:  # noqa: ARG002
        self._stop_robot()

    @property
    def _recording(self) -> Recorder | None:
        """The recorder while there is a robot whose time its lines can have."""
        return None if self.client is None or self.client.stopped else self.recorder

    def _on_lines(self, message: messages.Lines) -> None:
        if self._recording:
            self._recording.lines(message.numbers)
        for number in message.numbers:
            self.watcher.line(number)

    def _on_line(self, message: messages.Line) -> None:
        reached = monotonic()
        self._waits = True
        if self._debugger and self._debugger.holds(message.number, message.depth):
            self._hold(self._debugger, message)
        # While it was held the program could make no call.
        self._last_call += monotonic() - reached
        self._go_on(messages.Continue())

    def _hold(self, debugger: Debugger, message: messages.Line) -> None:
        self._status.enter(State.HELD)
        self.watcher.held(message.number, message.variables)
        debugger.wait()
        self.watcher.resumed()
        self._status.leave(State.HELD)

    def _go_on(self, message: messages.Message) -> None:
        """Let a program that waits go on; one that is being stopped hears that instead."""
        if not self.stopping:
            self._waits = False
            self._send(message)

    def _on_called(self, message: messages.Called) -> None:
        if self._recording:
            self._recording.called(message.skill, message.args, message.kwargs)

    def _on_missing(self, message: messages.Missing) -> None:
        if self._recording:
            self._recording.missing(message.skill, message.device)

    def _on_printed(self, message: messages.Printed) -> None:
        self._printed += len(message.text)
        if self._printed > self._limits.output:
            self._end_soon(
                How.OUTPUT_LIMIT,
                f"the program printed more than {self._limits.output / MEGABYTE:g} MB and was"
                " stopped: does a loop in it print without waiting?",
            )
            return
        if self._recording:
            self._recording.printed(message.text)
        self.watcher.printed(message.text)

    def _on_input(self, message: messages.Input) -> None:
        self._waits = True
        self._status.enter(State.INPUT)
        answer = None if self.stopping else self.watcher.input(message.prompt)
        self._status.leave(State.INPUT)
        self._last_call = monotonic()
        self._go_on(messages.Answer(answer))

    def _on_interrupted(self, message: messages.Interrupted) -> None:
        """A signal from outside; its last message tells the rest."""

    def _on_variables(self, message: messages.Variables) -> None:
        self._asked_variables, self._last_variables = False, monotonic()
        if self.tells_variables:
            self.watcher.variables(message)

    def _on_ended(self, message: messages.Ended) -> None:
        if message.fault:
            self._finish(_failed(message.fault))
        elif message.stopped:
            line = message.lines[-1] if message.lines else 0
            self._finish(Ending(How.STOPPED, "the program was stopped by a signal", line))
        else:
            self._finish(Ending(How.FINISHED, "the program finished"))


_HANDLERS: Mapping[type, Callable[[Run, Any], None]] = {
    messages.Connect: Run._on_connect,  # noqa: SLF001 - the class's own table
    messages.Ask: Run._on_ask,  # noqa: SLF001
    messages.Tell: Run._on_tell,  # noqa: SLF001
    messages.Sleep: Run._on_sleep,  # noqa: SLF001
    messages.Disconnect: Run._on_disconnect,  # noqa: SLF001
    messages.Lines: Run._on_lines,  # noqa: SLF001
    messages.Line: Run._on_line,  # noqa: SLF001
    messages.Called: Run._on_called,  # noqa: SLF001
    messages.Missing: Run._on_missing,  # noqa: SLF001
    messages.Printed: Run._on_printed,  # noqa: SLF001
    messages.Input: Run._on_input,  # noqa: SLF001
    messages.Variables: Run._on_variables,  # noqa: SLF001
    messages.Interrupted: Run._on_interrupted,  # noqa: SLF001
    messages.Ended: Run._on_ended,  # noqa: SLF001
}


def _skills(names: Collection[str]) -> tuple[str, ...]:
    """Those of `names` that are skills, so that the child need not search all that is installed."""
    try:
        return tuple(sorted(skills.find(names)))
    except LearnBlockError:
        # The child finds the same error, and tells it at the program's own line.
        return tuple(names)


def _told(error: Exception) -> str:
    """An error as words: ours speak for themselves, others say what they are."""
    return str(error) if isinstance(error, LearnBlockError) else f"{type(error).__name__}: {error}"


def _failed(fault: Fault) -> Ending:
    line = fault.lines[-1] if fault.lines else 0
    sentence = f"{fault.type}: {fault.text}" if fault.text else fault.type
    return Ending(How.ERROR, sentence, line, fault.file, fault.file_line)


def _failure(error: Exception) -> messages.Failed:
    if isinstance(error, LearnBlockError):
        return messages.Failed(type(error).__name__, str(error))
    return messages.Failed(RobotConnectionError.__name__, _told(error))


def _functions(client: Client, key: str, device: Device) -> dict[str, Callable[..., Any]]:
    """What a child may call: a sensor is read through the client, which polls those in use."""
    if not isinstance(device, Sensor):
        return device.functions
    functions: dict[str, Callable[..., Any]] = {
        name: partial(_change, client, function) for name, function in device.functions.items()
    }
    functions["read"] = partial(client.read, type(device), key)
    if "detect" in functions:
        functions["detect"] = partial(client.detect, key=key)
    return functions


def _change(client: Client, function: Callable[..., Any], *args: Any) -> Any:
    """Tell a sensor something, such as a new zero, which makes its last reading wrong."""
    try:
        return function(*args)
    finally:
        client.forget_readings()
