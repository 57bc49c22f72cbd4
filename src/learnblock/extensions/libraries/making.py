"""Make a library from functions of a program and from custom blocks."""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from learnblock import language
from learnblock.blocks import BlockConfiguration, ParameterType, builtin
from learnblock.blocks.installed_libraries import skills_in
from learnblock.blocks.known import all_configurations
from learnblock.blocks.schema.writing import written
from learnblock.errors import Diagnostic, LibraryError, UnknownNameError
from learnblock.extensions.libraries.contents import (
    FUNCTIONS,
    Library,
    check,
    plain_lines,
    refuse_name,
)
from learnblock.extensions.libraries.manifest import Manifest
from learnblock.i18n import Phrase
from learnblock.language.edit.extraction import extracted
from learnblock.language.tree.nodes import (
    Call,
    Comment,
    Constant,
    Def,
    Expression,
    List,
    Program,
    SkillCall,
    String,
)
from learnblock.language.tree.traversal import expressions, statements, within
from learnblock.storage import skill_files


def make(
    manifest: Manifest,
    program: Program,
    functions: Collection[str],
    own: Collection[str] = (),
    filename: str = FUNCTIONS,
) -> Library:
    """Make a library from functions of a program, those that they call, and custom blocks.

    Args:
        manifest: the manifest of the library.
        program: the program with the functions.
        functions: their names.
        own: the names of custom blocks or of their files.
        filename: the file name of the program, for errors.

    Raises:
        UnknownNameError: there is no such function or block.
        LibraryError: a function needs the rest of the program, or has an invalid name.
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
    """The skills of the custom blocks, by their file's name without its suffix."""
    return {path.stem: skill_files.names(path) for path in skill_files.own_files()}


def _files(own: Iterable[str]) -> list[Path]:
    paths = {path.stem: path for path in skill_files.own_files()}
    homes = {skill: stem for stem, skills in own_skills().items() for skill in skills}
    selection: dict[str, Path] = {}
    for name in own:
        stem = name if name in paths else homes.get(name)
        if stem is None:
            raise UnknownNameError("block", name, [*homes, *paths])
        selection[stem] = paths[stem]
    return list(selection.values())


def _module(path: Path) -> tuple[str, str]:
    """A user's file as a module, in which skills are recognised by their parameter `robot`.

    Raises:
        LibraryError: the first parameter of a skill has another name.
        ProgramError: the file is not valid Python.
    """
    source = plain_lines(skill_files.read(path))
    skill_names = {skill.name for skill in skills_in(path.name, source)}
    for function in skill_files.functions(skill_files.parse(source, path.name)):
        if function.name not in skill_names:
            message = Phrase("library-first-parameter", function=function.name)
            raise LibraryError(path.name, [Diagnostic("no-robot", message, function.lineno)])
    return f"{_module_name(path.stem)}.py", source


def _module_name(stem: str) -> str:
    """A file name that is valid on every system and not used by LearnBlock."""
    plain = re.sub(r"[^a-z0-9_]", "_", stem.lower())[:50]
    return plain if plain[:1].isalpha() and plain != "functions" else f"block_{plain}"


def _refuse_foreign_skills(program: Program, library: Library, filename: str) -> None:
    """Refuse functions that use skills which are neither built in nor in the library."""
    available = {**builtin(), **library.skills}
    functions = language.parse(library.functions).functions
    problems = [
        Diagnostic(
            "foreign-skill",
            Phrase("library-foreign-skill", function=name, skill=call.name),
            call.span.line,
        )
        for name in functions
        for call in _skill_calls(program.functions[name])
        if call.name not in available
    ]
    if problems:
        raise LibraryError(filename, problems)


def _skill_calls(function: Def) -> Iterator[SkillCall]:
    for node in _expressions((function,)):
        if isinstance(node, SkillCall):
            yield node


# The configurations of the blocks.


def _described(library: Library, program: Program) -> Iterator[BlockConfiguration]:
    """The blocks of the library with everything known about them."""
    configurations = all_configurations()
    functions = language.parse(library.functions).functions
    for name, block in library.skills.items():
        if name in functions:
            yield _of_function(block, program)
        else:
            configuration = configurations.get(name, block)
            yield replace(configuration, category=block.category)


def _of_function(block: BlockConfiguration, program: Program) -> BlockConfiguration:
    """A function's block: its comment is the tooltip, and the calls to it determine the types."""
    types = _given(program, block.name)
    parameters = tuple(
        replace(parameter, type=types.get(parameter.name, parameter.type))
        for parameter in block.parameters
    )
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
    """The types of the literals that a program passes to a function."""
    names = program.functions[function].parameters
    main = program.main.body if program.main else ()
    types: dict[str, ParameterType] = {}
    for node in _expressions((*program.items, *main)):
        if isinstance(node, Call) and node.name == function:
            pairs = [*zip(names, node.arguments, strict=False)]
            pairs += [(keyword.name, keyword.value) for keyword in node.keywords]
            types.update((name, kind) for name, value in pairs if (kind := _type(value)))
    return types


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
