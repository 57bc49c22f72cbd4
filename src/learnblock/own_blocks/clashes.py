"""Names that the functions of a block of one's own cannot have, since others have them."""

from collections.abc import Iterator, Mapping
from contextlib import suppress

from learnblock import skill_files
from learnblock.blocks.derivation import derive_plugin
from learnblock.blocks.libraries import installed_blocks
from learnblock.blocks.load import builtin
from learnblock.blocks.reserved import RESERVED
from learnblock.errors import LearnBlockError


def taken_names(*, but: str = "", others: Mapping[str, str] | None = None) -> Mapping[str, str]:
    """The names, each with a sentence that says whose it is.

    Args:
        but: the name of the block whose own functions are left out.
        others: what `others_names` answers, if that was asked already.
    """
    taken: dict[str, str] = {}
    for path in skill_files.own_files():
        if path.stem != but:
            reason = f"your block `{path.stem}` has a function of this name already"
            taken |= dict.fromkeys(skill_files.names(path), reason)
    return {**taken, **(others_names() if others is None else others)}


def others_names() -> Mapping[str, str]:
    """Those that are not the user's own."""
    taken = {block.name: _of_library(block.library) for block in installed_blocks()}
    taken |= dict.fromkeys(_of_plugins(), "a plugin has a skill of this name already")
    taken |= dict.fromkeys(RESERVED, "every robot has something of this name already")
    taken |= dict.fromkeys(builtin(), "LearnBlock has a skill of this name already")
    return taken


def _of_library(name: str) -> str:
    return f"the library `{name}` has a skill of this name already"


def _of_plugins() -> Iterator[str]:
    for point in skill_files.plugins():
        # One that cannot be read is told wherever all blocks are asked for.
        with suppress(LearnBlockError, OSError):
            for signature, _ in derive_plugin(point):
                yield signature.name
