"""A run of several programs on the command line: its output, its state and its report."""

import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, ExitStack, nullcontext
from dataclasses import dataclass, fields, replace
from functools import cached_property
from pathlib import Path
from time import monotonic

import click

from learnblock import running
from learnblock.cli.assignment import Assignment
from learnblock.cli.console import ExitCode, print_json, text, usage_error, warn
from learnblock.cli.interrupts import stopped_by_signals
from learnblock.cli.keyboard import (
    HeldKeys,
    NoKeys,
    RecordedKeyboard,
    listens_to_terminal,
    shared_keyboard,
)
from learnblock.cli.report import decimal, effect_rows, ending_rows, goal_row, print_row, short
from learnblock.cli.reporting import (
    EXIT_CODES,
    STATUS_PERIOD,
    Collector,
    ask,
    check_picture,
    mistakes,
    opened_trace,
    refused_report,
    say_if_not_whole,
    time_limit,
)
from learnblock.errors import FileError, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.project.files.programs import ProgramFile, opened_all, robots_in
from learnblock.robots import RobotEntry
from learnblock.running import MOST_ROBOTS, Job, Options, Report
from learnblock.running.recorded_keys import read_keys_of
from learnblock.running.robot_names import robot_names
from learnblock.running.team import TeamReport, TeamRun
from learnblock.runtime.ending import How
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.program import Program

#: Characters of a name, which is the program's file without its ending.
LONGEST_NAME = 40


@dataclass(frozen=True)
class _Part:
    """A program that was read, and its robots.

    Args:
        file: the program, with what its project says.
        entry: the robot.
        assignment: the program and its robots as the user gave them.
    """

    file: ProgramFile
    entry: RobotEntry
    assignment: Assignment

    @cached_property
    def program(self) -> Program:
        """The program as it runs on the robot."""
        program = running.program(self.file.source, self.entry)
        return replace(program, tags=self.file.tags)


def run_team(
    programs: Sequence[Assignment],
    *,
    robot: str | None,
    world: str | None,
    seed: int | None,
    variant: int | None,
    pace: str | None,
    seconds: float | None,
    trace: Path | None,
    picture: Path | None,
    why: Path | None,
    page: Path | None,
    pupil: str | None,
    keys: Path | None,
    anyway: bool,
    allow_network: bool,
    as_json: bool,
) -> int:
    """Run several programs together, print the report, and return the exit code."""
    robots = sum(program.count * robots_in(program.file) for program in programs)
    if robots > MOST_ROBOTS:
        raise usage_error("report-team-too-many", count=robots, limit=MOST_ROBOTS)
    check_picture(picture)
    with ExitStack() as stack:
        parts = [
            part for program in programs for part in _read(stack, program, robot, as_json=as_json)
        ]
        if _refuse(parts, anyway=anyway, as_json=as_json):
            return ExitCode.MISTAKES
        pace = pace or _needed_pace(parts, is_silent=bool(keys or as_json))
        worlds = (part.file.world for part in parts if part.entry.load().lockstep)
        options = Options(world or next(filter(None, worlds), None), seed, pace, variant=variant)
        options = replace(options, seconds=time_limit(pace, seconds), anyway=anyway)
        jobs = _jobs(parts, options, network=allow_network)
        file = stack.enter_context(opened_trace(trace))
        keyboards = stack.enter_context(_keyboards(jobs, keys, quiet=as_json))
        screen = _Screen(keyboards, quiet=as_json)
        logs = _logs(jobs, why, needed=page is not None)
        session = TeamRun(jobs, trace=file, watch=screen.watcher, logs=logs)
        report = _run(session, screen)
        _print(report, session, screen, as_json=as_json)
        for log in logs.values():
            say_if_not_whole(log)
        if picture:
            _draw(session, picture)
        if page:
            _write_page(page, parts, logs, pupil)
    return _exit_code(report)


def _needed_pace(parts: Sequence[_Part], *, is_silent: bool) -> str | None:
    """The pace that programs need, whether or not they can listen to the terminal; None for any."""
    listens = not is_silent and any(listens_to_terminal(part.program) for part in parts)
    if listens or not all(part.entry.load().lockstep for part in parts):
        # A world at full speed would be over before a real robot or a person has moved.
        return "real"
    return None


def _exit_code(report: TeamReport) -> int:
    """The worst exit code of a program."""
    endings = (How(part.ended) for part in report.robots.values())
    return max(EXIT_CODES.get(how, ExitCode.WELL) for how in endings)


