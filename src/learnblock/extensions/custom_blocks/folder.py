"""Saved custom blocks: ``skills/NAME.py`` and ``blocks/NAME.json`` in `home`.

A deleted block is moved to the folder ``deleted`` beside them, which keeps one block per name.
"""

from collections.abc import Callable, Mapping
from pathlib import Path

from learnblock.blocks.source.derivation import category_of
from learnblock.errors import (
    CustomBlockError,
    Diagnostic,
    FileError,
    LearnBlockError,
    UnknownNameError,
)
from learnblock.extensions.custom_blocks import copying, package
from learnblock.extensions.custom_blocks.checking import check, others_names, taken_names
from learnblock.extensions.custom_blocks.custom_block import (
    Checked,
    CustomBlock,
    Problem,
    checked_name,
)
from learnblock.extensions.custom_blocks.package import Package
from learnblock.i18n import Phrase
from learnblock.storage import skill_files
from learnblock.storage.files import save as save_file
from learnblock.storage.home import home


def load_all() -> tuple[CustomBlock, ...]:
    """All custom blocks sorted by name, including those with errors."""
    others = others_names()
    return tuple(_read(path, others) for path in skill_files.own_files())


def find(name: str) -> CustomBlock:
    """A custom block by its name.

    Raises:
        UnknownNameError: there is no such block.
    """
    return _read(_existing(name), others_names())


def save(name: str, source: str, configuration: str = "", *, replaces: str = "") -> Checked:
    """Save a block, unless the check finds errors in it.

    Args:
        name: the name of its files.
        source: the Python source of its functions.
        configuration: the configuration of its blocks, as JSON.
        replaces: its current name, which may be the same; empty for a new block.

    Raises:
        CustomBlockError: the name is not allowed, or another block has it.
        UnknownNameError: there is no block to replace.
        OSError: the files cannot be written; the old ones are unchanged.
    """
    name = name if name == replaces else checked_name(name)
    old = _existing(replaces) if replaces else None
    _refuse_taken(name, old)
    checked = check(source, configuration, name=name, replaces=replaces)
    if not checked.errors:
        _write(name, source, checked.chosen)
        if old is not None and not old.samefile(_source(name)):
            _remove(old)
    return checked


def duplicate(name: str, new: str) -> CustomBlock:
    """Copy a block; the functions of the copy get new names.

    Raises:
        CustomBlockError: the new name is not allowed, or the block has errors.
        UnknownNameError: there is no such block.
        ProgramError: its source is not valid Python.
        OSError: the copy cannot be written.
    """
    original = find(name)
    names = copying.new_names(original.functions, new, taken_names())
    source = copying.renamed_source(original.source, names)
    configuration = copying.renamed_configuration(original.configuration, names)
    save(new, source, configuration).require_no_errors(new)
    return find(checked_name(new))


def delete(name: str) -> None:
    """Delete a block; `restore` undoes this.

    Raises:
        UnknownNameError: there is no such block.
        OSError: it cannot be moved.
    """
    _move(_existing(name), _deleted)


def restore(name: str) -> CustomBlock:
    """Restore a deleted block.

    Raises:
        UnknownNameError: no block with that name was deleted.
        CustomBlockError: there is now another block with that name.
        OSError: it cannot be moved.
    """
    deleted = _deleted(_source(name))
    if deleted not in deleted.parent.glob("*.py"):
        raise UnknownNameError("deleted-block", name, _names(deleted.parent))
    _refuse_taken(name, None)
    _move(deleted, lambda path: path.parents[1] / path.name)
    return find(name)


def export(name: str) -> tuple[str, str]:
    """The name and the text of a file with a block.

    Raises:
        UnknownNameError: there is no such block.
        BlockConfigurationError: its configuration is invalid.
        ProgramError: its source is too large.
        OSError: it can't be read.
    """
    source = _existing(name)
    configuration = _chosen(_configuration(source))
    packed = package.pack(Package(name, skill_files.read(source), configuration))
    return name + package.ENDING, packed


def import_file(text: str, *, replace: bool = False) -> CustomBlock:
    """Import the block in an exported file.

    Args:
        text: the text of the file.
        replace: whether to replace a block with the same name.

    Raises:
        CustomBlockError: the file is invalid, or the name is taken.
        OSError: the block cannot be written.
    """
    block = package.unpack(text)
    replaces = block.name if replace and block.name in _names(_folder()) else ""
    checked = save(block.name, block.source, block.configuration, replaces=replaces)
    checked.require_no_errors(block.name)
    return find(block.name)


# Files.


def _folder() -> Path:
    return home() / "skills"


def _source(name: str) -> Path:
    return _folder() / f"{name}.py"


def _configuration(source: Path) -> Path:
    """The file of the configuration that belongs to a source file."""
    skills = _folder()
    return home() / "blocks" / source.relative_to(skills).with_suffix(".json")


def _deleted(path: Path) -> Path:
    return path.parent / "deleted" / path.name


def _names(folder: Path) -> tuple[str, ...]:
    return tuple(sorted(path.stem for path in folder.glob("*.py") if path.is_file()))


def _existing(name: str) -> Path:
    """The source file of an existing block; the name cannot lead outside the folder."""
    names = _names(_folder())
    if name not in names:
        raise UnknownNameError("block", name, names)
    return _source(name)


def _refuse_taken(name: str, old: Path | None) -> None:
    same = {path.casefold() for path in _names(_folder()) if old is None or path != old.stem}
    if name.casefold() in same:
        message = Phrase("custom-name-taken", name=name)
        raise CustomBlockError(name, [Diagnostic("name-taken", message)])


def _read(path: Path, others: Mapping[str, Phrase]) -> CustomBlock:
    name = path.stem
    try:
        source, configuration = skill_files.read(path), _chosen(_configuration(path))
    except (LearnBlockError, OSError) as error:
        return _unreadable(name, error)
    checked = check(source, configuration, name=name, replaces=name, others=others)
    category = checked.blocks[0].category if checked.blocks else category_of(name)
    return CustomBlock(
        name, source, configuration, skill_files.names(path), category, checked.problems
    )


def _unreadable(name: str, error: Exception) -> CustomBlock:
    diagnostics = error.diagnostics if isinstance(error, FileError) else ()
    reason = error.phrase if isinstance(error, LearnBlockError) else Phrase(str(error))
    unreadable = Diagnostic("unreadable", Phrase("custom-unreadable", reason=reason))
    problems = tuple(Problem("source", diagnostic) for diagnostic in diagnostics or (unreadable,))
    return CustomBlock(name, "", "", (), category_of(name), problems)


def _chosen(path: Path) -> str:
    return skill_files.read(path) if path.is_file() else ""


def _write(name: str, source: str, configuration: str) -> None:
    path = _source(name)
    # A configuration of functions that do not exist yet does no harm, so it is written first.
    save_file(_configuration(path), configuration.encode())
    save_file(path, (source.replace("\r\n", "\n").rstrip("\n") + "\n").encode())


def _remove(source: Path) -> None:
    source.unlink()
    _configuration(source).unlink(missing_ok=True)


def _move(source: Path, to: Callable[[Path], Path]) -> None:
    for path in (_configuration(source), source):
        target = to(path)
        target.parent.mkdir(parents=True, exist_ok=True)
        if path.is_file():
            path.replace(target)
        else:
            target.unlink(missing_ok=True)
