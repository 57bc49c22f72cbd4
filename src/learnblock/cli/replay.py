"""The command `replay`: whether the poses and goals in a trace are true."""

from pathlib import Path

import click

from learnblock.cli.console import EXISTING_FILE, ExitCode, say


@click.command("replay")
@click.argument("trace", type=EXISTING_FILE)
@click.option("--world", help="The world's name or file, instead of the one in the trace.")
@click.pass_context
def replay_command(context: click.Context, trace: Path, world: str | None) -> None:
    """Check a trace's poses and goals by repeating it.

    The commands to the wheels of simulated robots are repeated in a clean world.
    """
    from learnblock.running.replay import replay  # noqa: PLC0415 - `--help`

    repeated = replay(trace.read_bytes(), world)
    if repeated.is_true:
        say("report-replay-true", count=len(repeated.recorded))
        return
    say("report-replay-false", seconds=round(repeated.differs_at, 2))
    context.exit(ExitCode.PROGRAM_FAILED)
