"""The check of a block before it is accepted; nothing of it is run."""

from collections.abc import Iterable, Iterator, Mapping

from learnblock.blocks.configuration import BlockConfiguration
from learnblock.blocks.signature import Signature, signatures
from learnblock.errors import Diagnostic, OwnBlockError, ProgramError
from learnblock.own_blocks import chosen as choices
from learnblock.own_blocks.clashes import taken_names
from learnblock.own_blocks.own_block import Checked, Part, Problem, checked_name
from learnblock.own_blocks.source_check import wrong_source


def check(
    source: str,
    configuration: str = "",
    *,
    name: str = "",
    replaces: str = "",
    others: Mapping[str, str] | None = None,
) -> Checked:
    """What is wrong with a block, and how it would be.

    Args:
        source: the Python of its functions.
        configuration: what is chosen for them, as JSON; empty for nothing.
        name: that it is to be saved under; empty where it has none yet.
        replaces: the name that it is saved under, if it is.
        others: names that are taken, as of `others_names`; None to ask for them.
    """
    filename = f"{name or 'block'}.py"
    taken = taken_names(but=replaces, others=others)
    problems = [
        *_problems("name", _wrong_name(name, replaces)),
        *_problems("source", wrong_source(source, filename, taken)),
    ]
    chosen, wrong = choices.read(configuration)
    problems += _problems("configuration", wrong)
    try:
        found = signatures(source, filename)
    except ProgramError:
        # The source's problems say why.
        return Checked(tuple(problems), chosen=configuration)
    if not name and found:
        # The page calls a new file after its first function.
        filename = f"{found[0].name}.py"
    followed = {one.name: one for one in choices.followed(chosen, found)}
    stale = choices.out_of_date(followed, {one.name: one for one in found})
    blocks = choices.complete(found, followed, filename)
    problems += _problems("configuration", (_warning(sentence) for sentence in stale))
    problems += _problems("configuration", _wrong_defaults(blocks, found))
    return Checked(tuple(problems), blocks, choices.apart(blocks, found))


def _wrong_defaults(
    blocks: Iterable[BlockConfiguration], found: Iterable[Signature]
) -> Iterator[Diagnostic]:
    """Defaults outside of what was chosen; where a hint says what fits, the source is told."""
    for block, signature in zip(blocks, found, strict=True):
        for one, argument in zip(block.parameters, signature.arguments, strict=True):
            by_hint = one.type == argument.field.type and one.range == argument.field.range
            if by_hint or one.default is None or not (why := one.objection(one.default)):
                continue
            yield Diagnostic(
                "bad-default",
                f"`{one.name}` of `{block.name}`: the default is {one.default!r:.40}, but {why}",
            )


def _wrong_name(name: str, replaces: str) -> Iterable[Diagnostic]:
    if not name or name == replaces:
        return ()
    try:
        checked_name(name)
    except OwnBlockError as error:
        return error.diagnostics
    return ()


def _problems(part: Part, diagnostics: Iterable[Diagnostic]) -> list[Problem]:
    return [Problem(part, one) for one in diagnostics]


def _warning(sentence: str) -> Diagnostic:
    return Diagnostic("stale-configuration", sentence, severity="warning")
