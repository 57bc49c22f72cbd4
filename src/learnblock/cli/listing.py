"""The commands that list robots, worlds and skills."""

from typing import TYPE_CHECKING, Any

import click

from learnblock.cli.console import json_option, print_json, say, text
from learnblock.cli.language import language

if TYPE_CHECKING:
    from collections.abc import Iterable

    from learnblock.blocks import BlockConfiguration, Parameter
    from learnblock.client import Client
    from learnblock.robots import RobotEntry


@click.command()
@json_option
def worlds(as_json: bool) -> None:  # noqa: FBT001 - a click flag
    """List the worlds of the simulator."""
    from learnblock.robots.simulated import (  # noqa: PLC0415 - `--help` needs none of it
        worlds as all_worlds,
    )

    rows = [
        {
            "name": world.name,
            "title": world.title,
            "goals": [goal.name for _, _, goal in world.goal.all()],
        }
        for world in all_worlds()
    ]
    if as_json:
        print_json(rows)
        return
    for world in rows:
        click.echo(f"{world['name']:<14} {world['title']}")


@click.command()
@click.argument("name", required=False)
@json_option
def skills(name: str | None, as_json: bool) -> None:  # noqa: FBT001 - a click flag
    """List the skills, or describe one.

    Shows what each skill does and the devices it needs.
    """
    from learnblock.blocks.known import all_configurations  # noqa: PLC0415
    from learnblock.errors import UnknownNameError  # noqa: PLC0415

    configurations = all_configurations()
    if name is not None and name not in configurations:
        raise UnknownNameError("skill", name, configurations)
    selection = [configurations[name]] if name else list(configurations.values())
    if as_json:
        print_json([_skill(skill) for skill in selection])
    elif name:
        _describe(selection[0])
    else:
        _print_by_category(selection)


def robot_list(*, as_json: bool) -> None:
    """Print every robot with its devices."""
    from learnblock import robots  # noqa: PLC0415 - `--help` needs none of it

    rows = [_robot(entry) for entry in robots.entries().values()]
    if as_json:
        print_json(rows)
        return
    width = max(len(robot["name"]) for robot in rows)
    for robot in rows:
        parts = [", ".join(robot["devices"])] if robot["devices"] else []
        if robot["problem"]:
            parts.insert(0, text(robot["problem"]))
        click.echo(f"{robot['name']:<{width}} {'; '.join(parts)}")


def _robot(entry: "RobotEntry") -> dict[str, Any]:
    from learnblock.errors import LearnBlockError  # noqa: PLC0415
    from learnblock.i18n import Phrase  # noqa: PLC0415

    devices: frozenset[str] | None = None
    problem: Phrase | str = ""
    try:
        kind = entry.load()
        devices = kind.device_names()
        problem = "" if devices else Phrase("cli-devices-by-settings")
        if command := _missing_add_on(kind):
            problem = Phrase("cli-robot-needs-add-on", command=command)
    except LearnBlockError as error:
        problem = error.phrase
    return {
        "name": entry.name,
        "module": entry.module,
        "devices": sorted(devices or ()),
        "problem": problem,
    }


def _missing_add_on(kind: "type[Client]") -> str:
    from learnblock.robots.real import RealRobot  # noqa: PLC0415

    return kind.missing_add_on() if issubclass(kind, RealRobot) else ""


def _print_by_category(skills: "Iterable[BlockConfiguration]") -> None:
    category = ""
    for skill in sorted(skills, key=lambda skill: skill.category):
        if skill.category != category:
            category = skill.category
            click.echo(f"\n{category}")
        click.echo(f"  {_signature(skill):<46} {tooltip(skill)}")


def _describe(skill: "BlockConfiguration") -> None:
    from learnblock.blocks.labels import label  # noqa: PLC0415

    click.echo(_signature(skill))
    click.echo(f"  {tooltip(skill)}")
    say("cli-skill-block", label=label(skill, language()))
    say("cli-skill-returns", kind="value" if skill.returns_value else "nothing")
    click.echo(f"  Block-Text: function.{_signature(skill)}")
    click.echo(f"  Python: robot.{_signature(skill)}")
    if not skill.needs:
        say("cli-skill-needs-nothing")
        return
    from learnblock.cli.robot_table import print_serving  # noqa: PLC0415
    from learnblock.language.check.robots import device_phrase  # noqa: PLC0415

    say("cli-skill-needs", devices=tuple(map(device_phrase, skill.needed())))
    print_serving(skill)


def tooltip(skill: "BlockConfiguration") -> str:
    """The tooltip of a skill's block in the reader's language."""
    from learnblock.blocks.labels import translated  # noqa: PLC0415

    return translated(skill.tooltip, language(), "")


def _signature(skill: "BlockConfiguration") -> str:
    return f"{skill.name}({', '.join(map(_parameter, skill.parameters))})"


def _parameter(parameter: "Parameter") -> str:
    return parameter.name if parameter.required else f"{parameter.name}={parameter.default!r}"


def _skill(skill: "BlockConfiguration") -> dict[str, object]:
    return {
        "name": skill.name,
        "category": skill.category,
        "parameters": list(skill.parameters),
        "returns_value": skill.returns_value,
        "needs": list(skill.needs),
        "languages": dict(skill.languages),
        "tooltip": dict(skill.tooltip),
    }
