"""Programs tried in a step of a lesson: contained, in variants of its world and on its robots."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from pathlib import Path
from threading import Lock

from learnblock import robots as known_robots
from learnblock import running
from learnblock.errors import LearnBlockError
from learnblock.evidence.evidence import Evidence, evidence_of
from learnblock.evidence.trace_lines import TraceLines
from learnblock.lessons.expert import Experts, expert_processes
from learnblock.lessons.judging import Verdict, judge
from learnblock.lessons.key_presses import recorded_keys
from learnblock.lessons.lesson import Partner
from learnblock.lessons.opened import OWN_ROBOT, OpenLesson
from learnblock.running import Options, Source
from learnblock.running.batch import Batch
from learnblock.running.job import Job
from learnblock.running.making import Prints
from learnblock.running.result import RunResult
from learnblock.running.team import TeamRun
from learnblock.runtime.ending import How
from learnblock.runtime.limits import Limits
from learnblock.runtime.process import ProcessWorker, Worker
from learnblock.simulator import WorldDescription


@dataclass(frozen=True, slots=True)
class Attempt:
    """What a program is tried in.

    Args:
        robot: the robot.
        variant: the variant of the world; 0 is the world as it is.
        seed: the seed of all noise.
    """

    robot: str
    variant: int
    seed: int = 0


@dataclass(frozen=True, slots=True)
class JudgedRun:
    """The run of an attempt, and what the checks say of it.

    Args:
        attempt: the robot and the variant.
        result: what came of the run.
        evidence: what is known of it.
        verdicts: what the checks say.
    """

    attempt: Attempt
    result: RunResult
    evidence: Evidence
    verdicts: tuple[Verdict, ...]


class StopSwitch:
    """Ends runs at once; it may be used from any thread, and before they begin."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._end: Callable[[], object] | None = None
        self.is_stopped = False

    def stop(self) -> None:
        """End what is running; nothing more begins."""
        with self._lock:
            self.is_stopped = True
            if self._end:
                self._end()

    @contextmanager
    def ends(self, end: Callable[[], object]) -> Iterator[None]:
        """Call `end` if it is stopped within the block, or was before."""
        with self._lock:
            self._end = end
            if self.is_stopped:
                end()
        try:
            yield
        finally:
            with self._lock:
                self._end = None


def attempts(
    opened: OpenLesson,
    step: int,
    *,
    robots: Sequence[str] | None = None,
    variants: int | None = None,
) -> tuple[Attempt, ...]:
    """The attempts of a step: the usual robot in the world as it is, variants, then other robots.

    Args:
        opened: the lesson.
        step: the number of the step.
        robots: the robots; without them those that the step is meant for.
        variants: how many variants, besides the world as it is; without it those of the step.
    """
    robot_names = robots or opened.robots(step)
    count = opened.step(step).variants if variants is None else variants
    return tuple(Attempt(robot, variant) for robot in robot_names for variant in range(count + 1))


def read_program(source: str, filename: str = "program.bt") -> Source:
    """A program from its text.

    Raises:
        ProgramError: it is invalid.
    """
    return running.source_of(Path(filename), source, is_python=filename.endswith(".py"))


def try_step(
    opened: OpenLesson,
    step: int,
    source: str,
    plan: Sequence[Attempt],
    *,
    limits: Limits | None = None,
    filename: str = "program.bt",
    tags: Mapping[str, int] | None = None,
    at_once: int | None = None,
    switch: StopSwitch | None = None,
) -> Iterator[JudgedRun]:
    """Try a program; yield the results as they come. A run that was stopped has none.

    Args:
        opened: the lesson.
        step: the number of the step.
        source: the text of the program.
        plan: the attempts.
        limits: the resources that the program may use.
        filename: its name, which tells its notation.
        tags: the numbers of tags, by name, that it uses besides the user's.
        at_once: how many runs are made at the same time.
        switch: ends them.

    Raises:
        ProgramError: the program is invalid.
        LearnBlockError: a run could not be made, which is not the program's fault.
    """
    program = read_program(source, filename)
    with opened.world_file(step) as world, expert_processes() as processes:
        switch = switch or StopSwitch()
        experts = Experts(opened, processes=processes)
        limits = limits or Limits()
        runs = StepRuns(
            opened, step, program, world, limits, switch, tags=tags or {}, experts=experts
        )
        for attempt, result in runs.results(plan, at_once):
            yield runs.judged(attempt, result)


