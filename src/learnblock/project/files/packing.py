"""Puts into a project what it needs of its author's own things."""

import json
import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import msgspec

from learnblock.errors import LearnBlockError, ProjectError
from learnblock.extensions import custom_blocks, libraries
from learnblock.perception import tag_names
from learnblock.project.files.carried import NOTHING, Carried, CarriedWorld, Code
from learnblock.project.files.project import Project
from learnblock.project.files.project_file import encode
from learnblock.storage import skill_files
from learnblock.storage.home import home_id

_WORD = re.compile(r"\w+")
#: The import of a library in Block-Text, and in Python; a program with mistakes has them too.
_LIBRARY = re.compile(r'^import[ \t]+"?(\w+)|\blibraries\.(\w+)', re.MULTILINE)


def encode_whole(project: Project, *, leaves: bool = False) -> bytes:
    """Encode a project with as much of what it needs as a file can have.

    Args:
        project: the project.
        leaves: whether the file leaves this folder, so that its copies count as foreign.

    Raises:
        ProjectError: even alone it is larger than a project may be.
    """
    whole = packed(project, "" if leaves else home_id())
    without_world = msgspec.structs.replace(whole.carried, world=None)
    for candidate in (whole, replace(whole, carried=without_world)):
        with suppress(ProjectError):
            return encode(candidate)
    return encode(replace(project, carried=NOTHING))


def fits(project: Project) -> bool:
    """Whether a file can have everything that a project needs."""
    try:
        return bool(encode(packed(project, "")))
    except ProjectError:
        return False


# Why: docs/decisions.md, "Every save carries what the program needs"
def packed(project: Project, home: str) -> Project:
    """Put into a project the world, blocks, libraries and tag names that it uses.

    What can't be read is left out: the project itself must be saved all the same.
    """
    texts = [text for part in project.parts for text in (part.blocktext, part.python or "")]
    code = _code(project, texts)
    carried = Carried(
        home=home,
        world=_world(project.world),
        tags=_tags(project, "\n".join(texts)),
        code=code,
        offered=project.carried.offered,
    )
    return replace(project, carried=carried if carried else NOTHING)


def block_file(name: str) -> dict[str, object] | None:
    """A custom block as in its exported file; None if there is none that can be read."""
    try:
        block: dict[str, object] = json.loads(custom_blocks.export(name)[1])
    except (LearnBlockError, OSError):
        return None
    return block


def library_file(name: str) -> dict[str, list[str]] | None:
    """The lines of each file of an installed library; None if there is none that can be read."""
    try:
        library = libraries.installed(name)
    except (LearnBlockError, OSError):
        return None
    return {file: text.split("\n") for file, text in library.files.items()}


def _world(name: str) -> CarriedWorld | None:
    from learnblock.extensions import worlds  # noqa: PLC0415 - it loads the simulator

    if name not in worlds.own_names():
        return None
    try:
        world = worlds.find(name)
    except (LearnBlockError, OSError, UnicodeDecodeError):
        return None
    return CarriedWorld(name, world.text.split("\n"), world.picture)


def _code(project: Project, texts: list[str]) -> Code:
    """The code that the texts use; its own texts are added to them."""
    own = dict(_skills())
    library_names = {*project.libraries}
    blocks: dict[str, dict[str, object]] = {}
    packages: dict[str, dict[str, list[str]]] = {}
    # Code may use other code, so each text is read for more.
    for text in texts:
        words = {*_WORD.findall(text)}
        library_names |= {match[1] or match[2] for match in _LIBRARY.finditer(text)}
        for name in [name for name, skills in own.items() if words & skills]:
            del own[name]
            if block := block_file(name):
                blocks[name] = block
                texts.append("\n".join(map(str, block["source"])))  # type: ignore[call-overload]
        for name in sorted(library_names - packages.keys()):
            if files := library_file(name):
                packages[name] = files
                texts.extend("\n".join(lines) for lines in files.values())
    return Code(blocks, packages)


def _skills() -> Iterator[tuple[str, set[str]]]:
    """The custom blocks, each with the names of its functions."""
    for path in skill_files.own_files():
        with suppress(OSError):
            yield path.stem, {*skill_files.names(path)}


def _tags(project: Project, text: str) -> dict[str, int]:
    """The tags whose names occur in the program or its code."""
    try:
        numbers = {**tag_names.tag_names(), **project.tags}
    except (LearnBlockError, OSError):
        numbers = dict(project.tags)
    return {name: number for name, number in numbers.items() if name in text}
