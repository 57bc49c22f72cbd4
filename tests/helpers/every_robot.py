"""The page "One program, every robot": its tables, and what they say of a program on a twin."""

import re
from pathlib import Path

from learnblock import robots, running
from learnblock.language.check.robots import Verdict
from learnblock.running import Options, ProgramRun, Report
from learnblock.runtime.inline import InlineWorker
from places import ROOT
from runs import EXAMPLES, TASKS, TWINS, Holder, person

PAGE = ROOT / "docs" / "one-program-every-robot.md"
#: How much longer a robot may take than the one that the example is meant for.
PATIENCE = 2
REACHED, MISSED = "reached", "missed"


def verdict(name: str, robot: str) -> Verdict:
    """What the check says of an example on a twin."""
    found = running.runs_on(running.read(EXAMPLES / name))[robot]
    assert isinstance(found, Verdict)
    return found


def run_for_goals(name: str, robot: str) -> Report:
    """Run an example on a twin in the world in which its purpose is a goal."""
    source, entry = running.read(EXAMPLES / name), robots.find(robot)
    world, seconds = TASKS[name]
    options = Options(world=world, seconds=PATIENCE * seconds)
    watcher = person(name)
    run = ProgramRun(
        running.program(source, entry), entry, options, worker=InlineWorker, watcher=watcher
    )
    if isinstance(watcher, Holder):
        watcher.session = run
    return run.run()


def missed_goals(report: Report) -> list[str]:
    return [goal.name for goal in report.goals if goal.state != "reached"]


def outcome(name: str, robot: str) -> str:
    """The cell of an example and a twin: `reached`, `missed` or `refused`, and what is missing."""
    found = verdict(name, robot)
    lacking = str(found.phrase).partition(" has no ")[2]
    if not found.runs:
        return f"refused: no {_short(lacking)}"
    done = MISSED if missed_goals(run_for_goals(name, robot)) else REACHED
    return f"{done}, without {_short(lacking)}" if found.missed else done


def _short(lacking: str) -> str:
    """The missing devices, without advice in brackets."""
    return re.sub(r" \([^)]*\)", "", lacking)


def programs_table(outcomes: dict[str, dict[str, str]]) -> str:
    """The table of outcomes, by example and twin."""
    head = ["| program | " + " | ".join(TWINS) + " |", "|---|" + "---|" * len(TWINS)]
    rows = [
        f"| [{name}](../examples/{name}) | " + " | ".join(cells[robot] for robot in TWINS) + " |"
        for name, cells in outcomes.items()
    ]
    return "\n".join([*head, *rows])


def written_outcomes() -> dict[str, dict[str, str]]:
    """The outcomes in the page, by example and twin."""
    rows = re.findall(r"^\| \[(\S+)\]\(\S+\) \| (.*) \|$", part("programs"), re.MULTILINE)
    return {name: dict(zip(TWINS, cells.split(" | "), strict=True)) for name, cells in rows}


def part(name: str) -> str:
    """A part of the page that a script writes."""
    [found] = re.findall(_marked(name), PAGE.read_text(encoding="utf-8"), re.DOTALL)
    return str(found)


def write_part(name: str, text: str, page: Path = PAGE) -> None:
    """Replace a part of the page."""
    before = page.read_text(encoding="utf-8")
    written = f"<!-- {name} -->\n\n{text}\n\n<!-- end of {name} -->"
    page.write_text(re.sub(_marked(name), lambda _: written, before, flags=re.DOTALL), "utf-8")


def _marked(name: str) -> str:
    return rf"<!-- {name} -->\n\n(.*?)\n\n<!-- end of {name} -->"
