"""The code that a project carries and the user has not installed: offered, and installed."""

import json
from collections.abc import Mapping

from learnblock.errors import LearnBlockError
from learnblock.extensions import custom_blocks, libraries
from learnblock.extensions.libraries import Library
from learnblock.server import messages
from learnblock.server.projects.carried import Code
from learnblock.server.projects.packing import block_file, library_file

#: The limit in characters of what a page shows of one block or library.
_LONGEST_SOURCE = 50_000


def offer(code: Code) -> messages.CodeOffered:
    """The message to pages, with the sources for the user to read."""
    return messages.CodeOffered(
        tuple(_block(name, file) for name, file in code.blocks.items()),
        tuple(_library(name, files) for name, files in code.libraries.items()),
    )


def without(code: Code, installed: Code) -> Code:
    """The code that has not been installed."""
    return Code(
        {name: one for name, one in code.blocks.items() if installed.blocks.get(name) != one},
        {name: one for name, one in code.libraries.items() if installed.libraries.get(name) != one},
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


def _block(name: str, file: Mapping[str, object]) -> messages.OfferedCode:
    source = file.get("source")
    lines = map(str, source) if isinstance(source, list) else ()
    return _offered(name, "\n".join(lines), is_here=block_file(name) is not None)


def _library(name: str, files: Mapping[str, list[str]]) -> messages.OfferedCode:
    texts = (f"# {file}\n" + "\n".join(lines) for file, lines in files.items())
    return _offered(name, "\n\n".join(texts), is_here=library_file(name) is not None)


def _offered(name: str, source: str, *, is_here: bool) -> messages.OfferedCode:
    return messages.OfferedCode(name, source[:_LONGEST_SOURCE], is_here)
