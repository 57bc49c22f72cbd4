"""Lessons and runs for tests."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import msgspec

from learnblock.evidence.evidence import Evidence, evidence_so_far
from learnblock.evidence.trace_lines import TraceLines
from learnblock.lessons.lesson import Lesson, Step
from learnblock.running import Report

STEP = Step(title="Drive", phase="make", text="Drive.")
LESSON = Lesson(
    lesson=1,
    title="A lesson",
    level=1,
    minutes=10,
    aims=("to drive",),
    robots=("sim-ebo",),
    step=(STEP,),
)
MAIN = """
lesson = 1
title = { en = "A square", es = "Un cuadrado" }
level = 1
minutes = 20
aims = ["to use a loop"]
robots = ["sim-ebo", "sim-ev3"]

[[step]]
title = "Drive a square"
phase = "make"
text = "Drive."
world = "square"
program = "start.bt"
variants = 1

[[step.check]]
kind = "goals"

[[step.check]]
kind = "uses"
construct = "loop"
"""
ENDED = Report(ended="finished", time=10.0)
START = "main:\n    function.move_straight()\nend\n"


def files(main: str = MAIN, **more: bytes | str) -> dict[str, bytes]:
    """The files of a lesson; `more` has `programs__turn_bt` for ``programs/turn.bt``."""
    contents = {"lesson.toml": main.encode(), "programs/start.bt": START.encode()}
    for name, content in more.items():
        path = name.replace("__", "/")
        stem, _, ending = path.rpartition("_")
        data = content.encode() if isinstance(content, str) else content
        contents[f"{stem}.{ending}"] = data
    return contents


def evidence(
    *lines: Mapping[str, Any],
    report: Report | None = ENDED,
    now: float = 10.0,
    robot: str = "",
) -> Evidence:
    """What is known of a run with these lines; it is over unless `report` is None."""
    trace = TraceLines()
    for line in lines:
        if "collision" not in line:
            trace.write(msgspec.json.encode(line) + b"\n")
    result = evidence_so_far(trace, report.time if report else now, report, robot=robot)
    collisions = [line for line in lines if "collision" in line]
    return replace(result, lines=[*result.lines, *collisions])
