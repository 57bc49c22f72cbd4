"""Names that functions of a custom block cannot have, because they are taken."""

from collections.abc import Iterator, Mapping
from contextlib import suppress

from learnblock.blocks import builtin
from learnblock.blocks.installed_libraries import installed_blocks
from learnblock.blocks.reserved import RESERVED
from learnblock.blocks.source.derivation import derive_plugin
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.storage import skill_files


def taken_names(
    *, but: str = "", others: Mapping[str, Phrase] | None = None
) -> Mapping[str, Phrase]:
    """The taken names, each with a message.

    Args:
        but: the block whose functions are left out.
        others: the result of `others_names`, if it is already known.
    """
    taken: dict[str, Phrase] = {}
    for path in skill_files.own_files():
        if path.stem != but:
            for name in skill_files.names(path):
                taken[name] = Phrase("custom-taken-by-block", name=name, block=path.stem)
    return {**taken, **(others_names() if others is None else others)}


def others_names() -> Mapping[str, Phrase]:
    """The names that are taken by anything except custom blocks."""
    taken = {
        one.name: Phrase("custom-taken-by-library", name=one.name, library=one.library)
        for one in installed_blocks()
    }
    taken |= {name: Phrase("custom-taken-by-plugin", name=name) for name in _of_plugins()}
    taken |= {name: Phrase("custom-taken-by-robot", name=name) for name in RESERVED}
    taken |= {name: Phrase("custom-taken-by-skill", name=name) for name in builtin()}
    return taken


def _of_plugins() -> Iterator[str]:
    for point in skill_files.plugins():
        # `all_configurations` reports a plugin that cannot be read.
        with suppress(LearnBlockError, OSError):
            for signature, _ in derive_plugin(point):
                yield signature.name