def _keyboards(
    jobs: Mapping[str, Job], keys: Path | None, *, quiet: bool
) -> AbstractContextManager[Mapping[str, HeldKeys]]:
    """The keyboard of each robot whose program may find keys pressed.

    Args:
        jobs: the runs, by the names of the robots.
        keys: a file with recorded keys; None for the terminal's.
        quiet: whether the run does not listen to the terminal, as its output is for a script.
    """
    if keys:
        recorded = read_keys_of(keys, [*jobs])
        return nullcontext({name: RecordedKeyboard(keys) for name, keys in recorded.items()})
    if quiet:
        return nullcontext({})
    return shared_keyboard({name: job.program for name, job in jobs.items()})


def _logs(jobs: Mapping[str, Job], folder: Path | None, *, needed: bool) -> dict[str, RunLog]:
    """The log of each robot, also in a folder if there is one; none if nothing needs them."""
    if folder is None:
        return {name: RunLog(job.program) for name, job in jobs.items()} if needed else {}
    try:
        folder.mkdir(parents=True, exist_ok=True)
        return {name: RunLog(job.program, folder / f"{name}.why") for name, job in jobs.items()}
    except OSError as error:
        raise usage_error("report-why-not-a-folder", folder=str(folder)) from error


class _Screen:
    """What the programs of a run show, and on a terminal a line with the state of the run.

    Args:
        keyboards: those of the robots whose programs may find keys pressed, by name.
        quiet: whether to keep everything for the report.
    """

    #: The run that is shown.
    session: TeamRun | None = None

    def __init__(self, keyboards: Mapping[str, HeldKeys], *, quiet: bool) -> None:
        self.voices: dict[str, _Voice] = {}
        self._keyboards = keyboards
        self._quiet = quiet
        self._live = not quiet and sys.stderr.isatty()
        self._started = self._drawn = monotonic()

    def watcher(self, robot: str) -> "_Voice":
        """What receives the events of the robot with this name."""
        return self.voices.setdefault(robot, _Voice(robot, self, self._keyboards.get(robot)))

    def show(self, line: str) -> None:
        """Print a line of a program."""
        if not self._quiet:
            self.clear()
            click.echo(text(line))

    def ask(self, prompt: str) -> str | None:
        """Ask the person for a line."""
        if self._quiet:
            return None
        self.clear()
        return ask(prompt)

    def typing(self) -> AbstractContextManager[None]:
        """Let the person type a line in the terminal, if programs listen to its keys."""
        keyboard = next(iter(self._keyboards.values()), NoKeys())
        return keyboard.typing()

    def tick(self) -> None:
        """Show the state of the run from time to time."""
        now = monotonic()
        if self._live and self.session and now - self._drawn > STATUS_PERIOD:
            self._drawn = now
            state = self._state(self.session, now)
            click.echo(f"\r\x1b[K{text(state)}", nl=False, err=True)

    def clear(self) -> None:
        """Remove the line with the state."""
        if self._live:
            click.echo("\r\x1b[K", nl=False, err=True)

    def close(self) -> None:
        """Show the lines that have no end, and remove the state."""
        for voice in self.voices.values():
            voice.finish()
        self.clear()

    def _state(self, session: TeamRun, now: float) -> str:
        running = sum(not session.ended(robot) for robot in session.jobs)
        time = session.simulation.time() if session.simulation else now - self._started
        counted = Phrase("report-team-running", count=running, all=len(session.jobs))
        factor = time / max(now - self._started, 0.001)
        speed = Phrase("report-speed", factor=decimal(factor))
        return f"{time:7.1f} s  {text(counted)}  {text(speed)}"


class _Voice(Collector):
    """The output of one program, each line after the name of its robot."""

    def __init__(self, name: str, screen: _Screen, keyboard: HeldKeys | None) -> None:
        super().__init__(keyboard)
        self._name = name
        self._screen = screen
        self._line = ""

    def printed(self, text: str) -> None:
        super().printed(text)
        *lines, self._line = (self._line + text).split("\n")
        for line in lines:
            self._screen.show(f"{self._name}: {line}")

    def input(self, prompt: str) -> str | None:
        self.finish()
        with self._screen.typing():
            return self._screen.ask(f"{self._name}: {prompt}")

    def tick(self) -> None:
        self._screen.tick()

    def finish(self) -> None:
        """Show what was printed without the end of its line."""
        if self._line:
            self._screen.show(f"{self._name}: {self._line}")
            self._line = ""


def _read(
    stack: ExitStack, assignment: Assignment, robot: str | None, *, as_json: bool
) -> Sequence[_Part]:
    try:
        files = stack.enter_context(opened_all(assignment.file, warn))
    except FileError as error:
        if as_json:
            _print_refused(assignment, refused_report(str(assignment.file), error.diagnostics))
        raise
    robot_name = assignment.robot or robot
    return [
        _Part(file, running.choose_robot(file.source, robot_name or file.robot), assignment)
        for file in files
    ]


