"""Which robots can run programs, and what serves a skill on each robot."""

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import click

from learnblock import robots, running
from learnblock.blocks import BlockConfiguration
from learnblock.cli.console import ExitCode, print_diagnostics, print_json, text, warn
from learnblock.errors import FileError, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.language.check.robots import Verdict, need_phrase
from learnblock.project.files.programs import read
from learnblock.senses import UNSERVED, served_by


def print_robots(files: Iterable[Path], *, as_json: bool) -> ExitCode:
    """Print which robots can run each program, and why others can't; return the exit code."""
    failed = False
    table: dict[str, Mapping[str, Verdict | Phrase]] = {}
    for file in files:
        try:
            table[str(file)] = running.runs_on(read(file, warn))
        except FileError as error:
            failed = True
            print_diagnostics(str(file), error.diagnostics, error.source, err=True)
    if as_json:
        print_json(
            [{"file": file, "robots": _objects(verdicts)} for file, verdicts in table.items()]
        )
    else:
        for name, verdicts in table.items():
            click.echo(name)
            _print({robot: _phrase(verdict) for robot, verdict in verdicts.items()})
    return ExitCode.MISTAKES if failed else ExitCode.WELL


def print_serving(skill: BlockConfiguration) -> None:
    """Print what serves the needs of a skill on each robot."""
    served = serving(skill)
    kinds = {need.partition(":")[0] for need in skill.needed()}
    known_ways = [ways for ways in served.values() if ways is not None]
    if kinds & UNSERVED and not any(map(_is_served, known_ways)):
        click.echo(f"  {text(Phrase('cli-served-by-no-robot'))}")
    else:
        _print({robot: _told(senses) for robot, senses in served.items()})


def serving(skill: BlockConfiguration) -> dict[str, dict[str, str | None] | None]:
    """For each robot, what serves each need of a skill, None if nothing.

    A robot whose devices depend on its settings has None instead.
    """
    table: dict[str, dict[str, str | None] | None] = {}
    for entry in robots.entries().values():
        try:
            equipment = entry.load().known_equipment()
        except LearnBlockError:
            # `learnblock robots` reports what is wrong with it.
            continue
        if equipment is None:
            table[entry.name] = None
        else:
            table[entry.name] = {need: served_by(need, equipment) for need in skill.needed()}
    return table


def _is_served(ways: Mapping[str, str | None]) -> bool:
    return all(ways.values())


def _told(served: Mapping[str, str | None] | None) -> Phrase:
    if served is None:
        return Phrase("check-robot-unknown")
    missing = tuple(need_phrase(need) for need, way in served.items() if way is None)
    if missing:
        return Phrase("cli-served-by-nothing", devices=missing)
    return Phrase(
        "cli-served-by", devices=tuple(need_phrase(way) for way in served.values() if way)
    )


def _phrase(verdict: Verdict | Phrase) -> Phrase:
    return verdict.phrase if isinstance(verdict, Verdict) else verdict


def _objects(verdicts: Mapping[str, Verdict | Phrase]) -> dict[str, Any]:
    return {
        robot: {
            "runs": verdict.runs if isinstance(verdict, Verdict) else None,
            "message": _phrase(verdict),
        }
        for robot, verdict in verdicts.items()
    }


def _print(lines: Mapping[str, Phrase]) -> None:
    width = max(map(len, lines), default=0)
    for name, phrase in lines.items():
        click.echo(f"  {name:<{width}}  {text(phrase)}")
