"""The command `compare`: where two runs of one program parted, or a real robot and its twin."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from learnblock.cli.console import EXISTING_FILE, json_option, print_json, say, text, usage_error

if TYPE_CHECKING:
    from learnblock.why.ghost import TwinFact


@click.command("compare")
@click.argument("first", type=EXISTING_FILE, metavar="LOG")
@click.argument("second", type=EXISTING_FILE, metavar="[LOG]", required=False)
@click.option(
    "--with-twin",
    is_flag=True,
    help="Compare the run of a real robot with what its twin does with the same commands.",
)
@click.option("--world", default="empty", help="The world that the real robot was in.")
@json_option
def compare_command(
    first: Path,
    second: Path | None,
    with_twin: bool,  # noqa: FBT001 - click flags
    world: str,
    as_json: bool,  # noqa: FBT001
) -> None:
    """Show where two runs parted, and why.

    For example after an edit, with another seed, or on another robot. Noise alone does not count:
    the first decision that differs does. After an edit alone, so does the first command to the
    robot. The logs are written by learnblock run --why, or downloaded from the page.

    With --with-twin, one log of a real robot is enough: its twin obeys the same commands, and the
    difference shows how to calibrate the robot.

    \b
    learnblock run examples/avoid.bt --seed 1 --why one.why
    learnblock run examples/avoid.bt --seed 2 --why two.why
    learnblock compare one.why two.why
    learnblock compare real.why --with-twin
    """  # noqa: D301 - click wants the character itself
    if with_twin:
        if second:
            raise usage_error("twin-needs-one")
        _compare_with_twin(first, world, as_json=as_json)
    elif second:
        _compare(first, second, as_json=as_json)
    else:
        raise usage_error("twin-needs-two")


def _compare(first: Path, second: Path, *, as_json: bool) -> None:
    from learnblock import why  # noqa: PLC0415 - `--help` needs none of it
    from learnblock.why.comparison import compared  # noqa: PLC0415

    comparison = compared(why.EventHistory(why.read(first)), why.EventHistory(why.read(second)))
    if as_json:
        print_json(comparison)
        return
    if comparison.parting is None:
        say("why-same")
    else:
        say("why-together", time=round(comparison.parting.together, 2))
        for log, sentence in (
            (first, comparison.parting.first),
            (second, comparison.parting.second),
        ):
            say("why-run", name=log.name, sentence=text(sentence.phrase))
    for cause in comparison.causes:
        click.echo(text(cause))


def _compare_with_twin(log: Path, world: str, *, as_json: bool) -> None:
    from learnblock import why  # noqa: PLC0415 - as above
    from learnblock.why.drift import drift  # noqa: PLC0415
    from learnblock.why.ghost import findings, unrecorded  # noqa: PLC0415
    from learnblock.why.prediction import predict  # noqa: PLC0415

    predicted = predict(why.read(log), world)
    drifted = drift(predicted)
    facts = findings(predicted, drifted)
    missing = unrecorded(predicted, drifted)
    if as_json:
        print_json(
            {
                "parting": predicted.parting,
                "delay": predicted.delay,
                "drift": drifted,
                "findings": [_plain(finding) for finding in facts],
                "unrecorded": [text(phrase) for phrase in missing],
            }
        )
        return
    for phrase in (*(finding.phrase for finding in facts), *missing):
        click.echo(text(phrase))


def _plain(finding: "TwinFact") -> dict[str, object]:
    """A fact for tools, its text in the reader's language."""
    return {"text": text(finding.phrase), "code": finding.phrase.code, "time": finding.time}
