"""Library blocks, read from the libraries' files without running any code."""

import ast
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from learnblock.blocks.importable import Importable
from learnblock.blocks.schema.configuration import BlockConfiguration
from learnblock.blocks.schema.loading import builtin, load_configurations
from learnblock.blocks.source.derivation import derived, fitted
from learnblock.blocks.source.signature import Signature, signatures
from learnblock.blocks.source.uses import UsedNames, imported_names, uses_of, with_needs
from learnblock.errors import LearnBlockError, LibraryError
from learnblock.storage import skill_files, toml_source
from learnblock.storage.home import home

#: A folder that contains this file is a library.
MANIFEST = "library.toml"
#: The configurations of a library's blocks.
CONFIGURATIONS = "blocks.json"


def installed() -> Mapping[str, Path]:
    """The folders of the libraries that are installed in `home`, by name."""
    return _in_folder(home() / "libraries")


def installed_blocks() -> Iterator[BlockConfiguration]:
    """The blocks of all installed libraries that can be read."""
    for name, folder in installed().items():
        try:
            yield from blocks(name, texts(folder))
        except (LearnBlockError, OSError):
            # `learnblock library list` reports the error; all other blocks keep working.
            continue


def importable(beside: Path | None = None, modules: frozenset[str] = frozenset()) -> Importable:
    """The modules that a program can import.

    Args:
        beside: the program's folder.
        modules: the modules that it imports; they may be in subfolders.
    """
    libraries = frozenset(installed())
    if beside is None:
        return Importable(libraries)
    files = {path.stem for path in beside.glob("*.py")}
    files |= {module for module in modules if _file(beside, module)}
    nearby = frozenset(_in_folder(beside))
    return Importable(libraries | nearby - files, frozenset(files - nearby))


def blocks_beside(folder: Path, modules: frozenset[str]) -> Iterator[BlockConfiguration]:
    """The blocks of the libraries and files that a program imports.

    Raises:
        LearnBlockError: one of them is invalid.
        OSError: one of them cannot be read.
    """
    nearby = _in_folder(folder)
    for module in sorted(modules):
        file = _file(folder, module)
        if file is not None:
            yield from blocks(module, {file.name: skill_files.read(file)})
        elif module in nearby:
            yield from blocks(module, texts(nearby[module]))


def functions_beside(
    folder: Path, imports: ast.Module, skills: Mapping[str, BlockConfiguration]
) -> dict[str, BlockConfiguration]:
    """The functions that a program imports from files next to it and that need something.

    Args:
        folder: the program's folder.
        imports: its imports.
        skills: the skills that the functions may call; they are not listed again.

    Returns:
        Their needs, by their names as the program writes them.

    Raises:
        LearnBlockError: one of the files is invalid.
        OSError: one of them cannot be read.
    """
    by_module: dict[str, dict[str, UsedNames]] = {}

    def defined(module: str) -> dict[str, UsedNames]:
        file = None if module in by_module else _file(folder, module)
        if file is not None:
            # Files may import each other.
            by_module[module] = {}
            tree = skill_files.parse(skill_files.read(file), file.name)
            imported = imported_names(tree, defined)
            by_module[module] = imported | uses_of(tree, imported)
        return by_module.get(module, {})

    needs = {name: uses.needed(skills) for name, uses in imported_names(imports, defined).items()}
    return {
        name: BlockConfiguration("others", "", name, needs=function_needs)
        for name, function_needs in needs.items()
        if function_needs and name not in skills
    }


def blocks(name: str, files: Mapping[str, str]) -> tuple[BlockConfiguration, ...]:
    """The blocks of a library, or of a Python file that is imported like one.

    Args:
        name: the name that programs import.
        files: the text of each file, by name.

    Raises:
        LearnBlockError: one of them is invalid.
    """
    titles = _titles(files.get(MANIFEST, ""))
    category = titles.get("EN") or name.replace("_", " ").capitalize()
    skills = {skill.name: skill for file, text in files.items() for skill in skills_in(file, text)}
    by_name = {
        name: replace(derived(skill, ""), category=category) for name, skill in skills.items()
    }
    for block in load_configurations(files[CONFIGURATIONS]) if CONFIGURATIONS in files else ():
        if block.name in by_name:
            by_name[block.name] = fitted(block, skills[block.name], by_name[block.name])
    uses = {name: skill.uses for name, skill in skills.items()}
    ready = with_needs(by_name.values(), uses, builtin())
    return tuple(replace(block, library=name, titles=titles) for block in ready)


def skills_in(filename: str, source: str) -> tuple[Signature, ...]:
    """The skills in a file that programs import; it may have other functions too.

    Raises:
        ProgramError: it is not valid Python.
    """
    if not filename.endswith(".py"):
        return ()
    return tuple(
        signature for signature in signatures(source, filename) if signature.robot == "robot"
    )


def texts(folder: Path) -> dict[str, str]:
    """The texts of a library's files, by name.

    Raises:
        LearnBlockError: one of them is too large.
        OSError: one of them cannot be read.
    """
    names = (MANIFEST, CONFIGURATIONS)
    files = [*sorted(folder.glob("*.py")), *filter(Path.is_file, map(folder.joinpath, names))]
    return {file.name: skill_files.read(file) for file in files}


def _in_folder(folder: Path) -> Mapping[str, Path]:
    manifests = sorted(folder.glob(f"*/{MANIFEST}"))
    return {path.parent.name: path.parent for path in manifests if path.parent.name.isidentifier()}


def _file(folder: Path, module: str) -> Path | None:
    """The Python file of a module, if there is one."""
    path = folder.joinpath(*module.split(".")).with_suffix(".py")
    return path if path.is_file() else None


def _titles(manifest: str) -> dict[str, str]:
    """The library's titles by upper-case language code; empty if the manifest is unreadable."""
    try:
        title = toml_source.parse(manifest, MANIFEST, LibraryError).get("title", {})
    except LibraryError:
        return {}
    pairs = title.items() if isinstance(title, dict) else ()
    return {str(code).upper(): text for code, text in pairs if isinstance(text, str) and text}
