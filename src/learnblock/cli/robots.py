"""The commands for robots: list, settings, search, test, setup and emulators."""

import sys
from collections.abc import Mapping
from functools import partial
from typing import Any

import click

from learnblock.cli.console import (
    ExitCode,
    json_option,
    print_command,
    print_json,
    print_settings,
    say,
    text,
    typed,
    usage_error,
)
from learnblock.errors import LearnBlockError, UnknownNameError
from learnblock.i18n import Phrase

#: Seconds that a driver may take longer to look for robots than it should.
_LATE = 5.0
_NAME = click.argument("name", metavar="ROBOT")
_VERDICTS = {
    True: Phrase("cli-device-works"),
    False: Phrase("cli-device-fails"),
    None: Phrase("cli-device-skipped"),
}


@click.group("robots", invoke_without_command=True)
@json_option
@click.pass_context
def robots_group(ctx: click.Context, as_json: bool) -> None:  # noqa: FBT001 - a click flag
    """List robots; configure, find or test real ones.

    \b
    learnblock robots scan
    learnblock robots set cozmo address 192.168.1.20
    learnblock robots test cozmo
    """  # noqa: D301 - click wants the character itself
    if ctx.invoked_subcommand is None:
        from learnblock.cli.listing import robot_list  # noqa: PLC0415 - `--help` needs none of it

        robot_list(as_json=as_json)


@robots_group.command("set")
@_NAME
@click.argument("setting", required=False)
@click.argument("value", required=False)
@click.option("--default", is_flag=True, help="Restore the default.")
@json_option
def set_command(
    name: str,
    setting: str | None,
    value: str | None,
    default: bool,  # noqa: FBT001 - a click flag
    as_json: bool,  # noqa: FBT001
) -> None:
    """Show or change the settings of a real robot.

    \b
    learnblock robots set ev3
    learnblock robots set ev3 wheel_radius 28
    learnblock robots set ev3 wheel_radius --default
    """  # noqa: D301 - click wants the character itself
    from learnblock.robots import settings  # noqa: PLC0415

    robot = _real(name)
    if default and (setting is None or value is not None):
        raise usage_error("cli-default-without-value")
    if setting is not None and (value is not None or default):
        settings.change(robot.name(), robot.settings_type, setting, value)
    by_name = {
        setting.name: setting for setting in settings.describe(robot.name(), robot.settings_type)
    }
    if setting is not None and setting not in by_name:
        raise UnknownNameError("setting", setting, by_name)
    print_settings([by_name[setting]] if setting else list(by_name.values()), as_json=as_json)


@robots_group.command()
@click.argument("names", metavar="[ROBOT]...", nargs=-1)
@click.option(
    "--seconds",
    type=click.FloatRange(0.1, 60),
    default=3.0,
    show_default=True,
    help="How long to search for each kind of robot.",
)
@json_option
def scan(names: tuple[str, ...], seconds: float, as_json: bool) -> None:  # noqa: FBT001
    """Find real robots on serial ports, on the network and on this computer."""
    rows, problems = _scan(_kinds(names), seconds)
    if as_json:
        print_json([*rows, *problems])
        return
    for row in rows:
        click.echo(f"{row['robot']:<12} {_spelled(row['settings'])}")
    for problem in problems:
        click.echo(f"{problem['robot']:<12} {text(problem['problem'])}")
    if not rows:
        say("cli-no-robot-found")


@robots_group.command()
@_NAME
@click.option("--yes", is_flag=True, help="Do not ask; the robot drives at once.")
def test(name: str, yes: bool) -> None:  # noqa: FBT001 - a click flag
    """Test every device of a robot, one after the other."""
    from learnblock.robots import find  # noqa: PLC0415
    from learnblock.testing.trial import try_out  # noqa: PLC0415

    works = True
    with find(name).load()() as robot:
        for trial in try_out(robot, _agree if yes else _ask):
            works = works and trial.works is not False
            verdict = text(_VERDICTS[trial.works])
            click.echo(f"{verdict:<9} {trial.what:<24} {text(trial.detail)}")
    sys.exit(ExitCode.WELL if works else ExitCode.MISTAKES)


