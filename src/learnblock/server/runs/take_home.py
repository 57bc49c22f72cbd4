"""A run as the content of a page in one file: all moments, questions and answers that it shows."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import ceil
from typing import Any

from msgspec.structs import replace

from learnblock.blocks.known import all_configurations
from learnblock.blocks.palette import palette
from learnblock.errors import LearnBlockError
from learnblock.project.document.document import Document
from learnblock.server import messages
from learnblock.server.runs.kept import lines_now, printed, scene_of
from learnblock.server.runs.looking import Log, Looking
from learnblock.server.runs.one_world import plain, shared_states, thinned
from learnblock.standalone.page import filled
from learnblock.why.recorded import Recorded

#: Moments in every second of a short run, the most of a long one for all robots together, and the
#: most lines between two: few enough for a file of 2 MB.
RATE, MOST, LINES = 20, 600, 1
#: The most moments at which it says what the robot is doing.
MOST_NOW = 60

#: The most bytes of a page, and the fewest moments with which it still shows a run.
LARGEST, FEWEST = 2_000_000, 20


@dataclass(frozen=True)
class Titles:
    """What the page is called.

    Args:
        program: the name of the program.
        language: of the page, such as ``es``.
        pupil: who made it, if the page is to say so; else empty.
    """

    program: str
    language: str
    pupil: str = ""


@dataclass(frozen=True)
class RobotRun:
    """A robot of the run.

    Args:
        log: of its run, which has ended.
        document: its program.
        kind: the name of its kind, such as ``sim-ebo``.
    """

    log: Log
    document: Document
    kind: str


def run_page(robots: Sequence[RobotRun], titles: Titles, begin: float = 0.0) -> str:
    """The page that shows a run, with fewer moments if it would be too large.

    Args:
        robots: the robots of the run; those that were in no simulated world are left out.
        titles: what the page is called.
        begin: the time in s from which on the run is shown.

    Raises:
        LearnBlockError: the run was not in a world that can be shown, was of another program, or
            is too large.
    """
    content = run_content(robots, titles, begin)
    while len(page := filled(content)) > LARGEST:
        if len(content["states"]) < FEWEST:
            raise LearnBlockError("take-home-too-large", most=LARGEST // 1_000_000)
        content = thinned(content)
    return page


def run_content(robots: Sequence[RobotRun], titles: Titles, begin: float = 0.0) -> dict[str, Any]:
    """The content of `run_page`, of any size: see `frontend/src/features/standalone/content.ts`."""
    all_recorded = [(robot, Recorded.of(robot.log.blocks)) for robot in robots]
    shown = [(robot, recorded) for robot, recorded in all_recorded if "world" in recorded.robot]
    if not shown:
        raise LearnBlockError("take-home-no-world")
    looks = [_looking(robot, recorded, titles.program) for robot, recorded in shown]
    timelines = [_from(begin, looking.timeline()) for looking in looks]
    interval = _interval(timelines)
    contents = [
        {**_about(robot, recorded), **_recording(looking, timeline, interval)}
        for (robot, recorded), looking, timeline in zip(shown, looks, timelines, strict=True)
    ]
    return {
        "kind": "run",
        "language": titles.language,
        "title": titles.program,
        "pupil": titles.pupil.strip(),
        "palette": palette(all_configurations(), titles.language),
        "scene": scene_of(shown[0][1]),
        "states": shared_states(contents),
        "robots": contents,
    }


def _looking(robot: RobotRun, recorded: Recorded, name: str) -> Looking:
    """Looks back at a robot's run.

    Raises:
        LearnBlockError: the run was of another program.
    """
    then, now = recorded.program, robot.document.program(name)
    if then.identity != now.identity:
        raise LearnBlockError("take-home-changed")
    blocks = [robot.document.block_at(line) for line in lines_now(then.python, now.python)]
    return Looking(robot.log, blocks)


def _interval(timelines: Sequence[messages.Timeline]) -> float:
    """The time in s between two even times, which are the same for all robots."""
    longest = max(timeline.end - timeline.begin for timeline in timelines)
    most = max(MOST_NOW, MOST // len(timelines))
    return longest / min(most, max(1, round(longest * RATE))) or 1 / RATE


def _about(robot: RobotRun, recorded: Recorded) -> dict[str, Any]:
    """A robot with its program, as they are all the time."""
    document, scene = robot.document, scene_of(recorded)
    return {
        "name": recorded.name,
        "robot": robot.kind,
        "workspace": document.workspace,
        "blocktext": document.blocktext,
        "python": document.python,
        "places": document.places,
        "cameras": scene.cameras,
        "start": scene.start,
        "printed": printed(recorded),
    }


def _recording(looking: Looking, timeline: messages.Timeline, interval: float) -> dict[str, Any]:
    """All moments of a robot, and all answers about it."""
    looking.wait_until_prepared()
    even = [looking.past(request) for request in _requests(looking, timeline, interval)]
    questions = _questions(looking, timeline.begin)
    answers = list(_answers(looking, questions, timeline, even))
    all_moments = [*even, *_moments_of(looking, answers)]
    all_moments.sort(key=lambda moment: (moment.time, moment.event))
    moments, drawing = _without_drawings(all_moments)
    return {
        "timeline": timeline,
        "moments": moments,
        "drawing": drawing,
        "questions": questions,
        "answers": answers,
    }


def _from(begin: float, timeline: messages.Timeline) -> messages.Timeline:
    """The part of a timeline from a time in s on."""
    marks = tuple(mark for mark in timeline.marks if mark.time >= begin)
    way = tuple(point for point in timeline.way if point[0] >= begin)
    return replace(timeline, begin=begin, marks=marks, way=way)


def _requests(
    looking: Looking, timeline: messages.Timeline, interval: float
) -> Iterator[messages.LookBack]:
    """The moments to show, in order: at even times, and at lines between them."""
    begin, end = timeline.begin, timeline.end
    now = messages.LookBack(begin, None if begin else -1)
    yield now
    count = ceil((end - begin) / interval - 1e-6)
    for time in (*(begin + interval * number for number in range(1, count)), end):
        for _ in range(LINES):
            # Only asked for: a world that has run beyond the next even time would begin again.
            line = looking.reached(replace(now, step=1, to="line"))
            if line is None or line[0] >= time:
                break
            yield (now := messages.LookBack(*line))
        yield (now := messages.LookBack(time))


def _moments_of(looking: Looking, answers: Sequence[messages.WhyAnswer]) -> Iterator[messages.Past]:
    """The moments to which answers lead."""
    sentences = [sentence for answer in answers for sentence in (*answer.sentences, *answer.more)]
    times = {sentence.time for sentence in sentences if sentence.time is not None}
    for time in sorted(times)[:MOST]:
        yield looking.past(messages.LookBack(time))


def _without_drawings(
    moments: list[messages.Past],
) -> tuple[list[dict[str, Any]], messages.Drawing | None]:
    """The moments without what is drawn on the floor, and the last drawing.

    A moment has the number of points of the last drawing that were there; a drawing that does not
    begin like the last one stays in its moment.
    """
    last = moments[-1].drawing
    points = _points(last)
    short = []
    for moment in moments:
        drawn = _points(moment.drawing)
        if drawn == points[: len(drawn)]:
            short.append({"past": plain(replace(moment, drawing=None)), "drawn": len(drawn)})
        else:
            short.append({"past": plain(moment), "drawn": 0})
    return short, last


def _points(drawing: messages.Drawing | None) -> list[Any]:
    parts = drawing.parts if drawing else ()
    return [(part.stroke, point) for part in parts for point in part.points]


def _questions(looking: Looking, begin: float) -> messages.Questions:
    """What can be asked about the run from a time in s on."""
    asked = looking.questions("", None)
    times = ((question, question.question.time) for question in asked.questions)
    shown = tuple(question for question, time in times if time is None or time >= begin)
    return replace(asked, questions=shown)


def _answers(
    looking: Looking,
    questions: messages.Questions,
    timeline: messages.Timeline,
    moments: Sequence[messages.Past],
) -> Iterator[messages.WhyAnswer]:
    """The answers to questions about the run, and what the robot does at some moments."""
    for asked in questions.questions:
        yield looking.answer(asked.question)
    times = [moment.time for moment in moments]
    some = times[:: 1 + len(times) // MOST_NOW]
    for time in sorted({*some, *(mark.time for mark in timeline.marks[:MOST_NOW])}):
        yield looking.answer(messages.WhyQuestion("now", "", time))
