"""A small lesson, programs handed in, and gradings of them."""

from importlib.metadata import version

from learnblock.lessons.grading.grading import Grading
from learnblock.lessons.grading.journal import opened_journal
from learnblock.lessons.grading.plan import Plan
from learnblock.lessons.grading.values import HandedIn
from learnblock.lessons.reading import read_files
from learnblock.lessons.trying import Attempt
from learnblock.runtime.limits import Limits

LESSON = """
lesson = 1
title = { en = "First drive", es = "Primer paseo" }
level = 1
minutes = 20
aims = ["Drive"]
robots = ["sim-ebo"]

[[step]]
title = "Drive"
phase = "make"
text = "Drive forward."
program = "start.bt"
world = "square"
seconds = 5

[[step.check]]
kind = "drives"
at_least = 100

[[step.check]]
kind = "ends"

[[step.check]]
kind = "prints"
lines = ["hello"]
optional = true
"""
START = "main:\n    function.sleep(1)\nend\n"
GOOD = (
    "main:\n    function.move_straight(60)\n    function.sleep(3)\n    function.stop_bot()\nend\n"
)
SHORT = GOOD.replace("(60)", "(10)")
LIMITS = Limits()
HEAD = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n"


def lesson(text=LESSON, **files):
    """The lesson; further files are programs by their names."""
    programs = {f"programs/{name}.bt": content.encode() for name, content in files.items()}
    return read_files(
        "drive", {"lesson.toml": text.encode(), "programs/start.bt": START.encode()} | programs
    )


def handed_in(**programs):
    """Programs by the names of pupils; those that begin with ``from`` or ``import`` are Python."""
    return tuple(
        HandedIn(name, f"{name}.bt", text, text.startswith(("from", "import")))
        for name, text in programs.items()
    )


def plan(programs, *, opened=None, seeds=1, limits=LIMITS):
    attempts = tuple(Attempt("sim-ebo", 0, seed) for seed in range(seeds))
    return Plan(opened or lesson(), 1, programs, attempts, version("learnblock-studio"), limits)


def rows(grading_plan, folder, workers):
    """The rows of a grading that is made, as (pupil, result)."""
    with opened_journal(folder) as journal:
        grading = Grading(grading_plan, journal)
        list(grading.run(workers))
        return [(row.handed_in.pupil, row.result) for row in grading.rows()]
