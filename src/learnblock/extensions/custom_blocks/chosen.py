"""The configuration of custom blocks: merged with their source, and separated from it."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from learnblock.blocks import BlockConfiguration, Parameter, load_configurations
from learnblock.blocks.schema.writing import written
from learnblock.blocks.source.derivation import derived, fitted, may_be
from learnblock.blocks.source.hints import FieldType
from learnblock.blocks.source.signature import Signature
from learnblock.errors import BlockConfigurationError, Diagnostic
from learnblock.i18n import Phrase


def read(text: str) -> tuple[tuple[BlockConfiguration, ...], tuple[Diagnostic, ...]]:
    """The configurations in a string, or its mistakes; an empty string has no configurations."""
    if not text.strip():
        return (), ()
    try:
        return load_configurations(text), ()
    except BlockConfigurationError as error:
        return (), error.diagnostics


def followed(
    configurations: Iterable[BlockConfiguration], signatures: Iterable[Signature]
) -> tuple[BlockConfiguration, ...]:
    """The configurations; if a function was renamed, its configuration is too.

    If just one function and one configuration do not match any other, the function was renamed: it
    keeps its colour and its words in other languages.
    """
    blocks, names = list(configurations), [signature.name for signature in signatures]
    without_function = [block for block in blocks if block.name not in names]
    block_names = {block.name for block in blocks}
    without_choice = [name for name in names if name not in block_names]
    if len(without_function) != 1 or len(without_choice) != 1:
        return tuple(blocks)
    (old,), (new,) = without_function, without_choice
    # The English label is most likely the function's old name in words.
    words = {code: text for code, text in old.languages.items() if code != "EN"}
    renamed = replace(old, name=new, languages=words)
    return tuple(renamed if block is old else block for block in blocks)


def complete(
    signatures: Iterable[Signature], configurations: Mapping[str, BlockConfiguration], filename: str
) -> tuple[BlockConfiguration, ...]:
    """The blocks of a file, from its source and their configurations."""
    return tuple(
        fitted(configurations[signature.name], signature, derived(signature, filename))
        if signature.name in configurations
        else derived(signature, filename)
        for signature in signatures
    )


def apart(blocks: Iterable[BlockConfiguration], signatures: Iterable[Signature]) -> str:
    """The configuration to save: without the words that are already in the source.

    Otherwise, a later change to a docstring would never be shown.
    """
    pairs = zip(blocks, signatures, strict=True)
    return written(_without(block, derived(signature, "")) for block, signature in pairs)


def _without(block: BlockConfiguration, default: BlockConfiguration) -> BlockConfiguration:
    pairs = zip(block.parameters, default.parameters, strict=True)
    return replace(
        block,
        languages=_differing(block.languages, default.languages),
        tooltip=_differing(block.tooltip, default.tooltip),
        parameters=tuple(
            replace(block, translations=_differing(block.translations, other.translations))
            for block, other in pairs
        ),
    )


def _differing(texts: Mapping[str, str], defaults: Mapping[str, str]) -> dict[str, str]:
    return {code: text for code, text in texts.items() if defaults.get(code) != text}


def out_of_date(
    configurations: Mapping[str, BlockConfiguration], signatures: Mapping[str, Signature]
) -> Iterator[Phrase]:
    """The parts of configurations that contradict their functions, with a message for each."""
    for name, block in configurations.items():
        if name not in signatures:
            yield Phrase("custom-stale-function", name=name)
        else:
            yield from _differences(block, signatures[name])


def _differences(block: BlockConfiguration, signature: Signature) -> Iterator[Phrase]:
    arguments = {argument.name: argument for argument in signature.arguments}
    for parameter in block.parameters:
        argument = arguments.get(parameter.name)
        if argument is None:
            yield Phrase("custom-stale-parameter", block=block.name, parameter=parameter.name)
        elif not may_be(argument, _field(parameter)):
            yield Phrase(
                "custom-stale-type",
                block=block.name,
                parameter=parameter.name,
                actual=_described(argument.field),
                chosen=_described(_field(parameter)),
            )
    if signature.is_said and block.returns_value != signature.answers:
        kind = "value" if signature.answers else "statement"
        yield Phrase("custom-stale-shape", block=block.name, kind=kind)


def _field(parameter: Parameter) -> FieldType:
    return FieldType(parameter.type, parameter.range, parameter.choices)


def _described(field: FieldType) -> Phrase:
    if field.range is None:
        return Phrase("block-type", type=field.type)
    least, most = field.range.least, field.range.most
    return Phrase("block-type-with-range", type=field.type, least=least, most=most)
