"""The command line's lists: robots, worlds and skills."""

from typing import Any

import click
import msgspec

from learnblock import robots
from learnblock.blocks import all_configurations
from learnblock.blocks.configuration import BlockConfiguration, Parameter
from learnblock.console import print_json
from learnblock.errors import LearnBlockError, UnknownNameError


def robot_list(*, as_json: bool) -> None:
    """Print every robot with its devices."""
    listed = [_robot(entry) for entry in robots.entries().values()]
    if as_json:
        print_json(listed)
        return
    width = max(len(robot["name"]) for robot in listed)
    for robot in listed:
        click.echo(f"{robot['name']:<{width}} {', '.join(robot['devices']) or robot['problem']}")


def _robot(entry: robots.RobotEntry) -> dict[str, Any]:
    devices: frozenset[str] | None = None
    problem = ""
    try:
        devices = entry.load().device_names()
        problem = "" if devices else "(what its settings say)"
    except LearnBlockError as error:
        problem = str(error)
    return {
        "name": entry.name,
        "module": entry.module,
        "devices": sorted(devices or ()),
        "problem": problem,
    }


def world_list(*, as_json: bool) -> None:
    """Print every world of the simulator."""
    from learnblock.robots.simulated import worlds  # noqa: PLC0415 - only this list needs them

    listed = [
        {
            "name": world.name,
            "title": world.title,
            "goals": [goal.name for goals in msgspec.structs.astuple(world.goal) for goal in goals],
        }
        for world in worlds()
    ]
    if as_json:
        print_json(listed)
        return
    for world in listed:
        click.echo(f"{world['name']:<14} {world['title']}")


def skill_list(name: str | None, *, as_json: bool) -> None:
    """Print every skill, or all about one."""
    skills = all_configurations()
    if name is not None and name not in skills:
        raise UnknownNameError("skill", name, skills)
    listed = [skills[name]] if name else list(skills.values())
    if as_json:
        print_json([_skill(skill) for skill in listed])
    elif name:
        _describe(listed[0])
    else:
        _print_by_category(listed)


def _print_by_category(skills: list[BlockConfiguration]) -> None:
    category = ""
    for skill in sorted(skills, key=lambda skill: skill.category):
        if skill.category != category:
            category = skill.category
            click.echo(f"\n{category}")
        click.echo(f"  {_signature(skill):<46} {skill.tooltip.get('EN', '')}")


def _describe(skill: BlockConfiguration) -> None:
    click.echo(_signature(skill))
    for language, label in sorted(skill.languages.items()):
        click.echo(f"  {language}:      {label}: {skill.tooltip.get(language, '')}")
    click.echo(f"  answers: {'a value' if skill.returns_value else 'nothing'}")
    click.echo(f"  needs:   {', '.join(skill.needs) or 'no device'}")
    click.echo(f"  Block-Text: function.{_signature(skill)}")
    click.echo(f"  Python:     robot.{_signature(skill)}")


def _signature(skill: BlockConfiguration) -> str:
    return f"{skill.name}({', '.join(map(_parameter, skill.parameters))})"


def _parameter(parameter: Parameter) -> str:
    return parameter.name if parameter.required else f"{parameter.name}={parameter.default!r}"


def _skill(skill: BlockConfiguration) -> dict[str, object]:
    return {
        "name": skill.name,
        "category": skill.category,
        "parameters": list(skill.parameters),
        "returns_value": skill.returns_value,
        "needs": list(skill.needs),
        "languages": dict(skill.languages),
        "tooltip": dict(skill.tooltip),
    }
