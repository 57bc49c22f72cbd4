"""What was chosen for the blocks of a file: joined with what the source says, and apart from it."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from learnblock.blocks.configuration import BlockConfiguration, Parameter
from learnblock.blocks.derivation import derived, fitted, may_be
from learnblock.blocks.hints import FieldType
from learnblock.blocks.load import load_configurations
from learnblock.blocks.signature import Signature
from learnblock.blocks.written import written
from learnblock.errors import BlockConfigurationError, Diagnostic


def read(text: str) -> tuple[tuple[BlockConfiguration, ...], tuple[Diagnostic, ...]]:
    """The configurations in a text, or what is wrong with it; an empty text chooses nothing."""
    if not text.strip():
        return (), ()
    try:
        return load_configurations(text), ()
    except BlockConfigurationError as error:
        return (), error.diagnostics


def followed(
    chosen: Iterable[BlockConfiguration], signatures: Iterable[Signature]
) -> tuple[BlockConfiguration, ...]:
    """What was chosen, where the only function without a choice has the only choice without one.

    Whoever renames a function keeps its colour and its words in other languages.
    """
    blocks, names = list(chosen), [one.name for one in signatures]
    without_function = [one for one in blocks if one.name not in names]
    known = {one.name for one in blocks}
    without_choice = [name for name in names if name not in known]
    if len(without_function) != 1 or len(without_choice) != 1:
        return tuple(blocks)
    (old,), (new,) = without_function, without_choice
    # The English label is most likely but the function's name in words.
    words = {code: text for code, text in old.languages.items() if code != "EN"}
    renamed = replace(old, name=new, languages=words)
    return tuple(renamed if one is old else one for one in blocks)


def complete(
    signatures: Iterable[Signature], chosen: Mapping[str, BlockConfiguration], filename: str
) -> tuple[BlockConfiguration, ...]:
    """The blocks of a file: what its source says, and what was chosen."""
    return tuple(
        fitted(chosen[one.name], one, derived(one, filename))
        if one.name in chosen
        else derived(one, filename)
        for one in signatures
    )


def apart(blocks: Iterable[BlockConfiguration], signatures: Iterable[Signature]) -> str:
    """The text to save: blocks without the words that the source says by itself.

    A docstring that is changed later would else never be seen again.
    """
    pairs = zip(blocks, signatures, strict=True)
    return written(_without(block, derived(one, "")) for block, one in pairs)


def _without(block: BlockConfiguration, known: BlockConfiguration) -> BlockConfiguration:
    pairs = zip(block.parameters, known.parameters, strict=True)
    return replace(
        block,
        languages=_differing(block.languages, known.languages),
        tooltip=_differing(block.tooltip, known.tooltip),
        parameters=tuple(
            replace(one, translations=_differing(one.translations, other.translations))
            for one, other in pairs
        ),
    )


def _differing(texts: Mapping[str, str], known: Mapping[str, str]) -> dict[str, str]:
    return {code: text for code, text in texts.items() if known.get(code) != text}


def out_of_date(
    chosen: Mapping[str, BlockConfiguration], signatures: Mapping[str, Signature]
) -> Iterator[str]:
    """What a configuration says and the functions say otherwise, a sentence each."""
    for name, block in chosen.items():
        if name not in signatures:
            yield (
                f"the configuration describes `{name}`, and there is no such function: it is left"
                " out"
            )
        else:
            yield from _differences(block, signatures[name])


def _differences(block: BlockConfiguration, signature: Signature) -> Iterator[str]:
    arguments = {argument.name: argument for argument in signature.arguments}
    for one in block.parameters:
        argument = arguments.get(one.name)
        if argument is None:
            yield f"`{block.name}` has no parameter `{one.name}`: the configuration's is left out"
        elif not may_be(argument, _field(one)):
            yield (
                f"`{one.name}` of `{block.name}` is {_told(argument.field)} in the function and"
                f" {_told(_field(one))} in the configuration: the function counts"
            )
    if signature.is_said and block.returns_value != signature.answers:
        kind = "a value" if signature.answers else "a statement"
        yield f"`{block.name}` is {kind} by its function: the shape in the configuration is not"


def _field(parameter: Parameter) -> FieldType:
    return FieldType(parameter.type, parameter.range, parameter.choices)


def _told(field: FieldType) -> str:
    return f"{field.type} from {field.range}" if field.range else field.type