def _refuse(parts: Sequence[_Part], *, anyway: bool, as_json: bool) -> bool:
    """Print what the check finds in the programs; return whether one of them may not run."""
    refused = False
    for part in parts:
        source = part.file.source
        errors = mistakes(source, part.entry, anyway=anyway, quiet=as_json)
        if errors and as_json and not refused:
            _print_refused(part.assignment, refused_report(str(source.path), errors))
        refused = refused or bool(errors)
    return refused


def _print_refused(assignment: Assignment, report: Report) -> None:
    identity = {"name": _stem(assignment), "program": assignment.file.name}
    row = {**identity, "robot": assignment.robot, **_own(report)}
    print_json({"robots": [row], "goals": (), "trace_sha256": None})


def _jobs(parts: Sequence[_Part], options: Options, *, network: bool) -> dict[str, Job]:
    """The runs of all robots, by their names."""
    jobs = []
    for part in parts:
        may = network or running.may_use_network(part.assignment.file)
        job = Job(part.program, part.entry, replace(options, network=may))
        jobs += [job] * _count(part)
    names = robot_names([_name(part) for part in parts for _ in range(_count(part))])
    return dict(zip(names, jobs, strict=True))


def _count(part: _Part) -> int:
    return part.assignment.count * part.file.count


def _name(part: _Part) -> str:
    return part.file.name or _stem(part.assignment)


def _stem(assignment: Assignment) -> str:
    return assignment.file.stem[:LONGEST_NAME]


def _run(session: TeamRun, screen: _Screen) -> TeamReport:
    screen.session = session
    with stopped_by_signals(session.stop):
        report = session.run()
    screen.close()
    return report


def _print(report: TeamReport, session: TeamRun, screen: _Screen, *, as_json: bool) -> None:
    if as_json:
        print_json(_as_object(report, session, screen))
        return
    for name, robot_report in report.robots.items():
        click.echo(name, err=True)
        for label, value in _rows(session.jobs[name], robot_report):
            print_row(label, value)
    click.echo(err=True)
    for goal in report.goals:
        print_row("report-label-goal", goal_row(goal))
    differs = text(Phrase("report-team-not-deterministic"))
    print_row("report-label-trace", short(report.trace_sha256 or "") or differs)


def _rows(job: Job, report: Report) -> Iterator[tuple[str, str]]:
    """The rows of one robot: the code of the label, and the value."""
    yield from ending_rows(report, job.options.seconds)
    if report.pose:
        yield "report-label-pose", "({:.0f}, {:.0f}) mm, {:.0f}°".format(*report.pose)
    yield from effect_rows(report, job.robot.name)


def _as_object(report: TeamReport, session: TeamRun, screen: _Screen) -> dict[str, object]:
    return {
        "robots": [
            _robot_as_object(
                name, session.jobs[name], replace(robot_report, output=screen.voices[name].output)
            )
            for name, robot_report in report.robots.items()
        ],
        "goals": list(report.goals),
        "trace_sha256": report.trace_sha256,
    }


def _robot_as_object(name: str, job: Job, report: Report) -> dict[str, object]:
    identity = {"name": name, "program": job.program.name, "robot": job.robot.name}
    return {**identity, **_own(report)}


def _own(report: Report) -> dict[str, object]:
    """The part of a report about one robot, as opposed to the whole run."""
    whole = {"goals", "trace_sha256"}
    return {
        field.name: getattr(report, field.name)
        for field in fields(report)
        if field.name not in whole
    }


def _write_page(
    path: Path, parts: Sequence[_Part], logs: Mapping[str, RunLog], pupil: str | None
) -> None:
    """Write the page of the run, which shows all robots."""
    from learnblock.cli.take_home import robot_run, write_page  # noqa: PLC0415 - slow to load

    owners = [part for part in parts for _ in range(_count(part))]
    runs = [
        robot_run(part.file.source, part.entry, log)
        for part, log in zip(owners, logs.values(), strict=True)
    ]
    stems = dict.fromkeys(_stem(part.assignment) for part in parts)
    write_page(path, runs, ", ".join(stems), pupil)


def _draw(session: TeamRun, path: Path) -> None:
    from learnblock.robots.simulated import draw  # noqa: PLC0415 - only a simulated world is drawn

    recordings = {}
    for name in session.jobs:
        client, recorder = session.client(name), session.recorder(name)
        if client and recorder:
            recordings[name] = client, recorder
    if not recordings:
        raise LearnBlockError("report-no-picture")
    programs = ", ".join(dict.fromkeys(job.program.name for job in session.jobs.values()))
    draw(recordings, path, programs)
    print_row("report-label-picture", str(path))
