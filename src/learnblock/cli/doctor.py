"""The command `doctor`: what this computer can do for LearnBlock, and what it cannot."""

import click

from learnblock.cli.console import json_option, print_json, say, text


@click.command("doctor")
@json_option
def doctor_command(as_json: bool) -> None:  # noqa: FBT001 - a click flag
    """Show what contains programs on this computer.

    Runs a program that tries to get out, and shows what held it and what did not.
    """
    from learnblock.runtime.containment.survey import survey  # noqa: PLC0415 - `--help`

    findings = survey()
    if as_json:
        print_json(findings)
        return
    say("doctor-title")
    for finding in findings:
        answer = "doctor-contained" if finding.contained else "doctor-not-contained"
        say(answer, name=text(finding.name), reason=text(finding.reason))
    if not all(finding.contained for finding in findings):
        say("doctor-advice")
