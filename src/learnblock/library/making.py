"""Makes a library of functions of a program and of blocks of one's own."""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from learnblock import language, skill_files
from learnblock.blocks import BlockConfiguration, all_configurations, builtin
from learnblock.blocks.configuration import ParameterType
from learnblock.blocks.libraries import skills_in
from learnblock.blocks.written import written
from learnblock.errors import Diagnostic, LibraryError, UnknownNameError
from learnblock.language.extraction import extracted
from learnblock.language.nodes import (
    Call,
    Comment,
    Constant,
    Def,
    Expression,
    List,
    Program,
    SkillCall,
    String,
    expressions,
    statements,
    within,
)
from learnblock.library.contents import FUNCTIONS, Library, check, plain_lines, refuse_name
from learnblock.library.manifest import Manifest


def make(
    manifest: Manifest,
    program: Program,
    functions: Collection[str],
    own: Collection[str] = (),
    filename: str = FUNCTIONS,
) -> Library:
    """A library of functions of a program, with those that they call, and of blocks of one's own.

    Args:
        manifest: what it says of itself.
        program: in which the functions stand.
        functions: their names.
        own: names of blocks of one's own, or of the files in which they stand.
        filename: the program's, for errors.

    Raises:
        UnknownNameError: there is no such function or block.
        LibraryError: a function needs the rest of the program, or its name will not do.
    """
    text = extracted(program, functions, filename) if functions else ""
    for name, function in language.parse(text).functions.items():
        refuse_name(name, filename, program.functions[name].span.line or function.span.line)
    modules = dict(map(_module, _files(own)))
    library = Library(manifest, text, modules)
    check(library, filename)
    _refuse_foreign_skills(program, library, filename)
    return replace(library, configurations=written(_described(library, program)))


def own_skills() -> Mapping[str, tuple[str, ...]]:
    """The user's own blocks: the names of the skills in each file, by its name without ending."""
    return {path.stem: skill_files.names(path) for path in skill_files.own_files()}


def _files(own: Iterable[str]) -> list[Path]:
    paths = {path.stem: path for path in skill_files.own_files()}
    homes = {skill: stem for stem, skills in own_skills().items() for skill in skills}
    wanted: dict[str, Path] = {}
    for name in own:
        stem = name if name in paths else homes.get(name)
        if stem is None:
            raise UnknownNameError("block of your own", name, [*homes, *paths])
        wanted[stem] = paths[stem]
    return list(wanted.values())


def _module(path: Path) -> tuple[str, str]:
    """A file of the user's as a module: its skills take `robot`, since that is how one knows them.

    Raises:
        LibraryError: the first parameter of a skill is called otherwise.
        ProgramError: it is no Python.
    """
    source = plain_lines(skill_files.read(path))
    known = {one.name for one in skills_in(path.name, source)}
    for function in skill_files.functions(skill_files.parse(source, path.name)):
        if function.name not in known:
            message = f"in a library the first parameter of `{function.name}` is called `robot`"
            raise LibraryError(path.name, [Diagnostic("no-robot", message, function.lineno)])
    return f"{_module_name(path.stem)}.py", source


def _module_name(stem: str) -> str:
    """A name that every system can have, and that no file of ours in a library has."""
    plain = re.sub(r"[^a-z0-9_]", "_", stem.lower())[:50]
    return plain if plain[:1].isalpha() and plain != "functions" else f"block_{plain}"


def _refuse_foreign_skills(program: Program, library: Library, filename: str) -> None:
    """Refuse functions that use blocks which are neither ours nor in the library."""
    known = {**builtin(), **library.skills}
    taken = language.parse(library.functions).functions
    problems = [
        Diagnostic(
            "foreign-skill",
            f"`{name}` uses `function.{call.name}`, which is no part of the library: take that"
            " block along",
            call.span.line,
        )
        for name in taken
        for call in _skill_calls(program.functions[name])
        if call.name not in known
    ]
    if problems:
        raise LibraryError(filename, problems)


def _skill_calls(function: Def) -> Iterator[SkillCall]:
    for node in _expressions((function,)):
        if isinstance(node, SkillCall):
            yield node


# What is said of the blocks.


def _described(library: Library, program: Program) -> Iterator[BlockConfiguration]:
    """The blocks of the library, described as well as we know."""
    known = all_configurations()
    made = language.parse(library.functions).functions
    for name, block in library.skills.items():
        if name in made:
            yield _of_function(block, program)
        else:
            chosen = known.get(name, block)
            yield replace(chosen, category=block.category)


def _of_function(block: BlockConfiguration, program: Program) -> BlockConfiguration:
    """A function's block: its comment is the tooltip, and calls of it say what it is given."""
    types = _given(program, block.name)
    parameters = tuple(replace(one, type=types.get(one.name, one.type)) for one in block.parameters)
    comment = _comment(program, block.name)
    tooltip = {"EN": comment} if comment else block.tooltip
    return replace(block, type="control", parameters=parameters, tooltip=tooltip)


def _comment(program: Program, function: str) -> str:
    lines: list[str] = []
    for item in program.items:
        if isinstance(item, Comment):
            lines.append(item.text.strip())
        elif isinstance(item, Def) and item.name == function:
            return " ".join(lines)
        else:
            lines.clear()
    return ""


def _given(program: Program, function: str) -> dict[str, ParameterType]:
    """The types of what a program gives to a function, where that is written out."""
    names = program.functions[function].parameters
    main = program.main.body if program.main else ()
    found: dict[str, ParameterType] = {}
    for node in _expressions((*program.items, *main)):
        if isinstance(node, Call) and node.name == function:
            pairs = [*zip(names, node.arguments, strict=False)]
            pairs += [(one.name, one.value) for one in node.keywords]
            found.update((name, kind) for name, value in pairs if (kind := _type(value)))
    return found


def _type(value: Expression) -> ParameterType | None:
    match value:
        case String():
            return "string"
        case Constant(value=True | False):
            return "boolean"
        case List():
            return "list"
    return None


def _expressions(items: tuple[object, ...]) -> Iterator[Expression]:
    for statement in statements(items):  # type: ignore[arg-type] # items of the top level
        for expression in expressions(statement):
            yield from within(expression)
