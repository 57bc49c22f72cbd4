"""The command line's part for robots: their list, settings, search, trial, and emulators."""

import sys
from collections.abc import Iterator, Mapping
from typing import Any

import click

from learnblock.console import ExitCode, print_json, print_settings, shown
from learnblock.errors import LearnBlockError, UnknownNameError

_JSON = click.option("--json", "as_json", is_flag=True, help="Print JSON, for tools.")
_NAME = click.argument("name", metavar="ROBOT")


@click.group("robots", invoke_without_command=True)
@_JSON
@click.pass_context
def robots_group(ctx: click.Context, as_json: bool) -> None:  # noqa: FBT001 - a flag of click
    """List the robots with their devices; or set, scan, test or set up real ones.

    \b
    learnblock robots scan
    learnblock robots set cozmo address 192.168.1.20
    learnblock robots test cozmo
    """  # noqa: D301 - click wants the character itself
    if ctx.invoked_subcommand is None:
        from learnblock.listing import robot_list  # noqa: PLC0415 - `--help` needs none of it

        robot_list(as_json=as_json)


@robots_group.command("set")
@_NAME
@click.argument("setting", required=False)
@click.argument("value", required=False)
@click.option("--default", is_flag=True, help="Put the setting's default back.")
@_JSON
def set_command(
    name: str,
    setting: str | None,
    value: str | None,
    default: bool,  # noqa: FBT001 - a flag of click
    as_json: bool,  # noqa: FBT001
) -> None:
    """Show the settings of a real robot, or change one.

    \b
    learnblock robots set ev3                    show them all
    learnblock robots set ev3 wheel_radius 28    change one
    learnblock robots set ev3 wheel_radius --default
    """  # noqa: D301 - click wants the character itself
    from learnblock.robots import settings  # noqa: PLC0415

    robot = _real(name)
    if default and (setting is None or value is not None):
        raise click.UsageError("--default goes with the name of a setting, and without a VALUE")
    if setting is not None and (value is not None or default):
        settings.change(robot.name(), robot.settings_type, setting, value)
    known = {one.name: one for one in settings.describe(robot.name(), robot.settings_type)}
    if setting is not None and setting not in known:
        raise UnknownNameError(f"setting of the robot {name}", setting, known)
    print_settings([known[setting]] if setting else list(known.values()), as_json=as_json)


@robots_group.command()
@click.argument("names", metavar="[ROBOT]...", nargs=-1)
@click.option(
    "--seconds",
    type=click.FloatRange(0.1, 60),
    default=3.0,
    show_default=True,
    help="How long to look for each kind of robot.",
)
@_JSON
def scan(names: tuple[str, ...], seconds: float, as_json: bool) -> None:  # noqa: FBT001
    """Look for real robots: on serial ports, in the network, on this machine."""
    found = [{"robot": name, "settings": dict(one)} for name, one in _scan(names, seconds)]
    if as_json:
        print_json(found)
    for one in found if not as_json else ():
        click.echo(f"{one['robot']:<12} {_spelled(one['settings'])}")
    if not found and not as_json:
        click.echo("no robot answered: is it switched on, and this machine in its network?")


@robots_group.command()
@_NAME
@click.option("--yes", is_flag=True, help="Ask nothing: it drives at once.")
def test(name: str, yes: bool) -> None:  # noqa: FBT001 - a flag of click
    """Try every device of a robot, one after the other, and say what works."""
    from learnblock.robots import find  # noqa: PLC0415
    from learnblock.testing.trial import try_out  # noqa: PLC0415

    works = True
    with find(name).load()() as robot:
        for tried in try_out(robot, lambda _: True) if yes else try_out(robot, click.confirm):
            works = works and tried.works is not False
            verdict = {True: "works", False: "FAILS", None: "left out"}[tried.works]
            click.echo(f"{verdict:<9} {tried.what:<24} {tried.detail}")
    sys.exit(ExitCode.WELL if works else ExitCode.MISTAKES)


@robots_group.command()
@_NAME
def setup(name: str) -> None:
    """Put what we need on a robot that can be prepared: our agent on an EV3's brick, a scene."""
    from learnblock.robots import settings  # noqa: PLC0415

    robot = _real(name)
    robot.set_up(settings.load(robot.name(), robot.settings_type), click.echo)


@click.command("emulate")
@_NAME
@click.option("--world", metavar="NAME", help="Which world, or a world's file.")
@click.option("--seed", type=int, default=0, help="Seeds all noise.")
def emulate_command(name: str, world: str | None, seed: int) -> None:
    """Be a robot's other end: its real driver then drives a twin in our simulator.

    To try a driver, or a lesson, without the robot. Leave it with Ctrl-C.

    \b
    learnblock emulate cozmo --world tags
    """  # noqa: D301 - click wants the character itself
    from learnblock import emulators  # noqa: PLC0415

    with emulators.emulate(name, world, seed=seed) as emulation:
        click.echo(f"{name} is here; a program reaches it with these settings:")
        for setting, value in emulation.settings.items():
            click.echo(f"    learnblock robots set {name} {setting} {shown(value)}")
        click.echo(f"    learnblock run PROGRAM --robot {name}")
        if emulation.note:
            click.echo(emulation.note)
        click.echo("Ctrl-C ends it.")
        emulation.wait()


def _real(name: str) -> Any:
    """The class of a robot that has settings."""
    from learnblock.robots import find  # noqa: PLC0415
    from learnblock.robots.real import RealRobot  # noqa: PLC0415

    robot = find(name).load()
    if not issubclass(robot, RealRobot):
        raise LearnBlockError(f"the robot `{name}` has no settings: it is no real one")
    return robot


def _scan(names: tuple[str, ...], seconds: float) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Every robot that answers; all kinds are looked for at the same time."""
    from concurrent.futures import ThreadPoolExecutor  # noqa: PLC0415

    from learnblock.robots import entries  # noqa: PLC0415
    from learnblock.robots.real import RealRobot  # noqa: PLC0415

    kinds = [entry.load() for entry in entries().values() if not entry.name.startswith("sim-")]
    wanted = [_real(name) for name in names] or [one for one in kinds if issubclass(one, RealRobot)]
    with ThreadPoolExecutor(max(1, len(wanted))) as pool:
        looks = [(one.name(), pool.submit(list, one.scan(seconds))) for one in wanted]
        for name, look in looks:
            yield from ((name, found) for found in look.result())


def _spelled(chosen: Any) -> str:
    return "  ".join(f"{name}={shown(value)}" for name, value in chosen.items())
