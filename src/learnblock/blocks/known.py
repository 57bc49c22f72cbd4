"""All blocks that there are: ours, the user's, those of plugins and of installed libraries."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from learnblock import skill_files
from learnblock.blocks.configuration import BlockConfiguration, Configurations
from learnblock.blocks.derivation import derive_plugin, derived, fitted
from learnblock.blocks.libraries import installed_blocks
from learnblock.blocks.load import builtin, completed, load_configurations
from learnblock.blocks.reserved import RESERVED
from learnblock.blocks.signature import Signature, signatures
from learnblock.errors import FileError, LearnBlockError
from learnblock.home import home

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint


def known() -> Configurations:
    """Every block. A file that is wrong is left out and told, and all others are there."""
    search = _Search({**builtin()})
    for path in skill_files.own_files():
        search.users(path)
    for point in skill_files.plugins():
        search.plugin(point)
    for block in installed_blocks():
        search.found.setdefault(block.name, block)
    for path in sorted((home() / "blocks").glob("*.json")):
        search.configured(path)
    return Configurations(search.found, search.broken, tuple(search.problems))


@dataclass
class _Search:
    """What has been found so far; what comes first counts."""

    found: dict[str, BlockConfiguration]
    signatures: dict[str, Signature] = field(default_factory=dict)
    broken: dict[str, str] = field(default_factory=dict)
    problems: list[LearnBlockError] = field(default_factory=list)

    def users(self, path: Path) -> None:
        try:
            for one in signatures(skill_files.read(path), str(path)):
                self.skill(one, derived(one, str(path)))
        except FileError as error:
            self.problems.append(error)
            first = error.diagnostics[0]
            reason = f"{path.name}, line {first.line}: {first.message}"
            self.broken.update(dict.fromkeys(skill_files.names(path), reason))
        except OSError as error:
            self.problems.append(LearnBlockError(f"{path}: {error.strerror}"))

    def plugin(self, point: "EntryPoint") -> None:
        try:
            for signature, block in derive_plugin(point):
                self.skill(signature, block)
        except LearnBlockError as error:
            self.problems.append(error)
        except OSError as error:
            self.problems.append(LearnBlockError(f"the plugin `{point.name}`: {error.strerror}"))

    def skill(self, signature: Signature, block: BlockConfiguration) -> None:
        if block.name not in RESERVED and block.name not in self.found:
            self.found[block.name] = block
            self.signatures[block.name] = signature

    def configured(self, path: Path) -> None:
        try:
            blocks = load_configurations(path)
        except FileError as error:
            self.problems.append(error)
            return
        except OSError as error:
            self.problems.append(LearnBlockError(f"{path}: {error.strerror}"))
            return
        for block in blocks:
            self.found[block.name] = self.described(block)

    def described(self, block: BlockConfiguration) -> BlockConfiguration:
        """A block as a configuration describes it, and as it was known before."""
        before = self.found.get(block.name)
        signature = self.signatures.get(block.name)
        if before is None:
            return block
        return fitted(block, signature, before) if signature else completed(block, before)
