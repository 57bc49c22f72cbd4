"""The check of a custom block and its names before it is saved; none of its code is run."""

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress

from learnblock.blocks import BlockConfiguration, builtin
from learnblock.blocks.installed_libraries import installed_blocks
from learnblock.blocks.reserved import RESERVED
from learnblock.blocks.source.derivation import derive_plugin
from learnblock.blocks.source.signature import Signature, signatures
from learnblock.errors import CustomBlockError, Diagnostic, LearnBlockError, ProgramError
from learnblock.extensions.custom_blocks import chosen as choices
from learnblock.extensions.custom_blocks.custom_block import Checked, Part, Problem, checked_name
from learnblock.extensions.custom_blocks.source_check import bad_default, wrong_source
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
        block.name: Phrase("custom-taken-by-library", name=block.name, library=block.library)
        for block in installed_blocks()
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


def check(
    source: str,
    configuration: str = "",
    *,
    name: str = "",
    replaces: str = "",
    others: Mapping[str, Phrase] | None = None,
) -> Checked:
    """Check a custom block.

    Args:
        source: the Python of its functions.
        configuration: the configuration of its blocks, as JSON; empty for the defaults.
        name: the name to save it under; empty if it has none yet.
        replaces: the name it is saved under now, if any.
        others: the result of `others_names`, if it is already known.
    """
    filename = f"{name or 'block'}.py"
    taken = taken_names(but=replaces, others=others)
    problems = [
        *_problems("name", _wrong_name(name, replaces)),
        *_problems("source", wrong_source(source, filename, taken)),
    ]
    configurations, wrong = choices.read(configuration)
    problems += _problems("configuration", wrong)
    try:
        functions = signatures(source, filename)
    except ProgramError:
        # This is already among the problems of the source.
        return Checked(tuple(problems), chosen=configuration)
    if not name and functions:
        # The page calls a new file after its first function.
        filename = f"{functions[0].name}.py"
    followed = {block.name: block for block in choices.followed(configurations, functions)}
    stale = choices.out_of_date(followed, {block.name: block for block in functions})
    blocks = choices.complete(functions, followed, filename)
    problems += _problems("configuration", map(_warning, stale))
    problems += _problems("configuration", _wrong_defaults(blocks, functions))
    return Checked(tuple(problems), blocks, choices.apart(blocks, functions))


def _wrong_defaults(
    blocks: Iterable[BlockConfiguration], functions: Iterable[Signature]
) -> Iterator[Diagnostic]:
    """Report defaults that the configuration does not allow."""
    for block, signature in zip(blocks, functions, strict=True):
        for parameter, argument in zip(block.parameters, signature.arguments, strict=True):
            by_hint = (
                parameter.type == argument.field.type and parameter.range == argument.field.range
            )
            if (
                by_hint
                or parameter.default is None
                or not (why := parameter.objection(parameter.default))
            ):
                continue
            message = bad_default(parameter.name, block.name, parameter.default, why)
            yield Diagnostic("bad-default", message)


def _wrong_name(name: str, replaces: str) -> Iterable[Diagnostic]:
    if not name or name == replaces:
        return ()
    try:
        checked_name(name)
    except CustomBlockError as error:
        return error.diagnostics
    return ()


def _problems(part: Part, diagnostics: Iterable[Diagnostic]) -> list[Problem]:
    return [Problem(part, diagnostic) for diagnostic in diagnostics]


def _warning(message: Phrase) -> Diagnostic:
    return Diagnostic("stale-configuration", message, severity="warning")