def _ask(question: Phrase) -> bool:
    return click.confirm(text(question))


def _agree(question: Phrase) -> bool:
    """Answer yes without asking."""
    del question
    return True


@robots_group.command()
@_NAME
def setup(name: str) -> None:
    """Prepare a robot: copy our agent to an EV3 brick, or our scripts into a scene."""
    from learnblock.robots import settings  # noqa: PLC0415

    robot = _real(name)
    robot.set_up(settings.load(robot.name(), robot.settings_type), _report)


def _report(step: Phrase) -> None:
    click.echo(text(step))


@click.command("emulate")
@_NAME
@click.option("--world", metavar="NAME", help="The world's name or file.")
@click.option("--seed", type=int, default=0, help="Seed of all noise.")
def emulate_command(name: str, world: str | None, seed: int) -> None:
    """Emulate a robot to try its driver.

    The driver then moves a simulated robot. Press Ctrl-C to stop.

    \b
    learnblock emulate cozmo --world tags
    """  # noqa: D301 - click wants the character itself
    from learnblock import emulators  # noqa: PLC0415
    from learnblock.cli.interrupts import served_until_ctrl_c  # noqa: PLC0415

    place = emulators.usual_place(name)
    with emulators.emulate(name, world, seed=seed, **place) as emulation, served_until_ctrl_c():
        say("cli-emulating", robot=name)
        for setting, value in emulation.settings.items():
            spelled = value if isinstance(value, str) else typed(value)
            print_command("learnblock", "robots", "set", name, setting, spelled)
        print_command("learnblock", "run", "PROGRAM", "--robot", name)
        if emulation.note:
            click.echo(text(emulation.note))


def _real(name: str) -> Any:
    """The class of a robot that has settings."""
    from learnblock.robots import find  # noqa: PLC0415
    from learnblock.robots.real import RealRobot  # noqa: PLC0415

    robot = find(name).load()
    if not issubclass(robot, RealRobot):
        raise LearnBlockError("cli-robot-without-settings", robot=name)
    return robot


def _kinds(names: tuple[str, ...]) -> list[Any]:
    """The classes of the real robots with these names, by default of all."""
    from learnblock.robots import entries  # noqa: PLC0415
    from learnblock.robots.real import RealRobot  # noqa: PLC0415

    if names:
        return [_real(name) for name in names]
    kinds = [entry.load() for entry in entries().values() if not entry.name.startswith("sim-")]
    return [kind for kind in kinds if issubclass(kind, RealRobot)]


Row = dict[str, Any]


def _scan(kinds: list[Any], seconds: float) -> tuple[list[Row], list[Row]]:
    """Search for all kinds of robots at the same time.

    Returns:
        Every robot that answers, and every kind that can't be searched for, with its problem.
    """
    from learnblock.runtime.containment.driver import OwnThread  # noqa: PLC0415

    rows: list[Row] = []
    problems: list[Row] = []
    looks = [(kind.name(), OwnThread(partial(_look, kind, seconds))) for kind in kinds]
    for _, look in looks:
        look.start()
    for name, look in looks:
        try:
            robots = look.result(seconds + _LATE)
        except TimeoutError:
            problems.append({"robot": name, "problem": Phrase("cli-robot-scan-late", robot=name)})
        except LearnBlockError as error:
            problems.append({"robot": name, "problem": error.phrase})
        else:
            rows += ({"robot": name, "settings": dict(settings)} for settings in robots)
    return rows, problems


def _look(kind: Any, seconds: float) -> list[Mapping[str, Any]]:
    if command := kind.missing_add_on():
        raise LearnBlockError("cli-robot-needs-add-on", command=command)
    return list(kind.scan(seconds))


def _spelled(values: Any) -> str:
    return "  ".join(f"{name}={typed(value)}" for name, value in values.items())
