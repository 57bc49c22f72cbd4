"""Every block: built in, custom, from plugins and from installed libraries."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from learnblock.blocks.installed_libraries import installed_blocks
from learnblock.blocks.reserved import RESERVED
from learnblock.blocks.schema.configuration import BlockConfiguration, Configurations
from learnblock.blocks.schema.loading import builtin, completed, load_configurations
from learnblock.blocks.source.derivation import derive_plugin, derived, fitted
from learnblock.blocks.source.signature import Signature, signatures
from learnblock.blocks.source.uses import with_needs
from learnblock.errors import FileError, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.storage import skill_files
from learnblock.storage.home import home

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint


def all_configurations() -> Configurations:
    """Every block by name: built in, custom, from plugins and from installed libraries.

    A skill without a configuration gets one from its signature and docstring. A file in the
    ``blocks`` folder of `home` can describe such a skill better, or adds translations to any block.
    An invalid file is left out and reported in `Configurations.problems`.
    """
    search = _Search({**builtin()})
    for path in skill_files.own_files():
        search.users(path)
    for point in skill_files.plugins():
        search.plugin(point)
    for block in installed_blocks():
        search.blocks.setdefault(block.name, block)
    for path in sorted((home() / "blocks").glob("*.json")):
        search.configured(path)
    search.add_needs()
    return Configurations(search.blocks, search.broken, tuple(search.problems))


@dataclass
class _Search:
    """The blocks found so far; if several have the same name, the first one is used."""

    blocks: dict[str, BlockConfiguration]
    signatures: dict[str, Signature] = field(default_factory=dict)
    broken: dict[str, Phrase] = field(default_factory=dict)
    problems: list[LearnBlockError] = field(default_factory=list)

    def users(self, path: Path) -> None:
        try:
            for signature in signatures(skill_files.read(path), str(path)):
                self.skill(signature, derived(signature, str(path)))
        except FileError as error:
            self.problems.append(error)
            first = error.diagnostics[0]
            reason = Phrase(
                "block-broken-file", file=path.name, line=str(first.line), reason=first.message
            )
            self.broken.update(dict.fromkeys(skill_files.names(path), reason))
        except OSError as error:
            self.problems.append(_unreadable(path, error))

    def plugin(self, point: "EntryPoint") -> None:
        try:
            for signature, block in derive_plugin(point):
                self.skill(signature, block)
        except LearnBlockError as error:
            self.problems.append(error)
        except OSError as error:
            reason = str(error.strerror)
            problem = LearnBlockError("block-plugin-unreadable", plugin=point.name, reason=reason)
            self.problems.append(problem)

    def skill(self, signature: Signature, block: BlockConfiguration) -> None:
        if block.name not in RESERVED and block.name not in self.blocks:
            self.blocks[block.name] = block
            self.signatures[block.name] = signature

    def configured(self, path: Path) -> None:
        try:
            blocks = load_configurations(path)
        except FileError as error:
            self.problems.append(error)
            return
        except OSError as error:
            self.problems.append(_unreadable(path, error))
            return
        for block in blocks:
            self.blocks[block.name] = self.described(block)

    def add_needs(self) -> None:
        """Add what custom skills need by their source."""
        uses = {name: signature.uses for name, signature in self.signatures.items()}
        others = {
            name: configuration for name, configuration in self.blocks.items() if name not in uses
        }
        own = [self.blocks[name] for name in uses]
        self.blocks.update(
            {configuration.name: configuration for configuration in with_needs(own, uses, others)}
        )

    def described(self, block: BlockConfiguration) -> BlockConfiguration:
        """A configured block, completed from its earlier configuration."""
        before = self.blocks.get(block.name)
        signature = self.signatures.get(block.name)
        if before is None:
            return block
        return fitted(block, signature, before) if signature else completed(block, before)


def _unreadable(path: Path, error: OSError) -> LearnBlockError:
    return LearnBlockError("block-file-unreadable", file=str(path), reason=str(error.strerror))
