"""Runs of one program in many variants of a world on the command line."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import click

from learnblock.cli.console import ExitCode, print_json, text, usage_error
from learnblock.cli.interrupts import stopped_by_signals
from learnblock.cli.report import decimal, ending
from learnblock.cli.reporting import EXIT_CODES, PreparedProgram, prepared
from learnblock.i18n import Phrase
from learnblock.running import Report
from learnblock.running.batch import Batch
from learnblock.runtime.ending import How


def run_variants(file: Path, *, variants: int, as_json: bool, **choices: Any) -> int:
    """Run a program in the variants 1 to `variants`, print a table, and return the exit code."""
    if any(choices.pop(name) is not None for name in ("trace", "picture")) or choices["variant"]:
        raise usage_error("report-variants-alone")
    with prepared(file, as_json=as_json, **choices) as program:
        if program is None:
            return ExitCode.MISTAKES
        return _run_all(program, variants, as_json=as_json)


def _run_all(program: PreparedProgram, variants: int, *, as_json: bool) -> int:
    numbers = range(1, variants + 1)
    job = replace(program.job, keys=program.keys.keys if program.keys else None)
    jobs = [replace(job, options=replace(job.options, variant=number)) for number in numbers]
    batch = Batch(jobs)
    # They end in any order.
    ended: dict[int, Report] = {}
    printed = 0
    with stopped_by_signals(batch.stop):
        for index, result in batch.results():
            ended[index + 1] = result.report
            if not as_json:
                printed = _print_rows(ended, printed, program.job.options.seconds)
    reports = dict(sorted(ended.items()))
    if not as_json:
        # Those that ended after one that was stopped.
        for number in list(reports)[printed:]:
            click.echo(_row(number, reports[number], program.job.options.seconds), err=True)
    _print(reports, as_json=as_json)
    codes = (EXIT_CODES.get(How(report.ended), ExitCode.WELL) for report in reports.values())
    return max(codes) if len(reports) == variants else ExitCode.INTERRUPTED


def _print_rows(ended: Mapping[int, Report], printed: int, limit: float | None) -> int:
    """Print the variants after the first `printed` that have ended, up to one that has not.

    Returns:
        How many have been printed.
    """
    while printed + 1 in ended:
        printed += 1
        click.echo(_row(printed, ended[printed], limit), err=True)
    return printed


def _row(number: int, report: Report, limit: float | None) -> str:
    states = [goal.state for goal in report.goals]
    row = Phrase(
        "report-variant",
        variant=number,
        reached=states.count("reached"),
        all=len(states),
        time=decimal(report.time),
    )
    return f"{text(row)}  {ending(report, limit)}" if report.error else text(row)


def _has_reached_all(report: Report) -> bool:
    return bool(report.goals) and all(goal.state == "reached" for goal in report.goals)


def _print(reports: Mapping[int, Report], *, as_json: bool) -> None:
    reached = sum(map(_has_reached_all, reports.values()))
    if as_json:
        rows = [{"variant": number, "report": report} for number, report in reports.items()]
        print_json({"reached": reached, "variants": rows})
    else:
        total = Phrase("report-variants-reached", reached=reached, all=len(reports))
        click.echo(text(total), err=True)
