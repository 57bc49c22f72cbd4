"""LearnBlock's errors, and the one format in which it reports mistakes in files.

Each exception belongs to the family `LearnBlockError` and to a builtin exception, so that both
`except LearnBlockError` and `except ValueError` catch it.
"""

import difflib
import errno
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

from learnblock.i18n import Phrase, Value

Severity = Literal["error", "warning"]

#: The most mistakes that a file's phrase describes; its diagnostics have all of them.
_MOST_IN_SUMMARY = 20
#: What the system lacks, by the number of its error.
_SHORTAGES = {
    errno.ENOSPC: "system-disk",
    errno.EDQUOT: "system-quota",
    errno.ENOMEM: "system-memory",
    errno.EAGAIN: "system-threads",
    errno.EMFILE: "system-files",
    errno.ENFILE: "system-files",
}


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """A mistake in a user's file, and what to do about it.

    Args:
        code: a short stable name for scripts and tests, such as ``missing-colon``.
        message: what is wrong and what to do.
        line: 1 for the first line; 0 for the whole file.
        column: 1 for the first character of the line; 0 for the whole line.
        end_column: the column after the last character of the mistake; 0 if unknown.
        severity: an ``error`` keeps the program from running, a ``warning`` does not.
    """

    code: str
    message: Phrase
    line: int = 0
    column: int = 0
    end_column: int = 0
    severity: Severity = "error"

    def located(self, filename: str) -> str:
        """The format that editors and scripts read: ``FILE:LINE:COLUMN: code message``."""
        return f"{filename}:{self.line}:{self.column}: {self.code} {self.message}"

    def pointed(self, source: str) -> str:
        """Return its line of `source` with a caret below, or "" if it has no line."""
        # Not splitlines: to an editor a form feed begins no line.
        lines = [line.removesuffix("\r") for line in source.split("\n")]
        if not 1 <= self.line <= len(lines):
            return ""
        text = lines[self.line - 1]
        start = min(max(self.column, 1), len(text) + 1) - 1
        # A tab stays a tab under the text, so that the caret is below the right character.
        indent = "".join("\t" if character == "\t" else " " for character in text[:start])
        width = max(1, min(self.end_column - 1, len(text)) - start)
        return f"{text}\n{indent}{'^' * width}"


class LearnBlockError(Exception):
    """The base class of all LearnBlock errors.

    ``str(error)`` is the English text.

    Args:
        code: the code of the phrase, such as ``robot-no-answer``, or a whole sentence in a
            third-party robot or skill.
        values: the values of the phrase, by name.
    """

    def __init__(self, code: str = "", /, **values: Value) -> None:
        self.phrase = Phrase(code, **values)
        super().__init__(self.phrase)

    def __str__(self) -> str:
        return str(self.phrase)

    def __reduce__(self) -> tuple[object, ...]:
        return _error, (type(self), self.phrase)


class FileError(LearnBlockError, ValueError):
    """A user's file is invalid: the base class of the errors with diagnostics.

    ``str(error)`` has the format that scripts read, with the file name and codes; `phrase` has the
    sentences for a person, with their lines.

    Args:
        filename: the file name as the user gave it.
        diagnostics: at least one, in the order of the file.
        source: the file's text, for the caret; empty if there is none.
    """

    def __init__(self, filename: str, diagnostics: Iterable[Diagnostic], source: str = "") -> None:
        self.filename = filename
        self.diagnostics = tuple(diagnostics)
        self.source = source
        super().__init__()
        self.phrase = _summary(self.diagnostics)

    def __str__(self) -> str:
        return "\n".join(diagnostic.located(self.filename) for diagnostic in self.diagnostics)

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.filename, self.diagnostics, self.source)


class EscapeError(LearnBlockError, ValueError):
    """An escape sequence in a string does not name a character."""


class ProgramError(FileError):
    """A program in Block-Text or Python cannot be parsed or is not meaningful."""


class WorldError(FileError):
    """A world's description is invalid."""


class RobotDescriptionError(FileError):
    """A simulated robot's description is invalid."""


class BlockConfigurationError(FileError):
    """A block configuration is invalid."""


class CustomBlockError(FileError):
    """A custom block, its name or its exported file is invalid."""


class HintError(LearnBlockError, ValueError):
    """A type hint is not supported by any field of a block."""


class BlockSetError(FileError):
    """A block set or its name is invalid."""


class ProjectError(FileError):
    """A project's file or name is invalid, or it cannot be saved."""


class LessonError(FileError):
    """A lesson is invalid, or cannot be read."""


class LibraryError(FileError):
    """A library is invalid, or a function for a new one is."""


class SettingsError(FileError):
    """A robot setting is invalid."""


class UnknownNameError(LearnBlockError, LookupError):
    """No robot, world, skill or example has this name.

    Args:
        kind: what was looked up, by its short name in ``unknown.ftl``: ``robot``, ``block-set``.
        name: the unknown name.
        known: the names that exist.
    """

    def __init__(self, kind: str, name: str, known: Iterable[str]) -> None:
        self.kind, self.name, self.known = kind, name, tuple(known)
        suggestion = nearest(name, self.known)
        if suggestion is not None:
            super().__init__("unknown-name-like", kind=kind, name=name, suggestion=suggestion)
        elif self.known:
            super().__init__("unknown-name-of", kind=kind, name=name, known=self.known)
        else:
            super().__init__("unknown-name", kind=kind, name=name)

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.kind, self.name, self.known)


class NewNameError(LearnBlockError, ValueError):
    """A new robot, skill or world cannot have this name."""


class FileTakenError(LearnBlockError, FileExistsError):
    """A new file would replace an existing one."""


class KeyTakenError(LearnBlockError, ValueError):
    """A robot already has a device of this type under this key."""


