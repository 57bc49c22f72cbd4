"""The robots that can run a program."""

from learnblock import running
from learnblock.i18n import Phrase
from learnblock.language.check import robots
from learnblock.server.messages import RunsOn, Verdict
from learnblock.server.program.document import Document


def runs_on(document: Document) -> RunsOn:
    """For each robot, whether it can run the program, and what it lacks."""
    found = running.verdicts(document.block_tree, document.target.configurations)
    return RunsOn(tuple(_verdict(robot, one) for robot, one in found.items()))


def _verdict(robot: str, verdict: robots.Verdict | Phrase) -> Verdict:
    if isinstance(verdict, Phrase):
        return Verdict(robot, "unknown", verdict)
    if verdict.refused:
        return Verdict(robot, "refused", verdict.phrase)
    return Verdict(robot, "without" if verdict.missed else "runs", verdict.phrase)
