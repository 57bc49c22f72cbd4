"""One program on one robot, from its start to its ending."""

from collections.abc import Callable, Mapping
from functools import partial
from time import thread_time
from typing import Any

from learnblock.client import Client
from learnblock.client.keyboard import KEYS
from learnblock.client.mailbox import checked
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.runtime import messages
from learnblock.runtime.conversation import Conversation, Exchange
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.direct_calls import DirectCalls
from learnblock.runtime.dismissal import cause_of_death, dismiss
from learnblock.runtime.ending import Ending, How
from learnblock.runtime.events import EventSender
from learnblock.runtime.hosted_game import HostedGame
from learnblock.runtime.hosted_robot import HostedRobot, MakeRecorder, MakeRobot, failure
from learnblock.runtime.limits import Limits
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.pauses import Pauses
from learnblock.runtime.post import Post, PostBox
from learnblock.runtime.process import ProcessWorker, Worker
from learnblock.runtime.program import Program
from learnblock.runtime.recorder import Recorder
from learnblock.runtime.status import State
from learnblock.runtime.supervision import Supervision
from learnblock.runtime.validation import Validator, decoded, refused
from learnblock.runtime.variables import VariableReports
from learnblock.runtime.waiting import Waiting
from learnblock.runtime.watcher import Watcher
from learnblock.runtime.world import HostedSimulation, ProgramWorld

#: Seconds of the wall clock that the host waits for a message before it does other work.
TICK = 0.05