@dataclass(frozen=True)
class StepRuns:
    """The runs of a program in a step.

    Args:
        opened: the lesson.
        step: the number of the step.
        source: the program.
        world: the name or the path of the world: see `OpenLesson.world_file`.
        limits: the resources that each program may use.
        switch: ends the runs.
        worker: creates the worker of each program of a team; a process by default.
        tags: the numbers of tags, by name, that it uses besides the user's.
        experts: judge by the lesson's Python; without them, each check starts a process.
    """

    opened: OpenLesson
    step: int
    source: Source
    world: str | None
    limits: Limits = Limits()  # noqa: RUF009 - it is frozen
    switch: StopSwitch = field(default_factory=StopSwitch)
    worker: Callable[[], Worker] = ProcessWorker
    tags: Mapping[str, int] = field(default_factory=dict)
    experts: Experts | None = None

    def results(
        self, plan: Sequence[Attempt], at_once: int | None = None
    ) -> Iterator[tuple[Attempt, RunResult]]:
        """Make the runs of attempts, and yield each with its result, as they end.

        Args:
            plan: the attempts.
            at_once: how many runs are made at the same time.

        Raises:
            LearnBlockError: a run could not be made, which is not the program's fault.
        """
        has_partners = bool(self.opened.step(self.step).partners)
        return self._teams(plan) if has_partners else self._batch(plan, at_once)

    def judged(self, attempt: Attempt, result: RunResult) -> JudgedRun:
        """What the checks say of the run of an attempt."""
        step, evidence = self.opened.step(self.step), evidence_of(result)
        experts = self.experts or Experts(self.opened)
        verdicts = judge(step, self.source.tree, evidence, self._described_world, experts)
        return JudgedRun(attempt, result, evidence, verdicts)

    @cached_property
    def _described_world(self) -> WorldDescription | None:
        return self.opened.described_world(self.step)

    def job(self, attempt: Attempt) -> Job:
        """The run of an attempt."""
        job = self._job_of(self.source, attempt.robot, attempt)
        keys = recorded_keys(self.opened.step(self.step).keys)
        return replace(job, program=replace(job.program, tags=self.tags), keys=keys)

    def _job_of(self, source: Source, name: str, attempt: Attempt) -> Job:
        robot = known_robots.find(name)
        options = Options(
            world=self.world,
            seed=attempt.seed,
            pace="free",
            seconds=self.opened.step(self.step).seconds,
            variant=attempt.variant,
        )
        program = running.program(source, robot)
        return Job(program, robot, options, with_trace=True, limits=self.limits)

    def _team(self, attempt: Attempt) -> dict[str, Job]:
        """The runs of all robots of an attempt by their names: the pupil's, and the partners'."""
        partners = self.opened.step(self.step).partners
        others = {partner.name: self._job_of_partner(partner, attempt) for partner in partners}
        return {OWN_ROBOT: self.job(attempt), **others}

    def _job_of_partner(self, partner: Partner, attempt: Attempt) -> Job:
        text = self.opened.program(partner.program)
        return self._job_of(read_program(text, partner.program), partner.robot, attempt)

    def _batch(
        self, plan: Sequence[Attempt], at_once: int | None
    ) -> Iterator[tuple[Attempt, RunResult]]:
        """Make the runs of attempts with one robot, many at once."""
        batch = Batch([*map(self.job, plan)], at_once)
        with self.switch.ends(batch.stop):
            for number, result in batch.results():
                if result.lost:
                    raise LearnBlockError("run-lost", reason=result.lost)
                yield plan[number], result

    def _teams(self, plan: Sequence[Attempt]) -> Iterator[tuple[Attempt, RunResult]]:
        """Make the runs of attempts with partners, one after the other."""
        for attempt in plan:
            if self.switch.is_stopped:
                return
            lines = TraceLines()
            team = self._team(attempt)
            run = TeamRun(team, lines=lines, worker=self.worker, watch=partial(_watcher, team))
            with self.switch.ends(run.stop):
                reports = run.run().robots
            own = reports[OWN_ROBOT]
            if own.ended == How.STOPPED:
                return
            yield attempt, RunResult(own, lines=lines, robot=OWN_ROBOT, team=reports)


def _watcher(team: Mapping[str, Job], robot: str) -> Prints:
    """What presses the keys of a robot of a team."""
    return Prints(team[robot].keys)
