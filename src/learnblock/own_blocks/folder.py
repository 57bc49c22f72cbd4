"""The user's own blocks where they are kept: ``skills/NAME.py`` and ``blocks/NAME.json`` of `home`.

What is deleted goes into a folder ``deleted`` beside them, where the last of each name is kept.
"""

from collections.abc import Callable, Mapping
from pathlib import Path

from learnblock import skill_files
from learnblock.blocks.derivation import category_of
from learnblock.errors import (
    Diagnostic,
    FileError,
    LearnBlockError,
    OwnBlockError,
    UnknownNameError,
)
from learnblock.files import save as save_file
from learnblock.home import home
from learnblock.own_blocks import copying, package
from learnblock.own_blocks.checking import check
from learnblock.own_blocks.clashes import others_names, taken_names
from learnblock.own_blocks.own_block import Checked, OwnBlock, Problem, checked_name
from learnblock.own_blocks.package import Package


def own_blocks() -> tuple[OwnBlock, ...]:
    """All of them, in the order of their names, also those that are wrong."""
    others = others_names()
    return tuple(_read(path, others) for path in skill_files.own_files())


def find(name: str) -> OwnBlock:
    """One of them.

    Raises:
        UnknownNameError: there is none of that name.
    """
    return _read(_existing(name), others_names())


def save(name: str, source: str, configuration: str = "", *, replaces: str = "") -> Checked:
    """Save a block, unless the check finds errors in it.

    Args:
        name: of its files.
        source: the Python of its functions.
        configuration: what is chosen for them, as JSON.
        replaces: the name that it had until now, which may be the same; empty for a new one.

    Raises:
        OwnBlockError: it cannot be called so, or another one is called so already.
        UnknownNameError: there is none that it could replace.
        OSError: it cannot be written; what was there is as it was.
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


def duplicate(name: str, new: str) -> OwnBlock:
    """Copy a block; its functions get names that are free.

    Raises:
        OwnBlockError: the copy cannot be called so, or what is copied is wrong.
        UnknownNameError: there is none of that name.
        ProgramError: its source is no Python.
        OSError: it cannot be written.
    """
    original = find(name)
    names = copying.new_names(original.functions, new, taken_names())
    source = copying.renamed_source(original.source, names)
    configuration = copying.renamed_configuration(original.configuration, names)
    save(new, source, configuration).require_no_errors(new)
    return find(checked_name(new))


def delete(name: str) -> None:
    """Put a block aside.

    Raises:
        UnknownNameError: there is none of that name.
        OSError: it cannot be moved.
    """
    _move(_existing(name), _deleted)


def restore(name: str) -> OwnBlock:
    """Take back the deleting of a block.

    Raises:
        UnknownNameError: none of that name was deleted.
        OwnBlockError: there is another one of that name now.
        OSError: it cannot be moved.
    """
    deleted = _deleted(_source(name))
    if deleted not in deleted.parent.glob("*.py"):
        raise UnknownNameError("deleted block", name, _names(deleted.parent))
    _refuse_taken(name, None)
    _move(deleted, lambda path: path.parents[1] / path.name)
    return find(name)


def export(name: str) -> tuple[str, str]:
    """The name and the text of a file with a block.

    Raises:
        UnknownNameError: there is none of that name.
        BlockConfigurationError: its configuration is wrong.
    """
    block = find(name)
    packed = package.pack(Package(block.name, block.source, block.configuration))
    return block.name + package.ENDING, packed


def import_file(text: str, *, replace: bool = False) -> OwnBlock:
    """Add the block in a file that was exported.

    Args:
        text: of the file.
        replace: the block of the same name, if there is one.

    Raises:
        OwnBlockError: it is no such file, it is wrong, or its name is taken.
        OSError: it cannot be written.
    """
    found = package.unpack(text)
    replaces = found.name if replace and found.name in _names(_folder()) else ""
    checked = save(found.name, found.source, found.configuration, replaces=replaces)
    checked.require_no_errors(found.name)
    return find(found.name)


# Files.


def _folder() -> Path:
    return home() / "skills"


def _source(name: str) -> Path:
    return _folder() / f"{name}.py"


def _configuration(source: Path) -> Path:
    """The file of what is chosen, by that of the source."""
    skills = _folder()
    return home() / "blocks" / source.relative_to(skills).with_suffix(".json")


def _deleted(path: Path) -> Path:
    return path.parent / "deleted" / path.name


def _names(folder: Path) -> tuple[str, ...]:
    return tuple(sorted(path.stem for path in folder.glob("*.py") if path.is_file()))


def _existing(name: str) -> Path:
    """The source of a block that is there: a name never leads out of the folder."""
    known = _names(_folder())
    if name not in known:
        raise UnknownNameError("block of your own", name, known)
    return _source(name)


def _refuse_taken(name: str, old: Path | None) -> None:
    same = {path.casefold() for path in _names(_folder()) if old is None or path != old.stem}
    if name.casefold() in same:
        message = f"you have a block `{name}` already: choose another name, or replace that one"
        raise OwnBlockError(name, [Diagnostic("name-taken", message)])


def _read(path: Path, others: Mapping[str, str]) -> OwnBlock:
    name = path.stem
    try:
        source, configuration = skill_files.read(path), _chosen(_configuration(path))
    except (LearnBlockError, OSError) as error:
        return _unreadable(name, error)
    checked = check(source, configuration, name=name, replaces=name, others=others)
    category = checked.blocks[0].category if checked.blocks else category_of(name)
    return OwnBlock(
        name, source, configuration, skill_files.names(path), category, checked.problems
    )


def _unreadable(name: str, error: Exception) -> OwnBlock:
    found = error.diagnostics if isinstance(error, FileError) else ()
    told = found or (Diagnostic("unreadable", f"the file cannot be read: {error}"),)
    problems = tuple(Problem("source", one) for one in told)
    return OwnBlock(name, "", "", (), category_of(name), problems)


def _chosen(path: Path) -> str:
    return skill_files.read(path) if path.is_file() else ""


def _write(name: str, source: str, chosen: str) -> None:
    path = _source(name)
    # What is chosen for functions that are not there yet does no harm.
    save_file(_configuration(path), chosen.encode())
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
