"""The command line's part for perception: its settings, and our detectors as components."""

from pathlib import Path

import click

from learnblock.console import print_settings
from learnblock.errors import LearnBlockError

_JSON = click.option("--json", "as_json", is_flag=True, help="Print JSON, for tools.")


@click.group("perception", invoke_without_command=True)
@_JSON
@click.pass_context
def perception_group(ctx: click.Context, as_json: bool) -> None:  # noqa: FBT001 - a flag of click
    """Show how what cameras see is recognised, or change it.

    \b
    learnblock perception set webcam 0
    learnblock perception set apriltag localhost:25000
    learnblock perception set apriltag --default
    """  # noqa: D301 - click wants the character itself
    if ctx.invoked_subcommand is not None:
        return
    from learnblock.vision import TABLE, WHY_EMOTIONS_ARE_OFF  # noqa: PLC0415 - as below

    _show(as_json=as_json)
    if not as_json and not TABLE.load().emotions_on_cameras:
        click.echo(f"\n{WHY_EMOTIONS_ARE_OFF}")


@perception_group.command("set")
@click.argument("setting")
@click.argument("value", required=False)
@click.option("--default", is_flag=True, help="Put the setting's default back.")
@click.option("--yes", is_flag=True, help="Ask nothing.")
@_JSON
def set_command(
    setting: str,
    value: str | None,
    default: bool,  # noqa: FBT001 - a flag of click
    yes: bool,  # noqa: FBT001
    as_json: bool,  # noqa: FBT001
) -> None:
    """Change a setting of perception: see `learnblock perception`."""
    from learnblock.vision import TABLE  # noqa: PLC0415 - `--help` needs none of it

    if default is (value is not None):
        raise click.UsageError("give either a VALUE or --default")
    if setting == "emotions_on_cameras" and value == "true":
        _warn(ask=not yes)
    TABLE.change(setting, _whole_path(value) if setting == "video" and value else value)
    _show(as_json=as_json)


def _show(*, as_json: bool) -> None:
    from learnblock.vision import TABLE  # noqa: PLC0415 - as above

    print_settings(list(TABLE.describe()), as_json=as_json)


def _whole_path(value: str) -> str:
    """A file that is named from where one is, as it is named from anywhere."""
    path = Path(value).resolve()
    if not path.is_file():
        raise LearnBlockError(f"there is no file {path}")
    return str(path)


def _warn(*, ask: bool) -> None:
    """Say why emotions are not recognised on real cameras; go on only if somebody wants to."""
    from learnblock.vision import WHY_EMOTIONS_ARE_OFF  # noqa: PLC0415 - as above

    click.echo(WHY_EMOTIONS_ARE_OFF, err=True)
    if ask:
        click.confirm("\nSwitch it on for all real cameras?", abort=True, err=True)


@click.command("component")
@click.argument("name", metavar="apriltag|emotionrecognition")
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    help="Listen at this port  [default: 25000 for apriltag, 10006 for emotionrecognition]",
)
@click.option(
    "--host", metavar="ADDRESS", default="127.0.0.1", show_default=True, help="Listen there."
)
@click.option(
    "--layout",
    type=click.Choice(["auto", "rows", "columns"]),
    default="auto",
    show_default=True,
    help="Which number a picture's width carries: RoboComp's clients send its rows.",
)
@click.option(
    "--only-drawn-faces",
    "drawn",
    is_flag=True,
    help="It will be shown drawn and simulated faces alone.",
)
def component_command(
    name: str,
    port: int | None,
    host: str,
    layout: str,
    drawn: bool,  # noqa: FBT001 - a flag of click
) -> None:
    """Be one of RoboComp's components, with our detector: others ask it over Ice.

    Leave it with Ctrl-C.

    \b
    learnblock component apriltag
    learnblock component emotionrecognition --only-drawn-faces
    """  # noqa: D301 - click wants the character itself
    from threading import Event  # noqa: PLC0415 - `--help` needs none of it

    from learnblock.components import Order, serve  # noqa: PLC0415

    order = None if layout == "auto" else Order(layout)
    adapter, listening = serve(name, port=port, host=host, order=order, drawn=drawn)
    with adapter:
        click.echo(f"{name}:tcp -h {host} -p {listening}")
        click.echo("Ctrl-C ends it.")
        Event().wait()
