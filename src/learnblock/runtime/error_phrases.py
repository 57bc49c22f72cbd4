"""The errors of programs as phrases that can cross the link."""

import builtins
import dis
from collections.abc import Iterable
from types import TracebackType
from typing import overload

from learnblock.errors import LearnBlockError, nearest
from learnblock.i18n import Phrase, Value
from learnblock.runtime.claims import is_of_program
from learnblock.runtime.explanations import explanation
from learnblock.runtime.failed_code import UNKNOWN, FailedCode
from learnblock.runtime.values import encodable, shortened

#: The maximum length of a string in a phrase; longer ones are cut.
LONGEST_ERROR = 2000
#: Larger whole numbers do not fit into a message.
LARGEST_NUMBER = 2**63 - 1


def phrase_of(error: BaseException, failed: FailedCode = UNKNOWN) -> Phrase:
    """The phrase for an error: ours can be translated, Python's keep Python's text.

    Args:
        error: as it was raised.
        failed: the code of the program that raised it.
    """
    if isinstance(error, LearnBlockError):
        phrase = _sendable(error.phrase)
        # A program may raise our errors with words that we lack.
        return (
            phrase if is_of_program(phrase) else Phrase(_text(f"{type(error).__name__}: {error}"))
        )
    if isinstance(error, PermissionError) and isinstance(error.filename, str):
        return _sendable(Phrase("run-no-access", file=error.filename))
    kind = type(error).__name__
    try:
        # A syntax error's whole text would repeat the file and the line.
        text = str(error.msg if isinstance(error, SyntaxError) else error)
    except Exception as raised:  # noqa: BLE001 - a pupil's __str__ may raise any exception
        failure = type(raised).__name__
        return _sendable(Phrase("run-error-without-text", type=kind, failed=failure))
    whole = f"{kind}: {text}" if text else kind
    return _sendable(_explained(error, text, whole, failed))


def _explained(error: BaseException, text: str, whole: str, failed: FailedCode) -> Phrase:
    """Our words for an error with Python's text below them; only Python's if we have none."""
    meaning = _suggestion(error, failed)
    if meaning is None and isinstance(error, Exception):
        meaning = explanation(error, text, failed)
    return Phrase(whole) if meaning is None else Phrase("run-means", meaning=meaning, error=whole)


def _suggestion(error: BaseException, failed: FailedCode) -> Phrase | None:
    """The known name that is most similar to the unknown one in an error."""
    if not isinstance(error, NameError | AttributeError) or not isinstance(error.name, str):
        return None
    if isinstance(error, NameError):
        if failed.sets(error.name):
            # It is not misspelled: the line that sets it has not run.
            return None
        return _name_suggestion(error.name, _last(error.__traceback__))
    return _near("run-means-attribute-near", error.name, dir(error.obj))


def _name_suggestion(name: str, raised: TracebackType | None) -> Phrase | None:
    from learnblock.blocks.source.importable import missing_import  # noqa: PLC0415 - rarely needed

    if raised is None:
        return None
    if missing := missing_import(name, before_dot=_is_before_dot(raised)):
        return missing
    frame, code = raised.tb_frame, "run-means-name-near"
    visible = {*vars(builtins), *frame.f_globals, *frame.f_locals}
    # A name that is only a little like True, False, None or an error means something else.
    likely = [
        candidate
        for candidate in visible
        if candidate[0].islower() or candidate not in vars(builtins)
    ]
    return _near(code, name, visible, likeness=0.8) or _near(code, name, likely)


def _near(code: str, name: str, names: Iterable[str], *, likeness: float = 0.6) -> Phrase | None:
    public = [candidate for candidate in names if not candidate.startswith("_")]
    near = nearest(name, public, likeness=likeness)
    return None if near is None else Phrase(code, name=name, near=near)


def _last(step: TracebackType | None) -> TracebackType | None:
    """Where an error was raised."""
    while step and step.tb_next:
        step = step.tb_next
    return step


def _is_before_dot(raised: TracebackType) -> bool:
    """Whether a name is missing that is used as a module, as in ``time.sleep(1)``."""
    following = (
        instruction
        for instruction in dis.get_instructions(raised.tb_frame.f_code)
        if instruction.offset > raised.tb_lasti
    )
    instruction = next(following, None)
    return instruction is not None and instruction.opname in {"LOAD_ATTR", "LOAD_METHOD"}


def _sendable(phrase: Phrase) -> Phrase:
    """A phrase without strings that are too long or that cannot be encoded."""
    values = {name: _sendable_value(value) for name, value in phrase.values.items()}
    return Phrase(_text(phrase.code), **values)


@overload
def _sendable_value(value: str | Phrase) -> str | Phrase: ...
@overload
def _sendable_value(value: Value) -> Value: ...
def _sendable_value(value: Value) -> Value:
    if isinstance(value, Phrase):
        return _sendable(value)
    if isinstance(value, tuple):
        return tuple(_sendable_value(part) for part in value)
    if isinstance(value, int) and abs(value) > LARGEST_NUMBER:
        return str(value)
    return _text(value) if isinstance(value, str) else value


def _text(text: str) -> str:
    return shortened(encodable(text), LONGEST_ERROR)
