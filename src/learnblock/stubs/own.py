"""Stub files for the user's own robots and skills.

They are a package ``learnblock_home`` beside the user's programs, of stub files only: the modules
themselves are in a folder that editors do not search. Python ignores it, since it can't be run.
"""

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from itertools import chain
from pathlib import Path

from learnblock import robots
from learnblock.blocks.reserved import RESERVED
from learnblock.blocks.schema.loading import builtin
from learnblock.blocks.source.derivation import plugin_source
from learnblock.client import Client, skill_sets
from learnblock.client.extra_camera import extra_devices
from learnblock.errors import LearnBlockError
from learnblock.robots.real import RealRobot
from learnblock.robots.simulated import SimulatedRobot
from learnblock.senses import equipment
from learnblock.storage import skill_files
from learnblock.storage.files import save
from learnblock.stubs.methods import Method, methods_of
from learnblock.stubs.skill_sets import (
    NOTHING,
    OWN,
    Needs,
    built_in_methods,
    group_name,
    grouped,
    import_lines,
    serves,
)

#: What a stub says of a robot's base class, each with its type arguments.
_BASES: dict[type[Client], str] = {SimulatedRobot: "", RealRobot: "[Any]", Client: ""}


def write_stubs(folder: Path) -> Path:
    """Write the stub files for the user's own robots and skills.

    Returns:
        The stub package of the user's folder, which has the skills.

    Raises:
        SettingsError: the settings of camera recognition are invalid.
        OSError: one cannot be written.
    """
    for path, text in stub_files(folder).items():
        save(path, text.encode())
    return stub_package(folder)


def stub_package(folder: Path) -> Path:
    """The stub package of the user's own robots and skills in a folder of programs."""
    return folder / OWN.partition(".")[0]


def stub_files(folder: Path) -> dict[Path, str]:
    """The stub files for the user's own robots and skills.

    A robot that cannot be loaded gets none, and neither does a file of skills that is not Python.

    Args:
        folder: that of the user's programs.

    Raises:
        SettingsError: the settings of camera recognition are invalid.
    """
    package = stub_package(folder)
    groups = tuple(grouped(built_in_methods()))
    files = {
        package / "__init__.pyi": "",
        package / "own_skills.pyi": _own_skills(groups),
        package / "robots" / "__init__.pyi": "",
    }
    for entry in robots.entries().values():
        if entry.path:
            with suppress(LearnBlockError):
                path = package / "robots" / f"{entry.path.stem}.pyi"
                files[path] = _robot(entry.load(), groups)
    return files


def _own_skills(groups: Sequence[Needs]) -> str:
    methods = tuple(_methods())
    camera = equipment(extra_devices(frozenset()), frozenset())
    added = [needs for needs in groups if needs != NOTHING and serves(camera, needs)]
    text = "\n\n".join(method.text for method in methods) or "    ..."
    bases = f"({', '.join(map(_group, added))})" if added else ""
    return _stub("Your own skills on every robot.", methods, f"class OwnSkills{bases}:\n{text}")


def _robot(kind: type[Client], groups: Sequence[Needs]) -> str:
    own = kind.known_equipment()
    base = next(base for base in _BASES if issubclass(kind, base))
    served = [_group(needs) for needs in groups if serves(own, needs)]
    bases = [f"{base.__name__}{_BASES[base]}", "OwnSkills", *served]
    rows = "".join(f"    {each},\n" for each in bases)
    summary = (kind.__doc__ or kind.__module__).strip().partition("\n")[0]
    lines = (
        "from typing import Any",
        f"from {base.__module__} import {base.__name__}",
        f"from {OWN} import OwnSkills",
        "",
        f"class Robot(\n{rows}):",
        f'    """{summary}"""',
    )
    return _stub("A robot of your own.", (), "\n".join(lines))


def _stub(summary: str, methods: Iterable[Method], text: str) -> str:
    sets, name = skill_sets.__name__.rpartition(".")[::2]
    imports = "\n".join(filter(None, (import_lines(methods), f"from {sets} import {name}")))
    return "\n\n".join([f'"""{summary} Written by `learnblock stubs`."""', imports, text]) + "\n"


def _group(needs: Needs) -> str:
    return f"skill_sets.{group_name(needs)}"


def _methods() -> Iterator[Method]:
    """The skills of the user's files and of plugins; the first of a name counts."""
    names = {*RESERVED, *builtin()}
    for method in chain.from_iterable(map(_methods_in, _files())):
        if method.name not in names:
            names.add(method.name)
            yield method


def _files() -> Iterator[Path]:
    yield from skill_files.own_files()
    for point in skill_files.plugins():
        with suppress(LearnBlockError):
            yield plugin_source(point)


def _methods_in(path: Path) -> tuple[Method, ...]:
    try:
        return tuple(methods_of(skill_files.read(path), str(path)))
    except (LearnBlockError, OSError):
        return ()
