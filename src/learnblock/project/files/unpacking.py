"""Finds a place for what a project carries, without replacing what the user already has.

Worlds and tag names are data, and are there at once. Code is only offered, and installed if the
user asks for it.
"""

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, TypeVar

from learnblock.errors import LearnBlockError, phrase_of
from learnblock.extensions import custom_blocks, libraries
from learnblock.extensions.libraries import Library
from learnblock.i18n import Phrase
from learnblock.perception import tag_names
from learnblock.project.files.carried import Carried, CarriedWorld, Code
from learnblock.project.files.packing import block_file, library_file
from learnblock.project.files.project import Project
from learnblock.storage.home import saved_home_id

Value = TypeVar("Value")


@dataclass(frozen=True)
class UnpackedProject:
    """A project whose things have been found here.

    Args:
        project: the project; it carries only the code that is offered.
        remarks: what differs from the computer where it was saved.
        notes: what has been added to the user's things.
        adds_world: whether a world has been added to them.
    """

    project: Project
    remarks: tuple[Phrase, ...] = ()
    notes: tuple[Phrase, ...] = ()
    adds_world: bool = False


@dataclass(frozen=True)
class _Found:
    """A part of a project as it is here."""

    value: Any
    remarks: tuple[Phrase, ...] = ()
    notes: tuple[Phrase, ...] = ()
    is_new: bool = False


def unpacked(project: Project) -> UnpackedProject:
    """Unpack what a project carries.

    In the folder where the project was saved, the user's things are newer than its copies.
    """
    carried, is_home = project.carried, is_at_home(project)
    world = _world(project.world, carried.world, is_home=is_home)
    tags = _tags(project.tags, carried.tags, is_home=is_home)
    offered = offered_code(project)
    unpacked = replace(
        project, world=world.value, tags=tags.value, carried=Carried(offered=offered)
    )
    return UnpackedProject(
        unpacked, (*world.remarks, *tags.remarks), (*world.notes, *tags.notes), world.is_new
    )


def only_read(project: Project) -> UnpackedProject:
    """Unpack what a project carries, and add nothing to the user's things.

    A world of the user's with the name of the carried one is taken for it.
    """
    offered = Carried(offered=offered_code(project))
    return UnpackedProject(replace(project, tags=dict(tags_used(project)), carried=offered))


def is_at_home(project: Project) -> bool:
    """Whether a project was saved with the things of this user's folder."""
    return bool(project.carried.home) and project.carried.home == saved_home_id()


def offered_code(project: Project) -> Code:
    """The code that a project carries and the user has not installed."""
    carried, is_home = project.carried, is_at_home(project)
    return Code(
        _missing(carried.offered.blocks, carried.code.blocks, block_file, is_home=is_home),
        _missing(carried.offered.libraries, carried.code.libraries, library_file, is_home=is_home),
    )


def tags_used(project: Project) -> Mapping[str, int]:
    """The numbers of tags that a project uses before the user's, which stay as they are."""
    if not is_at_home(project):
        return {**project.carried.tags, **project.tags}
    try:
        user_numbers = tag_names.tag_names()
    except (LearnBlockError, OSError):
        user_numbers = {}
    copies = project.carried.tags.items()
    return {**{name: number for name, number in copies if name not in user_numbers}, **project.tags}


def _missing(
    offered: Mapping[str, Value],
    copies: Mapping[str, Value],
    here: Callable[[str], Any],
    *,
    is_home: bool,
) -> dict[str, Value]:
    """The code that is not installed here, or not in this form."""

    def is_missing(name: str, code: Value) -> bool:
        there = here(name)
        return there is None if is_home and name not in offered else there != code

    codes = {**copies, **offered}
    return {name: code for name, code in codes.items() if is_missing(name, code)}


def _world(name: str, carried: CarriedWorld | None, *, is_home: bool) -> _Found:
    """The name of the project's world here."""
    from learnblock.extensions import worlds  # noqa: PLC0415 - it loads the simulator

    if carried is None or carried.name != name:
        return _Found(name)
    before = worlds.own_names()
    if is_home and name in before:
        return _Found(name)
    packed = worlds.PackedWorld(name, "\n".join(carried.file), carried.picture)
    try:
        here = worlds.install(packed)
    except (LearnBlockError, OSError) as error:
        damaged = Phrase("project-world-damaged", world=name, problem=phrase_of(error))
        return _Found(name, (damaged,))
    is_new = here not in before and here in worlds.own_names()
    if here != name:
        renamed = Phrase("project-world-renamed", world=name, here=here)
        return _Found(here, (renamed,), is_new=is_new)
    added = (Phrase("project-world-added", world=here),) if is_new else ()
    return _Found(here, notes=added, is_new=is_new)


def _tags(own: Mapping[str, int], carried: Mapping[str, int], *, is_home: bool) -> _Found:
    """The numbers of tags that the project uses instead of the user's."""
    all_numbers = {**carried, **own}
    if not all_numbers:
        return _Found({})
    try:
        user_numbers = dict(tag_names.tag_names())
        missing = {name: number for name, number in all_numbers.items() if name not in user_numbers}
        if missing:
            tag_names.save_names({**user_numbers, **missing})
    except (LearnBlockError, OSError):
        # The project has its own numbers even if the user's file is damaged or full.
        return _Found(all_numbers)
    numbers = (own if is_home else all_numbers).items()
    differing = {
        name: number for name, number in numbers if user_numbers.get(name, number) != number
    }
    return _Found(
        differing,
        tuple(
            Phrase("project-tag-differs", name=name, number=number, here=user_numbers[name])
            for name, number in differing.items()
        ),
        (Phrase("project-tags-added", names=tuple(sorted(missing))),) if missing else (),
    )


def without(code: Code, installed: Code) -> Code:
    """The code that has not been installed."""
    return Code(
        {name: block for name, block in code.blocks.items() if installed.blocks.get(name) != block},
        {
            name: library
            for name, library in code.libraries.items()
            if installed.libraries.get(name) != library
        },
    )


def install(code: Code) -> None:
    """Install offered code, which only the user may ask for; what it replaces is in the trash.

    Raises:
        LearnBlockError: some of it is invalid or has the name of another skill.
        OSError: it can't be written.
    """
    coming = [_unpacked(name, files) for name, files in code.libraries.items()]
    for library in coming:
        libraries.keep(library.name)
    libraries.install(coming, replace=True)
    for name, file in code.blocks.items():
        _install_block(name, file)


def _install_block(name: str, file: Mapping[str, object]) -> None:
    if block_file(name) is None:
        custom_blocks.import_file(json.dumps(file))
        return
    custom_blocks.delete(name)
    try:
        custom_blocks.import_file(json.dumps(file))
    except (LearnBlockError, OSError):
        custom_blocks.restore(name)
        raise


def _unpacked(name: str, files: Mapping[str, list[str]]) -> Library:
    return libraries.from_files(
        {file: "\n".join(lines).encode() for file, lines in files.items()}, name
    )
