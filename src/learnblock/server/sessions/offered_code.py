"""The code that a project carries, for the user to read before it is installed."""

from collections.abc import Mapping

from learnblock.project.files.carried import Code
from learnblock.project.files.packing import block_file, library_file
from learnblock.server import messages

#: The limit in characters of what a page shows of one block or library.
_LONGEST_SOURCE = 50_000


def offer(code: Code) -> messages.CodeOffered:
    """The message to pages, with the sources for the user to read."""
    return messages.CodeOffered(
        tuple(_block(name, file) for name, file in code.blocks.items()),
        tuple(_library(name, files) for name, files in code.libraries.items()),
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