class Run:
    """One program on one robot.

    Args:
        program: the program to run.
        make_robot: creates the robot of a module with the program's arguments.
        recorder: creates the recorder, which watches the robot, once there is one.
        watcher: receives the events of the run.
        debugger: pauses the program at lines; without one it never pauses.
        limits: the resources that the program may use.
        worker: creates the worker that runs the program.
        robots: the modules besides ours from which the program may import a ``Robot``.
        network: whether the program may use the network.
        anyway: whether it goes on where it asks for something that the robot lacks.
        box: for messages to and from other robots; without one, the robot is alone.
        log: keeps what the program does; None for no log.
    """

    _wait: Callable[[int], int | None] | None = None  # see `_waiting`

    def __init__(
        self,
        program: Program,
        make_robot: MakeRobot,
        recorder: MakeRecorder,
        *,
        watcher: Watcher | None = None,
        debugger: Debugger | None = None,
        limits: Limits | None = None,
        worker: Callable[[], Worker] = ProcessWorker,
        robots: tuple[str, ...] = (),
        network: bool = False,
        anyway: bool = False,
        box: PostBox | None = None,
        log: RunLog | None = None,
    ) -> None:
        limits = limits or Limits()
        #: None until the run has ended.
        self.ending: Ending | None = None
        #: How the run must end, once that has been decided; any thread may set it.
        self.stopping: Ending | None = None
        #: The step of its world at which the program continues, while it waits for that step.
        self.wake: int | None = None
        self.watcher = watcher or Watcher()
        self.world = ProgramWorld(debugger)
        self.robot = HostedRobot(make_robot, recorder, self.world)
        self.supervision = Supervision(limits, self.robot)
        self.variables = VariableReports(self.watcher)
        self._pauses = Pauses(self.watcher, debugger)
        self._begin = partial(
            _begin,
            program,
            limits,
            robots,
            lambda: Conversation(worker(), debugger, self._validator(program, robots).check),
            network=network,
            anyway=anyway,
            log=log is not None,
            variables=self.variables,
        )
        self._log = log
        self._box = box or Post(1).box(0)
        self._conversation: Conversation | None = None
        #: Whether the program has sent anything yet.
        self._has_sent = False
        #: The devices whose readings the program wants when it wakes.
        self._reads: tuple[int, ...] = ()
        events = EventSender(self.robot, self.watcher)
        self._is_unwatched = not events.shows_lines
        self._handlers = self._make_handlers(events)

    @property
    def client(self) -> Client | None:
        """The robot, once the program has created it."""
        return self.robot.client

    @property
    def recorder(self) -> Recorder | None:
        """The recorded events, once there is a robot."""
        return self.robot.recorder

    @property
    def simulation(self) -> HostedSimulation | None:
        """The world of a simulated robot; None on a real one, and before there is a robot."""
        return self.world.simulation

    def start(self) -> None:
        """Start the program; it needs `serve` to make progress."""
        self._pauses.status.enter(State.STARTING)
        self._conversation = self._begin()

    def serve(self) -> None:
        """Serve the program's requests until it ends or waits for simulated time to pass."""
        self.supervision.note_time()
        with self._talking() as conversation:
            while self.wake is None and self.ending is None:
                message = self._next(conversation)
                if message is not None:
                    self._handle(message)

    def release(self) -> None:
        """Wake the program at the current step of its world; it then has to be served."""
        assert self.simulation is not None  # noqa: S101 - only a simulated program parks
        self.wake = None
        with self._talking() as conversation:
            try:
                readings = [self.robot.call(index, "read", ()) for index in self._reads]
            except LearnBlockError as error:
                conversation.send(failure(error))
            else:
                conversation.send(messages.Answer((self.simulation.steps, readings)))

    def look(self) -> None:
        """Serve debugger and variables while the program waits for its world."""
        with self._talking() as conversation:
            conversation.update_control()
            # A thread of the program may go on while the program itself waits.
            self._end_soon(self.supervision.check_usage(conversation.worker.usage))
            if self.variables.are_due:
                self.variables.request(conversation)
                while self.ending is None and (message := self.variables.wait(conversation)):
                    self._handle(message)

    def stop(self, ending: Ending) -> None:
        """Request the end; it may be called from any thread, and returns at once."""
        self.stopping = self.stopping or ending
        self._pauses.end()
        self.world.end()

    def abort(self) -> None:
        """Kill the program, whatever its host is doing; may be called from any thread."""
        if self._conversation:
            self._conversation.worker.abort()

    def end(self) -> None:
        """End the program now if it has not ended yet, and all processes it has started."""
        if self.ending is None and self._conversation:
            ending = self.stopping or Ending(How.STOPPED, Phrase("run-stopped"))
            self._dismiss(self._conversation, ending)

    def _talking(self) -> Exchange:
        """The conversation; an error in it ends the run."""
        assert self._conversation  # noqa: S101 - the host starts a run first
        return Exchange(self._conversation, self._fail)

    def _fail(self, conversation: Conversation, error: BaseException) -> bool:
        """End the run because of an error in its conversation; return whether it was one."""
        if isinstance(error, EOFError):
            self._finish(
                self.stopping or cause_of_death(conversation.worker, self.supervision.limits)
            )
            return True
        if isinstance(error, LearnBlockError):
            self._finish(Ending(How.ERROR, error.phrase))
            return True
        return False

    def _next(self, conversation: Conversation) -> Any:
        if self.stopping:
            self._dismiss(conversation, self.stopping)
            return None
        conversation.update_control()
        message = conversation.receive(TICK)
        if message is None:
            self.watcher.tick()
            message = conversation.receive_last()
        elif not self._has_sent:
            self._has_sent = True
            self._pauses.status.enter(State.RUNNING)
        if self.supervision.is_due:
            self._end_soon(self.supervision.check(conversation.worker.activity))
            self._end_soon(self.supervision.check_usage(conversation.worker.usage))
            if self.variables.are_due:
                self.variables.request(conversation)
        return message

    def _handle(self, message: Any) -> None:
        if self.recorder:
            # What the program has done before.
            self.recorder.write_noted()
        self._handlers[type(message)](message)

    def _end_soon(self, ending: Ending | None) -> None:
        self.stopping = self.stopping or ending

    def _dismiss(self, conversation: Conversation, ending: Ending) -> None:
        """Make the program end itself, and kill it if it does not."""
        if self.simulation is None:
            # A real robot would keep driving while its program runs its last lines.
            self.robot.stop()
        waits = self.wake is not None or self._pauses.awaits_answer
        conversation.offer(None)
        try:
            ending = dismiss(conversation, ending, waits=waits, handle=self._handle)
        finally:
            self._finish(ending)

    def _finish(self, ending: Ending) -> None:
        """Stop the robot first, then end the program."""
        self.wake = None
        self.robot.stop()
        if self._conversation:
            self._conversation.worker.kill()
        if self.robot.stop_failure and ending.well:
            ending = Ending(How.ERROR, self.robot.stop_failure)
        self.ending = ending
        if self.recorder:
            self.recorder.end(ending.how)
        self._pauses.status.enter(State.ENDED)

    def _send(self, message: messages.Message) -> None:
        assert self._conversation  # noqa: S101 - only a program that has sent a message is answered
        self._conversation.send(message)

    def _validator(self, program: Program, robots: tuple[str, ...]) -> Validator:
        return Validator(
            program,
            robots,
            self.robot,
            self.variables,
            pauses=self._pauses.at_lines,
            log=self._log is not None,
        )

    # One method for each message of the child that concerns more than one part.

    def _make_handlers(self, events: EventSender) -> Mapping[type, Callable[[Any], object]]:
        game = HostedGame(self.robot, self.supervision, self._send)
        return {
            messages.Contained: lambda _: None,
            messages.Ask: self._on_ask,
            messages.Command: self._on_tell,
            messages.Sleep: self._on_sleep,
            messages.Send: self._on_send,
            messages.Collect: self._on_collect,
            messages.Keys: self._on_keys,
            messages.ChangeGame: game.change,
            messages.AskGame: game.answer,
            messages.CollectNews: game.collect,
            messages.Steps: partial(self._on_steps, events),
            messages.Called: events.called,
            messages.Missing: events.missing,
            messages.Printed: partial(self._on_printed, events),
            messages.Logged: self._on_logged,
            messages.Line: self._on_line,
            messages.Input: self._on_input,
            messages.Variables: self.variables.receive,
            messages.Connect: self._on_connect,
            messages.Disconnect: self._on_disconnect,
            # An external signal; the last message says how the program ended.
            messages.Interrupted: lambda _: None,
            messages.Ended: self._on_ended,
        }

    def _on_connect(self, message: messages.Connect) -> None:
        answer = self.robot.connect(message)
        if isinstance(answer, messages.Connected):
            self.supervision.note_call()
            self._wait = self._waiting()
            self._offer()
        self._send(answer)

    def _offer(self) -> None:
        """Offer a program that shares this thread to do at once what takes no time."""
        if self.recorder and self._conversation and self.simulation and self._is_unwatched:
            calls = DirectCalls(self.robot, self.recorder, self._conversation, self._wait)
            self._conversation.offer(calls)

    def _waiting(self) -> Callable[[int], int | None] | None:
        """What lets time pass for this program, if only its run depends on that."""
        is_looked_at = type(self.watcher).tick is not Watcher.tick or self._log is not None
        if self.simulation is None or not self.world.is_private or is_looked_at:
            return None
        return Waiting(self.simulation, self.supervision, self._is_ending).wait

    def _is_ending(self) -> bool:
        """Look around while the program waits; return whether its run is ending."""
        if self._conversation:
            self._end_soon(self.supervision.check_usage(self._conversation.worker.usage))
        return self.stopping is not None or self.variables.enabled

    def _on_disconnect(self, _: messages.Disconnect) -> None:
        if self._conversation:
            self._conversation.offer(None)
        self.robot.stop()

    def _on_ask(self, message: messages.Ask) -> None:
        try:
            value = self.robot.call(message.device, message.function, message.args)
        except LearnBlockError as error:
            self._send(failure(error))
        else:
            self._send(messages.Answer(value))
        self.supervision.note_call()

    def _on_steps(self, events: EventSender, message: messages.Steps) -> None:
        events.steps(message.steps, self._on_tell)

    def _on_tell(self, message: messages.Command) -> None:
        self.robot.call(message.device, message.function, message.args)
        self.supervision.note_call()

    def _on_sleep(self, message: messages.Sleep) -> None:
        assert self.simulation is not None  # noqa: S101 - see `validation`
        self.wake, self._reads = self.simulation.steps + message.steps, message.reads
        # Nothing else waits for this world, and nobody watches it: the answer needs no turn.
        if self._wait and self._wait(message.steps) is not None:
            self.release()

    def _on_send(self, message: messages.Send) -> None:
        name, value = checked(message.name, decoded(message.value))
        self._box.send(name, value, self._step)
        if recorder := self.robot.active_recorder:
            recorder.sent(name, value)

    def _on_collect(self, _: messages.Collect) -> None:
        self._send(messages.Answer(self._box.collect(self._step)))
        self.supervision.note_call()

    def _on_keys(self, _: messages.Keys) -> None:
        recorder = self.robot.active_recorder
        held = self.watcher.held_keys(recorder.time() if recorder else 0.0)
        keys = [key for key in KEYS if key in held]
        if recorder:
            recorder.keys(keys)
        self._send(messages.Answer(keys))
        self.supervision.note_call()

    @property
    def _step(self) -> int | None:
        """The step of the robot's world; None on a real robot."""
        return self.simulation.steps if self.simulation else None

    def _on_line(self, message: messages.Line) -> None:
        self._pauses.hold(message)
        self._continue(messages.Continue())

    def _on_input(self, message: messages.Input) -> None:
        with self.world.running_by_itself(self.supervision.seconds):
            answer = self._pauses.input(message.prompt, stopping=self.stopping is not None)
        if answer is not None:
            self.supervision.note_time()
        self._continue(messages.Answer((answer, self._step)))

    def _continue(self, message: messages.Message) -> None:
        """Answer a waiting program; one that is being stopped gets `Stop` instead."""
        if not self.stopping:
            self._pauses.awaits_answer = False
            self._send(message)

    def _on_printed(self, events: EventSender, message: messages.Printed) -> None:
        excess = self.supervision.check_output(len(message.text))
        self._end_soon(excess)
        if excess is None:
            events.printed(message)
            # So that it ends in the same way however it is run and however fast.
            self.supervision.note_output()

    def _on_logged(self, message: messages.Logged) -> None:
        if self._log and self._conversation:
            began = thread_time()
            self._log.noted(message.first, message.last, message.events)
            self.supervision.note_log(thread_time() - began)
            if not self.supervision.allows_log(self._conversation.worker.activity):
                raise refused("more events than a program can cause")

    def _on_ended(self, message: messages.Ended) -> None:
        if message.variables:
            self.variables.receive(message.variables)
        if message.fault:
            self._finish(_failed(message.fault))
        elif message.stopped:
            line = message.lines[-1] if message.lines else 0
            self._finish(Ending(How.STOPPED, Phrase("run-stopped-by-signal"), line))
        else:
            self._finish(Ending(How.FINISHED, Phrase("run-finished")))


def _begin(
    program: Program,
    limits: Limits,
    robots: tuple[str, ...],
    converse: Callable[[], Conversation],
    *,
    network: bool,
    anyway: bool,
    log: bool,
    variables: VariableReports,
) -> Conversation:
    # The worker first: while it starts, we look for the skills.
    conversation = converse()
    conversation.begin(
        program,
        limits,
        robots,
        network=network,
        anyway=anyway,
        log=log,
        variables=variables.enabled,
    )
    return conversation


def _failed(fault: messages.Fault) -> Ending:
    line = fault.lines[-1] if fault.lines else 0
    return Ending(How.ERROR, fault.phrase, line, fault.file, fault.file_line)