class DeviceValueError(LearnBlockError, ValueError):
    """A device was given a value that no device of its type can take."""


class TagNamesError(FileError):
    """The tag names are invalid."""


class TagSizeError(LearnBlockError, ValueError):
    """The size of a tag, or the focal length of a lens, has to be positive."""


class FrameError(LearnBlockError, ValueError):
    """A detector was given something that is not a picture."""


class PictureError(LearnBlockError, ValueError):
    """A component received something that is not a picture."""


class WeightsMissingError(LearnBlockError, FileNotFoundError):
    """The weights of the emotion detector were not built when LearnBlock was installed."""


class TagNumberError(LearnBlockError, ValueError):
    """No AprilTag has this number."""


class RobotConnectionError(LearnBlockError, ConnectionError):
    """The robot cannot be reached, or the link to it broke."""


class RobotNotFoundError(RobotConnectionError):
    """Nothing usable answers at the robot's address; another connection may work."""


class RobotBusyError(RobotConnectionError):
    """The robot is in use by another program."""


class EmulatorError(LearnBlockError, OSError):
    """An emulator, or a program that it needs, did not start."""


class SceneCallError(RobotConnectionError):
    """CoppeliaSim refused to run a function."""


class IceError(RobotConnectionError):
    """The family of errors of components that use the Ice protocol."""


class IceEncodingError(IceError, ValueError):
    """A value or the received bytes do not have the type that the interface declares."""


class IceLinkError(IceError):
    """A component cannot be reached, does not answer in time, or the link to it broke."""


class IceRefusedError(IceError):
    """A component refused a call.

    Args:
        code: the code of the words, or the component's own message.
        kind: the name of Ice's exception, such as ``OperationNotExistException``.
        values: the values inserted into the words.
    """

    def __init__(self, code: str, /, kind: str, **values: Value) -> None:
        self.kind = kind
        super().__init__(code, **values)

    def __reduce__(self) -> tuple[object, ...]:
        return _refused_error, (self.phrase, self.kind)


class NotWrittenError(LearnBlockError, NotImplementedError):
    """The author of a robot has not yet written a function that its devices need."""


class MissingPackageError(LearnBlockError, ImportError):
    """The library that a robot needs is not installed."""


class RobotStoppedError(LearnBlockError, RuntimeError):
    """The robot was used after it had been stopped and disconnected."""


class RobotAttributeError(LearnBlockError, AttributeError):
    """The robot has no skill with this name."""


class MissingDeviceError(LearnBlockError, LookupError):
    """A program asked for a sense or a device that the robot does not have."""


class InputEndedError(LearnBlockError, EOFError):
    """A program asked for a line of input, but there is none."""


class ForbiddenError(LearnBlockError, PermissionError):
    """A program tried something that robot programs must not do."""


class StillTurningError(LearnBlockError, TimeoutError):
    """A turn did not reach its angle within its time limit."""


class StillDrivingError(LearnBlockError, TimeoutError):
    """A robot did not drive its distance within its time limit."""


class ProgramStopped(BaseException):
    """The program is being stopped from outside: by the user, a time limit or a signal.

    It derives from BaseException, as KeyboardInterrupt does, so that a pupil's ``except Exception``
    cannot swallow it.
    """


def shortage(error: BaseException) -> Phrase | None:
    """What the computer lacks, if an error of the system says so: memory, threads or space."""
    if isinstance(error, MemoryError):
        return Phrase("system-memory")
    if isinstance(error, OSError):
        code = _SHORTAGES.get(error.errno or 0)
        return Phrase(code) if code else None
    # The text of CPython; it has no exception of its own.
    return Phrase("system-threads") if str(error) == "can't start new thread" else None


def phrase_of(error: Exception) -> Phrase:
    """The phrase of an error; of another library's exception, what is missing or its text."""
    if isinstance(error, LearnBlockError):
        return error.phrase
    return shortage(error) or Phrase(str(error) or type(error).__name__)


def _summary(diagnostics: Sequence[Diagnostic]) -> Phrase:
    """Combine the first mistakes in a file into one phrase, which says how many more there are.

    Each sentence is nested in the one before, so thousands of them would be too deep to encode.
    """
    sentences = list(map(_at_line, diagnostics[:_MOST_IN_SUMMARY]))
    if remaining := len(diagnostics) - len(sentences):
        sentences.append(Phrase("file-more-mistakes", count=remaining))
    summary = sentences.pop() if sentences else Phrase("")
    for sentence in reversed(sentences):
        summary = Phrase("file-mistakes", first=sentence, rest=summary)
    return summary


def _at_line(diagnostic: Diagnostic) -> Phrase:
    if diagnostic.line:
        line, problem = str(diagnostic.line), diagnostic.message
        return Phrase("file-at-line", line=line, problem=problem)
    return diagnostic.message


def _error(kind: type[LearnBlockError], phrase: Phrase) -> LearnBlockError:
    """Recreate an error from its pickled or sent values."""
    return kind(phrase.code, **phrase.values)


def _refused_error(phrase: Phrase, kind: str) -> IceRefusedError:
    """Recreate an error from its pickled values."""
    return IceRefusedError(phrase.code, kind=kind, **phrase.values)


def nearest(name: str, candidates: Iterable[str], *, likeness: float = 0.6) -> str | None:
    """The most similar of the known names, or None if none is similar; case does not matter.

    Args:
        name: the unknown name.
        candidates: the known ones.
        likeness: how similar they have to be, from 0 to 1.
    """
    folded = {candidate.casefold(): candidate for candidate in candidates}
    near = difflib.get_close_matches(name.casefold(), folded, n=1, cutoff=likeness)
    return folded[near[0]] if near else None
