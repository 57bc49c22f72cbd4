"""Count on how many robots each example runs: every example on every twin, as a table."""

import sys
from pathlib import Path

from learnblock import robots, running
from learnblock.running import Options, ProgramRun

TESTS = Path(__file__).parents[1] / "tests" / "helpers"
sys.path.insert(0, str(TESTS))

from runs import EXAMPLES, TWINS, WORLDS  # noqa: E402 - found through the line above


def outcome(path: Path, robot: str) -> str:
    """Return `ran`, or the missing devices that made the check refuse the program."""
    source, entry = running.read(path), robots.find(robot)
    errors = [one for one in running.check(source, entry) if one.severity == "error"]
    if errors:
        return "no " + ", ".join(sorted({error.message.split("`")[3] for error in errors}))
    options = Options(world=WORLDS.get(path.name), seconds=20)
    report = ProgramRun(running.program(source, entry), entry, options).run()
    return "ran" if report.error is None else str(report.error["message"])


def main() -> None:
    print(f"{'':<18}" + "".join(f"{robot:<20}" for robot in TWINS))
    ran = refused = 0
    for path in sorted(EXAMPLES.glob("*.bt")):
        outcomes = [outcome(path, robot) for robot in TWINS]
        ran += outcomes.count("ran")
        refused += sum(one.startswith("no ") for one in outcomes)
        print(f"{path.name:<18}" + "".join(f"{one:<20}" for one in outcomes))
    print(f"{ran} ran, {refused} were refused with the missing device")


if __name__ == "__main__":
    main()
