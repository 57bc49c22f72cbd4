"""The commands for camera recognition: its settings, and our detectors for RoboComp."""

from pathlib import Path

import click

from learnblock.cli.console import json_option, print_settings, text, usage_error
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase


@click.group("perception", invoke_without_command=True)
@json_option
@click.pass_context
def perception_group(ctx: click.Context, as_json: bool) -> None:  # noqa: FBT001 - a click flag
    """Show or change camera recognition.

    \b
    learnblock perception set webcam 0
    learnblock perception set apriltag localhost:25000
    learnblock perception set apriltag --default
    """  # noqa: D301 - click wants the character itself
    if ctx.invoked_subcommand is not None:
        return
    from learnblock.perception.sources import TABLE, WHY_EMOTIONS_ARE_OFF  # noqa: PLC0415 - as below

    _show(as_json=as_json)
    if not as_json and not TABLE.load().emotions_on_cameras:
        click.echo(f"\n{text(WHY_EMOTIONS_ARE_OFF)}")


@perception_group.command("set")
@click.argument("setting")
@click.argument("value", required=False)
@click.option("--default", is_flag=True, help="Restore the default.")
@click.option("--yes", is_flag=True, help="Do not ask.")
@json_option
def set_command(
    setting: str,
    value: str | None,
    default: bool,  # noqa: FBT001 - a click flag
    yes: bool,  # noqa: FBT001
    as_json: bool,  # noqa: FBT001
) -> None:
    """Change a setting of camera recognition."""
    from learnblock.perception.sources import TABLE  # noqa: PLC0415 - `--help` needs none of it

    if default is (value is not None):
        raise usage_error("cli-value-or-default")
    if setting == "emotions_on_cameras" and value == "true":
        _warn(ask=not yes)
    TABLE.change(setting, _whole_path(value) if setting == "video" and value else value)
    _show(as_json=as_json)


def _show(*, as_json: bool) -> None:
    from learnblock.perception.sources import TABLE  # noqa: PLC0415 - as above

    print_settings(list(TABLE.describe()), as_json=as_json)


def _whole_path(value: str) -> str:
    """The absolute path of a file."""
    path = Path(value).resolve()
    if not path.is_file():
        raise LearnBlockError("cli-no-file", file=str(path))
    return str(path)


def _warn(*, ask: bool) -> None:
    """Warn about emotions on real cameras; abort unless the user agrees."""
    from learnblock.perception.sources import WHY_EMOTIONS_ARE_OFF  # noqa: PLC0415 - as above

    click.echo(text(WHY_EMOTIONS_ARE_OFF), err=True)
    if ask:
        question = text(Phrase("cli-emotions-question"))
        click.confirm(f"\n{question}", abort=True, err=True)


@click.command("component")
@click.argument("name", metavar="apriltag|emotionrecognition")
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    help="Listen on this port  [default: 25000 for apriltag, 10006 for emotionrecognition]",
)
@click.option(
    "--host",
    metavar="ADDRESS",
    default="127.0.0.1",
    show_default=True,
    help="Listen on this address.",
)
@click.option(
    "--layout",
    type=click.Choice(["auto", "rows", "columns"]),
    default="auto",
    show_default=True,
    help="What a picture's width field holds; RoboComp's clients send the rows.",
)
@click.option(
    "--only-drawn-faces",
    "drawn",
    is_flag=True,
    help="Confirm that it sees drawn and simulated faces only.",
)
def component_command(
    name: str,
    port: int | None,
    host: str,
    layout: str,
    drawn: bool,  # noqa: FBT001 - a click flag
) -> None:
    """Serve a detector to RoboComp.

    RoboComp's components call it over Ice. Press Ctrl-C to stop.

    \b
    learnblock component apriltag
    learnblock component emotionrecognition --only-drawn-faces
    """  # noqa: D301 - click wants the character itself
    from learnblock.cli.interrupts import served_until_ctrl_c  # noqa: PLC0415
    from learnblock.perception.robocomp import PixelOrder, serve  # noqa: PLC0415

    order = None if layout == "auto" else PixelOrder(layout)
    adapter, listening = serve(name, port=port, host=host, order=order, drawn=drawn)
    with adapter, served_until_ctrl_c():
        click.echo(f"{name}:tcp -h {host} -p {listening}")
