"""What the checks of the way find that a robot has driven."""

import math
from collections.abc import Sequence

from learnblock.evidence.evidence import TimedPose, length_of
from learnblock.evidence.gaps import heading_between, is_on_line, turned_along
from learnblock.lessons.checks import Drives, EndsAt, StaysOnLine, Turns
from learnblock.lessons.finding import OPEN, Finding, RunSoFar, failed_at, met_at

#: How often a trace has the place of the robot.
_POSES_PER_SECOND = 10


def on_line(check: StaysOnLine, run: RunSoFar) -> Finding:
    """Whether the robot stayed on a line."""
    line = run.world.line_named(check.line) if run.world else None
    if line is None:
        return failed_at(None, "lesson-no-line", line=check.line) if run.has_ended else OPEN
    path = run.evidence.path
    is_on = is_on_line(path, line.polyline(), check.distance)
    if True not in is_on:
        return failed_at(run.now, "miss-line-never") if run.has_ended else OPEN
    first = is_on.index(True)
    on, total = is_on.count(True), len(path) - first
    # Even if it stays on the line from now on.
    remaining = 0.0 if run.has_ended else max(0.0, run.seconds - run.now) * _POSES_PER_SECOND
    if on + remaining < check.share * (total + remaining):
        code = "lesson-line-share" if run.has_ended else "lesson-line-lost"
        return failed_at(run.now, code, **_shares(on / total, check.share))
    if not run.has_ended:
        return OPEN
    return _long_enough(check, run, path[first:])


def _long_enough(check: StaysOnLine, run: RunSoFar, path: Sequence[TimedPose]) -> Finding:
    driven = length_of(path)
    if driven >= check.least:
        return met_at(run.now)
    return failed_at(run.now, "lesson-line-short", driven=round(driven), least=round(check.least))


def _shares(share: float, minimum: float) -> dict[str, int]:
    # Down, so that a share that is too small never reads like the one that is asked.
    return {"share": math.floor(share * 100), "asked": round(minimum * 100)}


def drives(check: Drives, run: RunSoFar) -> Finding:
    """Whether it drove a distance."""
    driven = run.evidence.distance
    if check.at_most is not None and driven > check.at_most:
        return failed_at(
            run.now, "lesson-drove-far", driven=round(driven), most=round(check.at_most)
        )
    if driven >= check.at_least and (check.at_most is None or run.has_ended):
        return met_at(run.now)
    if not run.has_ended:
        return OPEN
    return failed_at(
        run.now, "lesson-drove-short", driven=round(driven), least=round(check.at_least)
    )


def ends_at(check: EndsAt, run: RunSoFar) -> Finding:
    """Whether it stopped at a place."""
    path = run.evidence.path
    if not run.has_ended:
        return OPEN
    if not path:
        return failed_at(run.now, "lesson-no-pose")
    last = path[-1]
    away = math.hypot(last.x - check.x, last.y - check.y)
    if away > check.radius:
        return failed_at(run.now, "lesson-ended-away", away=round(away), radius=round(check.radius))
    if check.heading is not None:
        off = heading_between(check.heading, last.heading)
        if abs(off) > check.angle:
            return failed_at(
                run.now, "lesson-ended-facing", off=round(abs(off)), angle=round(check.angle)
            )
    return met_at(run.now)


def turns(check: Turns, run: RunSoFar) -> Finding:
    """Whether it turned by an angle."""
    if not run.has_ended:
        return OPEN
    turned = turned_along(run.evidence.path)
    if abs(turned - check.by) <= check.tolerance:
        return met_at(run.now)
    return failed_at(run.now, "lesson-turned", turned=round(turned), by=round(check.by))
