"""The page "One program, every robot": its tables, and what they say of a program on a robot."""

import re
from pathlib import Path

from learnblock import robots, running
from learnblock.language.check.robots import Verdict
from learnblock.running import Job, Options, ProgramRun, Report
from learnblock.runtime.inline import InlineWorker
from places import ROOT
from runs import EXAMPLES, TASKS, Holder, person

PAGE = ROOT / "docs" / "one-program-every-robot.md"
#: How much longer a robot may take than the one that the example is meant for.
PATIENCE = 2
REACHED, MISSED = "reached", "missed"
#: The goal can't be judged over a wire: it can't be seen there, or needs somebody's hands.
NOT_JUDGED = "ran"
#: The robots at the end of a wire, in the order of the table.
REAL = (
    "cozmo",
    "thymio",
    "ebo",
    "ev3",
    "spike",
    "legoed",
    "root",
    "create3",
    "rcis",
    "coppeliasim",
)


def verdict(name: str, robot: str) -> Verdict:
    """What the check says of an example on a robot."""
    result = running.runs_on(running.read(EXAMPLES / name))[robot]
    assert isinstance(result, Verdict)
    return result


def run_for_goals(name: str, robot: str) -> Report:
    """Run an example on a twin in the world in which its purpose is a goal."""
    source, entry = running.read(EXAMPLES / name), robots.find(robot)
    world, seconds = TASKS[name]
    options = Options(world=world, seconds=PATIENCE * seconds)
    watcher = person(name)
    job = Job(running.program(source, entry), entry, options)
    run = ProgramRun(job, worker=InlineWorker, watcher=watcher)
    if isinstance(watcher, Holder):
        watcher.session = run
    return run.run()


def missed_goals(report: Report) -> list[str]:
    return [goal.name for goal in report.goals if goal.state != "reached"]


def cell(outcome: Verdict, goal: str = REACHED) -> str:
    """The cell of an example and a robot: what became of its goal, or `refused`, and what lacks."""
    lacking = _short(str(outcome.phrase).partition(" has no ")[2])
    if not outcome.runs:
        return f"refused: no {lacking}"
    return f"{goal}, without {lacking}" if outcome.missed else goal


def _short(lacking: str) -> str:
    """The missing devices, without advice in brackets."""
    return re.sub(r" \([^)]*\)", "", lacking)


def programs_table(outcomes: dict[str, dict[str, str]]) -> str:
    """A table of outcomes, by example and robot."""
    columns = list(next(iter(outcomes.values())))
    head = ["| program | " + " | ".join(columns) + " |", "|---|" + "---|" * len(columns)]
    rows = [
        f"| [{name}](../examples/{name}) | " + " | ".join(cells.values()) + " |"
        for name, cells in outcomes.items()
    ]
    return "\n".join([*head, *rows])


def written_outcomes(name: str = "programs") -> dict[str, dict[str, str]]:
    """The outcomes in a table of the page, by example and robot."""
    table = part(name)
    columns = re.findall(r"[\w-]+", table.partition("\n")[0])[1:]
    rows = re.findall(r"^\| \[(\S+)\]\(\S+\) \| (.*) \|$", table, re.MULTILINE)
    return {program: dict(zip(columns, cells.split(" | "), strict=True)) for program, cells in rows}


def part(name: str) -> str:
    """A part of the page that a script writes."""
    [text] = re.findall(_marked(name), PAGE.read_text(encoding="utf-8"), re.DOTALL)
    return str(text)


def write_part(name: str, text: str, page: Path = PAGE) -> None:
    """Replace a part of the page."""
    before = page.read_text(encoding="utf-8")
    block = f"<!-- {name} -->\n\n{text}\n\n<!-- end of {name} -->"
    page.write_text(re.sub(_marked(name), lambda _: block, before, flags=re.DOTALL), "utf-8")


def _marked(name: str) -> str:
    return rf"<!-- {name} -->\n\n(.*?)\n\n<!-- end of {name} -->"
